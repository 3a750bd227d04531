"""What a scenario can put behind the wheel, and the race table."""
