"""One run: start, watch, disturb, end."""
