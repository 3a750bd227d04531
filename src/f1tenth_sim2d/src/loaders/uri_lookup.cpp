#include "uri_lookup.h"

#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace f1tenth_sim2d
{
namespace fs = std::filesystem;

namespace
{
bool canBeFound(const fs::path & path)
{
  std::error_code ignored;  // a folder that may not be read has nothing for us
  return fs::exists(path, ignored);
}
}  // namespace

ModelPath modelPathFromEnvironment()
{
  const char * const value = std::getenv("GAZEBO_MODEL_PATH");
  std::istringstream text(value ? value : "");
  ModelPath folders;
  for (std::string folder; std::getline(text, folder, ':');) {
    if (!folder.empty()) {
      folders.push_back(folder);
    }
  }
  return folders;
}

UriLookup::UriLookup(const ModelPath & model_path, const std::string & world_file) : folders_(model_path)
{
  const fs::path folder = fs::absolute(world_file).parent_path();
  for (const fs::path & beside : {folder, folder / "models", folder.parent_path() / "models"}) {
    folders_.push_back(beside.string());
  }
}

std::string UriLookup::find(const std::string & uri) const
{
  const std::size_t scheme_end = uri.find("://");
  const fs::path path = scheme_end == std::string::npos ? uri : uri.substr(scheme_end + 3);
  if (path.is_absolute()) {
    return canBeFound(path) ? path.string() : "";
  }
  for (const std::string & folder : folders_) {
    if (const fs::path candidate = fs::path(folder) / path; canBeFound(candidate)) {
      return candidate.string();
    }
  }
  return "";
}

std::string UriLookup::searchedFolders() const
{
  std::string text;
  for (const std::string & folder : folders_) {
    text += (text.empty() ? "" : ", ") + folder;
  }
  return text;
}
}  // namespace f1tenth_sim2d
