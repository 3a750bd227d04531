"""More than one run: side by side, repeated, or swept over values."""
