"""What a scenario file says: read, validated, documented; its plan ready to run."""
