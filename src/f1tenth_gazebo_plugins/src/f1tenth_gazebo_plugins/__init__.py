"""Judging contacts: the core of the node collision_detection."""
