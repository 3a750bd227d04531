#pragma once

#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "f1tenth_sim2d/errors.h"

/// What the fuzz targets share.
namespace f1tenth_sim2d
{
/// A folder in memory where possible, for the inputs of one process.
inline const std::string & fuzzFolder()
{
  static const std::string folder = [] {
    const std::string parent = std::filesystem::exists("/dev/shm") ? "/dev/shm" : "/tmp";
    std::string pattern = parent + "/f1tenth_fuzz_XXXXXX";
    return std::string(mkdtemp(pattern.data()));
  }();
  static const int registered = std::atexit([] { std::filesystem::remove_all(fuzzFolder()); });
  static_cast<void>(registered);
  return folder;
}

inline std::string writeFuzzFile(const std::string & name, const std::uint8_t * data, std::size_t size)
{
  std::string path = fuzzFolder() + "/" + name;
  std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char *>(data), static_cast<std::streamsize>(size));
  return path;
}

/// Calls load: an Error is what a bad input has to give. Anything else that is thrown ends the process.
template <typename Load>
int refuseOrLoad(Load load)
{
  try {
    load();
  } catch (const Error &) {
  }
  return 0;
}
}  // namespace f1tenth_sim2d
