"""One module a key, or a few keys that go together. All modules here are found by themselves."""
