"""What is known of a run while it lasts and afterwards: the record, the replay."""
