"""Goals files: for a lap of a circuit, or from clicks in rviz."""
