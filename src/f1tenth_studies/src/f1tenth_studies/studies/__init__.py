"""The studies: values to sweep, columns, and what is good enough."""
