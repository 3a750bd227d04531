"""Cars that do not know where they are, and how soon amcl finds them."""
