#include <algorithm>
#include <cstring>

#include "f1tenth_sim2d/loaders.h"
#include "fuzz_input.h"

/// A map: YAML up to the first zero byte, then the image, both of them arbitrary.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t * data, std::size_t size)
{
  using namespace f1tenth_sim2d;
  const std::uint8_t * const end_of_yaml = std::find(data, data + size, std::uint8_t{0});
  const std::uint8_t * const image = std::min(end_of_yaml + 1, data + size);
  writeFuzzFile("map.png", image, static_cast<std::size_t>(data + size - image));
  const std::string path = writeFuzzFile("map.yaml", data, static_cast<std::size_t>(end_of_yaml - data));
  return refuseOrLoad([&path] { loadWorld(path); });
}
