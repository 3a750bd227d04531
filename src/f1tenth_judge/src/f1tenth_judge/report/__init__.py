"""One HTML file that shows all runs of a results folder, with a replay of each, without network or ROS."""
