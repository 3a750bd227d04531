#include "core/view/view.h"

#include "core/car/joint_state.h"

namespace f1tenth_sim2d
{
namespace
{
Transform onGround(const Pose2 & pose)
{
  const maths::SineCosine yaw = maths::sineCosine(pose.yaw);
  return {
    {Vec3{yaw.cosine, -yaw.sine, 0.0}, Vec3{yaw.sine, yaw.cosine, 0.0}, Vec3{0.0, 0.0, 1.0}}, {pose.x, pose.y, 0.0}};
}

/// @param angle  rad
Transform turned(const Hinge & hinge, double angle)
{
  const maths::SineCosine half = maths::sineCosine(0.5 * angle);
  const Eigen::Vector3d axis = half.sine * hinge.axis;
  Transform turn = toTransform({{}, Pose3::Rotation(half.cosine, axis.x(), axis.y(), axis.z())});
  const Vec3 place = toVec3(hinge.place);
  turn.offset = place - turn.turned(place);
  return turn;
}
}  // namespace

void View::draw(
  const Simulation & simulation, const std::shared_ptr<const WorldLook> & look, CarId car, const Pinhole & camera,
  const Pose3 & pose, Picture & picture)
{
  if (look_ != look) {
    look_ = look;
    scene_ = look->fixed();
  }
  scene_.surfaces.resize(look->fixed().surfaces.size());
  placeModels(simulation);
  for (const CarId each : simulation.cars()) {
    placeCar(simulation, each);
  }
  const Transform eye = onGround(simulation.state(car).pose) * toTransform(pose);
  renderer_.draw(scene_, look->shadowsOfFixed(), camera, eye, picture);
}

void View::placeModels(const Simulation & simulation)
{
  for (const WorldLook::Movable & movable : look_->movables()) {
    place(movable.surface, onGround(simulation.modelState(movable.model).pose) * movable.pose);
  }
}

void View::placeCar(const Simulation & simulation, CarId id)
{
  const CarDescription & car = simulation.car(id);
  const Transform body = onGround(simulation.state(id).pose);
  for (const Visual & visual : car.visuals) {
    Transform pose = body;
    for (const Hinge & hinge : visual.hinges) {
      pose = pose * turned(hinge, jointState(car.mechanism[hinge.joint], simulation, id).position);
    }
    pose = pose * toTransform(visual.pose);
    for (const Surface & surface : visual.look->appearance().surfaces) {
      place(surface, pose);
    }
  }
}
}  // namespace f1tenth_sim2d
