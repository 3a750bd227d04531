"""What a run needs that knows no ROS: processes, and what their output and their commands tell."""
