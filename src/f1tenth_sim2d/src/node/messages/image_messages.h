#pragma once

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

#include "core/components/camera/camera.h"

/// Messages of cameras, as gazebo_ros publishes them; whoever calls sets stamp and frame.
namespace f1tenth_sim2d
{
sensor_msgs::CameraInfo toCameraInfo(const Camera::Eye & eye);
/// In the format of the eye.
void fillImage(const Picture & picture, const Camera::Eye & eye, sensor_msgs::Image & image);
/// In metres as 32FC1, +inf where nothing is; or in millimetres as 16UC1, 0 where nothing is.
void fillDepth(const Picture & picture, const Camera::Eye & eye, sensor_msgs::Image & image);
/// As JPEG.
void fillJpeg(const Picture & picture, sensor_msgs::CompressedImage & image);
/// One point per pixel in the optical frame, z forwards, with its colour; not a number beyond the cutoffs of the eye.
void fillPoints(const Picture & picture, const Camera::Eye & eye, sensor_msgs::PointCloud2 & points);
}  // namespace f1tenth_sim2d
