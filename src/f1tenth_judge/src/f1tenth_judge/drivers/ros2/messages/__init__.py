"""ROS 2's messages as DDS carries them, field by field in the order of their definitions.

A message `pkg/msg/Name` is called `pkg::msg::dds_::Name_` on DDS; units and frames are those of ROS.
"""
