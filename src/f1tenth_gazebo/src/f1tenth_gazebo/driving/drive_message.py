"""What drivers answer a scan with."""

from ackermann_msgs.msg import AckermannDriveStamped


def drive_message(stamp, speed, steering_angle):
    """An AckermannDriveStamped of m/s and rad, left is positive."""
    message = AckermannDriveStamped()
    message.header.stamp = stamp
    message.drive.speed, message.drive.steering_angle = speed, steering_angle
    return message
