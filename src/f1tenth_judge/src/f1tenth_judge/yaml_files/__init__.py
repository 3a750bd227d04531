"""Files in YAML that are read by a schema, with FILE:LINE in every error; needs no ROS."""
