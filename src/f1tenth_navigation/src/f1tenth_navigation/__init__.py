"""What the launch files of this package need besides XML."""
