"""Verdict, criteria, laps, contacts: pure functions of the record."""
