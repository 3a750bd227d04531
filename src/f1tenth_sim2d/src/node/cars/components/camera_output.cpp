#include "node/cars/components/camera_output.h"

#include "node/world/warnings.h"

namespace f1tenth_sim2d
{
CameraOutput::CameraOutput(const CarHandle & car, const Camera & camera) : car_(car), camera_(camera)
{
  for (const Camera::Eye & eye : camera.eyes()) {
    eyes_.emplace_back(car, eye, car.frame(camera.mount().frame));
    if (!eye.trigger_topic.empty()) {
      ros::NodeHandle node = car.node;
      triggers_.push_back(node.subscribe<std_msgs::Empty>(
        eye.trigger_topic, 1, [this](const std_msgs::Empty::ConstPtr &) { is_triggered_ = true; }, ros::VoidConstPtr(),
        ros::TransportHints().tcpNoDelay()));
    }
  }
}

CameraOutput::Eye::Eye(const CarHandle & car, const Camera::Eye & given, const std::string & frame)
: eye(given),
  image(car, given.image_topic, frame),
  jpeg(car, given.image_topic.empty() ? "" : given.image_topic + "/compressed", frame),
  info(car, given.info_topic, frame),
  depth(car, given.depth_topic, frame),
  depth_info(car, given.depth_info_topic, frame),
  points(car, given.points_topic, frame)
{
  info.message = toCameraInfo(given);
  info.message.header.frame_id = frame;
  depth_info.message = info.message;
}

bool CameraOutput::Eye::needsPicture() const
{
  return image.isWanted() || jpeg.isWanted() || depth.isWanted() || points.isWanted();
}

void CameraOutput::update(SimTime now, bool /*anyway*/)
{
  if (!triggers_.empty() && !is_triggered_) {
    return;
  }
  is_triggered_ = false;
  look();
  for (Eye & eye : eyes_) {
    if (eye.is_looking) {
      publishPicture(eye, now);
    }
    for (auto * const info : {&eye.info, &eye.depth_info}) {
      if (info->isWanted()) {
        info->publish(now);
      }
    }
  }
}

void CameraOutput::look()
{
  std::vector<const Camera::Eye *> looking;
  std::vector<Picture *> pictures;
  for (Eye & eye : eyes_) {
    eye.is_looking = eye.needsPicture();
    if (eye.is_looking) {
      looking.push_back(&eye.eye);
      pictures.push_back(&eye.picture);
    }
  }
  if (looking.empty()) {
    return;
  }
  camera_.look(car_.simulation, car_.id, looking, pictures);
  if (!has_warned_) {
    has_warned_ = true;
    const std::string warning = car_.simulation.viewWarning();
    warnOnce(camera_.mount().name, warning.empty() ? std::vector<std::string>{} : std::vector{warning});
  }
}

void CameraOutput::publishPicture(Eye & eye, SimTime now)
{
  if (eye.image.isWanted()) {
    fillImage(eye.picture, eye.eye, eye.image.message);
    eye.image.publish(now);
  }
  if (eye.jpeg.isWanted()) {
    fillJpeg(eye.picture, eye.jpeg.message);
    eye.jpeg.publish(now);
  }
  if (eye.depth.isWanted()) {
    fillDepth(eye.picture, eye.eye, eye.depth.message);
    eye.depth.publish(now);
  }
  if (eye.points.isWanted()) {
    fillPoints(eye.picture, eye.eye, eye.points.message);
    eye.points.publish(now);
  }
}

void CameraOutput::repeat()
{
  for (const Eye & eye : eyes_) {
    eye.image.repeat();
    eye.jpeg.repeat();
    eye.info.repeat();
    eye.depth.repeat();
    eye.depth_info.repeat();
    eye.points.repeat();
  }
}
}  // namespace f1tenth_sim2d
