"""What a scenario can put behind the wheel."""
