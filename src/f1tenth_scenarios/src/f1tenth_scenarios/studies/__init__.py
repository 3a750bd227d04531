"""Race pace, localization, passing: tables made from many runs."""
