"""Leagues: many planners at many places, ranked."""
