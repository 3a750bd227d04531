"""Suites that need more than f1tenth_judge: its command finds them by their entry points."""
