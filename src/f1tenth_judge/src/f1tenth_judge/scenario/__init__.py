"""What a scenario file says: its schemas, values set from outside, the table of its keys."""
