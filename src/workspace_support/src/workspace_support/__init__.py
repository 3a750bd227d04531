"""What Python code of several packages has in common."""
