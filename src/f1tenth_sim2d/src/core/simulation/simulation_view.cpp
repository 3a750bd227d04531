#include "core/simulation/simulation_impl.h"

namespace f1tenth_sim2d
{
void Simulation::draw(CarId car, const Pinhole & camera, const Pose3 & pose, Picture & picture) const
{
  auto & [first, second] = impl_->viewers;
  std::unique_lock<std::mutex> lock(first.mutex, std::try_to_lock);
  View & view = lock ? first.view : second.view;
  if (!lock) {
    lock = std::unique_lock<std::mutex>(second.mutex);
  }
  const std::shared_ptr<const WorldGeometry> & world = impl_->geometry;
  view.draw(*this, {world, &world->look()}, car, camera, pose, picture);
}

std::string Simulation::viewWarning() const
{
  std::string first;
  std::size_t count = 0;
  const auto add = [&](const std::vector<Visual> & visuals) {
    for (const Visual & visual : visuals) {
      const std::string & warning = visual.look->appearance().warning;
      first = first.empty() ? warning : first;
      count += warning.empty() ? 0 : 1;
    }
  };
  for (const ModelDescription & model : models()) {
    add(model.visuals);
  }
  for (const CarId id : cars()) {
    add(car(id).visuals);
  }
  return count > 1 ? first + " (and " + std::to_string(count - 1) + " more)" : first;
}
}  // namespace f1tenth_sim2d
