"""A car's race: start signal, goals in order, status."""
