"""Drives of the driver of `create_map.launch`, and how good the maps of them are."""
