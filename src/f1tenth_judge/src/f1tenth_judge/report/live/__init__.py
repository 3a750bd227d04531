"""A run watched in a browser while it goes on: a process beside it reads what is recorded, and serves it."""
