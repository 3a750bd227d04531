#include "loaders/files/uri_lookup.h"

#include <algorithm>
#include <boost/algorithm/string/join.hpp>
#include <filesystem>

namespace f1tenth_sim2d
{
namespace
{
namespace fs = std::filesystem;

bool canBeFound(const fs::path & path)
{
  std::error_code ignored;  // a folder that may not be read counts as empty
  return fs::exists(path, ignored);
}

std::string findIn(const std::vector<std::string> & folders, const fs::path & path)
{
  for (const std::string & folder : folders) {
    if (const fs::path candidate = fs::path(folder) / path; canBeFound(candidate)) {
      return candidate.string();
    }
  }
  return "";
}
}  // namespace

UriLookup::UriLookup(const SearchPath & search_path, const std::string & world_file)
: folders_(search_path.model_folders), package_folders_(search_path.package_folders)
{
  if (world_file.empty()) {
    return;
  }
  const fs::path folder = fs::absolute(world_file).parent_path();
  for (const fs::path & beside : {folder, folder / "models", folder.parent_path() / "models"}) {
    folders_.push_back(beside.string());
  }
}

std::string UriLookup::find(const std::string & uri) const
{
  const std::size_t scheme_end = uri.find("://");
  const std::string scheme = scheme_end == std::string::npos ? "" : uri.substr(0, scheme_end);
  const bool is_of_folders = scheme == "model" || scheme == "package";
  const std::size_t start = scheme.empty() ? 0 : scheme_end + 3;
  // model:///NAME has one slash too many, but is in use.
  const fs::path path = uri.substr(is_of_folders ? std::min(uri.find_first_not_of('/', start), uri.size()) : start);
  if (path.is_absolute()) {
    return canBeFound(path) ? path.string() : "";
  }
  if (path.empty()) {
    return "";
  }
  const std::string first = scheme == "package" ? findInPackages(path.string()) : findIn(folders_, path);
  if (!first.empty()) {
    return first;
  }
  return scheme == "package" ? findIn(folders_, path) : findInPackages(path.string());
}

std::string UriLookup::findFrom(const std::string & folder, const std::string & uri) const
{
  if (const fs::path beside = fs::path(folder) / uri; !folder.empty() && canBeFound(beside) && !uri.empty()) {
    return beside.string();
  }
  return find(uri);
}

std::string UriLookup::findInPackages(const std::string & path) const
{
  if (!packages_) {
    packages_.emplace(package_folders_);
  }
  const std::size_t slash = path.find('/');
  const std::string package = packages_->folderOf(path.substr(0, slash));
  if (!package.empty()) {
    const fs::path inside = slash == std::string::npos ? fs::path() : fs::path(path.substr(slash + 1));
    if (const fs::path candidate = fs::path(package) / inside; canBeFound(candidate)) {
      return candidate.string();
    }
  }
  return findIn(packages_->modelFolders(), path);
}

std::string UriLookup::searchedFolders() const
{
  if (folders_.empty() && package_folders_.empty()) {
    return "nothing, since GAZEBO_MODEL_PATH, GAZEBO_RESOURCE_PATH and ROS_PACKAGE_PATH are empty";
  }
  std::string text = boost::algorithm::join(folders_, ", ");
  if (!package_folders_.empty()) {
    text += (text.empty() ? "" : ", and ") + std::string("the ROS packages below ") +
            boost::algorithm::join(package_folders_, ", ");
  }
  return text;
}
}  // namespace f1tenth_sim2d
