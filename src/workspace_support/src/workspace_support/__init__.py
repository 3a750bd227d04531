"""What the tests of the stand-ins have in common."""
