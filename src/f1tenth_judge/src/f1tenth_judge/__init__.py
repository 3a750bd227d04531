"""The judge of the F1/10 car: scenarios, places, records, verdicts and reports, without ROS."""
