#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
/// A folder of its own for one test.
class TempFolder
{
public:
  TempFolder()
  {
    std::string pattern = (std::filesystem::temp_directory_path() / "f1tenth_sim2d_XXXXXX").string();
    path_ = mkdtemp(pattern.data());
  }
  ~TempFolder() { std::filesystem::remove_all(path_); }
  TempFolder(const TempFolder &) = delete;
  TempFolder & operator=(const TempFolder &) = delete;

  const std::string & path() const { return path_; }

  std::string write(const std::string & name, const std::string & text) const
  {
    const std::filesystem::path file = std::filesystem::path(path_) / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << text;
    return file.string();
  }

private:
  std::string path_;
};

/// What the LoadError says that call throws; "nothing thrown" if it does not.
template <typename Call>
std::string loadErrorOf(Call call)
{
  try {
    call();
  } catch (const LoadError & error) {
    return error.what();
  }
  return "nothing thrown";
}

/// The message without the folder in front of file names.
inline std::string withoutFolder(std::string message, const TempFolder & folder)
{
  for (std::size_t at = message.find(folder.path() + "/"); at != std::string::npos;
       at = message.find(folder.path() + "/")) {
    message.erase(at, folder.path().size() + 1);
  }
  return message;
}
}  // namespace f1tenth_sim2d
