#include "targets.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <vector>

#include "f1tenth_sim2d/errors.h"
#include "f1tenth_sim2d/loaders.h"
#include "f1tenth_sim2d/simulation.h"

namespace f1tenth_sim2d::fuzz
{
namespace
{
/// A folder for the inputs of this process, in memory where there is such a thing; gone when the process ends.
class InputFolder
{
public:
  InputFolder()
  {
    std::string pattern =
      (std::filesystem::exists("/dev/shm") ? "/dev/shm" : "/tmp") + std::string("/sim2d_fuzz_XXXXXX");
    if (mkdtemp(pattern.data()) == nullptr) {
      throw std::filesystem::filesystem_error("mkdtemp", pattern, {errno, std::generic_category()});
    }
    path_ = pattern;
  }
  InputFolder(const InputFolder &) = delete;
  InputFolder & operator=(const InputFolder &) = delete;
  ~InputFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  const std::string & path() const { return path_; }

private:
  std::string path_;
};

std::string written(const std::string & name, const std::uint8_t * data, std::size_t size)
{
  static const InputFolder folder;
  std::string path = folder.path() + "/" + name;
  std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char *>(data), static_cast<std::streamsize>(size));
  return path;
}

template <typename Load>
void loadOrRefuse(Load load)
{
  try {
    load();
  } catch (const Error &) {
    // What a bad input has to give.
  }
}
/// Lets a car go in an empty world, and its lidars look around.
void drive(const CarDescription & description, const VehicleParameters & parameters)
{
  Simulation simulation(emptyWorld());
  const CarId car = simulation.addCar(description, parameters, {});
  simulation.command(car, {1.0, 0.1});
  simulation.advanceTo(50 * simulation.stepLength());
  for (std::size_t lidar = 0; lidar < description.lidars.size(); ++lidar) {
    std::vector<float> ranges(static_cast<std::size_t>(description.lidars[lidar].beam_count));
    simulation.scan(car, lidar, ranges.data());
  }
  static_cast<void>(simulation.viewWarning());  // reads all that cameras see
}
}  // namespace

void world(const std::uint8_t * data, std::size_t size)
{
  const std::string path = written("fuzz.world", data, size);
  loadOrRefuse([&path] {
    Simulation simulation(loadWorld(path));
    simulation.step();
    static_cast<void>(simulation.viewWarning());
  });
}

void car(const std::uint8_t * data, std::size_t size)
{
  const std::string xml(reinterpret_cast<const char *>(data), size);
  loadOrRefuse([&xml] {
    const CarDescription description = loadCar(xml, "robot1", "fuzz");
    drive(description, description.parameters);
  });
}

void map(const std::uint8_t * data, std::size_t size)
{
  const std::uint8_t * const end_of_yaml = std::find(data, data + size, std::uint8_t{0});
  const std::uint8_t * const image = std::min(end_of_yaml + 1, data + size);
  written("map.png", image, static_cast<std::size_t>(data + size - image));
  const std::string path = written("map.yaml", data, static_cast<std::size_t>(end_of_yaml - data));
  loadOrRefuse([&path] { loadWorld(path); });
}

void texture(const std::uint8_t * data, std::size_t size)
{
  written("texture.png", data, size);
  const std::string world =
    "<sdf version='1.6'><world name='w'><model name='m'><static>1</static><link name='l'><visual name='v'>"
    "<geometry><box><size>1 1 1</size></box></geometry><material><pbr><metal><albedo_map>texture.png</albedo_map>"
    "</metal></pbr></material></visual></link></model></world></sdf>";
  const std::string path = written("texture.world", reinterpret_cast<const std::uint8_t *>(world.data()), world.size());
  static_cast<void>(Simulation(loadWorld(path)).viewWarning());
}

void vehicle(const std::uint8_t * data, std::size_t size)
{
  const std::string path = written("car.yaml", data, size);
  loadOrRefuse([&path] {
    CarDescription description;
    description.name = "robot1";
    drive(description, loadVehicleParameters(path));
  });
}
}  // namespace f1tenth_sim2d::fuzz
