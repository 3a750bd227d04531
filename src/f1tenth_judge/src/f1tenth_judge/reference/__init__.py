"""The fastest lap that is possible."""
