"""Maps: made of a world's section, written, compared with what a car has made."""
