// The fuzz targets with the inputs they start from, and with those that were found to crash or hang a loader.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "targets.h"

using namespace f1tenth_sim2d;

namespace
{
std::vector<std::uint8_t> bytesOf(const std::filesystem::path & path)
{
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Feeds every file of a folder to a target.
void feed(const std::string & folder, fuzz::Target target)
{
  std::size_t count = 0;
  for (const auto & entry : std::filesystem::directory_iterator(F1TENTH_SIM2D_FUZZ_SEEDS "/" + folder)) {
    SCOPED_TRACE(entry.path().string());
    const std::vector<std::uint8_t> bytes = bytesOf(entry.path());
    EXPECT_NO_THROW(target(bytes.data(), bytes.size()));
    ++count;
  }
  EXPECT_GT(count, 0u) << folder;
}
}  // namespace

TEST(FuzzSeeds, WorldsAreLoadedOrRefused)
{
  feed("world", fuzz::world);
}

TEST(FuzzSeeds, CarsAreLoadedOrRefused)
{
  feed("car", fuzz::car);
}

TEST(FuzzSeeds, MapsAreLoadedOrRefused)
{
  feed("map", fuzz::map);
}

TEST(FuzzSeeds, TexturesAreReadOrLeftOut)
{
  feed("texture", fuzz::texture);
}

TEST(FuzzSeeds, VehicleFilesAreLoadedOrRefused)
{
  feed("vehicle", fuzz::vehicle);
}
