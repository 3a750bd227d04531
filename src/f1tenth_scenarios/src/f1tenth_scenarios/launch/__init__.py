"""Starting processes: launch file, private master, process trees."""
