"""Tables made from many runs."""
