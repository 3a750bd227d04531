"""Drives by the driver of `create_map.launch`, and how good their maps are."""
