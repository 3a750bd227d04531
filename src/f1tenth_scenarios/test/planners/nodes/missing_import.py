#!/usr/bin/env python3
"""A planner whose package is not installed here."""

import no_such_package  # noqa: F401
