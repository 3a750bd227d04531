#include "core/components/camera/camera.h"

#include <algorithm>
#include <cmath>
#include <future>

#include "f1tenth_sim2d/errors.h"
#include "f1tenth_sim2d/simulation.h"

namespace f1tenth_sim2d
{
const Camera::Eye & Camera::eye(const std::string & name) const
{
  std::string names;
  for (const Eye & eye : eyes_) {
    if (name.empty() || eye.name == name) {
      return eye;
    }
    names += (names.empty() ? "" : ", ") + eye.name;
  }
  throw Error("the camera " + mount().name + " has no eye '" + name + "', there are: " + names);
}

void Camera::look(
  const Simulation & simulation, CarId car, const std::vector<const Eye *> & eyes,
  const std::vector<Picture *> & pictures) const
{
  const auto look_through_every_second = [&](std::size_t first) {
    for (std::size_t i = first; i < eyes.size(); i += 2) {
      const Eye & eye = *eyes[i];
      simulation.draw(car, eye.lens ? eye.lens->straight() : eye.pinhole, eye.pose, *pictures[i]);
      if (eye.lens) {
        eye.lens->bend(*pictures[i]);
      }
      if (eye.noise_stddev > 0.0) {
        addNoise(simulation, car, eye, *pictures[i]);
      }
    }
  };
  std::future<void> others;
  if (eyes.size() > 1) {
    others = std::async(std::launch::async, look_through_every_second, 1);
  }
  look_through_every_second(0);
  if (others.valid()) {
    others.get();
  }
}

void Camera::addNoise(const Simulation & simulation, CarId car, const Eye & eye, Picture & picture) const
{
  constexpr double kGreatest = 255.0;
  std::vector<double> noise(picture.colours.size());
  simulation.noises(car, mount().name + "/" + eye.name, noise.size(), noise.data());
  for (std::size_t i = 0; i < noise.size(); ++i) {
    const double colour = picture.colours[i] + kGreatest * eye.noise_stddev * noise[i];
    picture.colours[i] = static_cast<std::uint8_t>(std::max(0.0, std::min(colour + 0.5, kGreatest)));
  }
}
}  // namespace f1tenth_sim2d
