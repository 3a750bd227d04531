"""Tables made from many runs: race pace, localization, passing."""
