"""The countdown to the start of a race."""
