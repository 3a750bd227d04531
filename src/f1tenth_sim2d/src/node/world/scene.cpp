#include "node/world/scene.h"

#include "f1tenth_sim2d/loaders.h"
#include "node/world/warnings.h"

namespace f1tenth_sim2d
{
namespace
{
std::vector<std::string> worldWarnings(const WorldDescription & world)
{
  std::vector<std::string> warnings = world.warnings;
  for (const auto & plugin : world.plugins) {
    warnings.push_back(plugin.place + ": plugin " + plugin.filename + " of the world");
  }
  return warnings;
}
}  // namespace

Scene buildScene(const NodeParameters & parameters)
{
  const WorldDescription world = loadWorld(parameters.world_file, searchPathFromEnvironment());
  warnOnce(world.file, worldWarnings(world));
  return {Simulation(world, parameters.simulation), world.gravity, world.start};
}
}  // namespace f1tenth_sim2d
