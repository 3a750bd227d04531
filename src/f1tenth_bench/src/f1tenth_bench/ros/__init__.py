"""The simulator's node under a ROS master of its own, with other nodes around it."""
