#pragma once

#include <optional>
#include <string>

#include "f1tenth_sim2d/loaders.h"
#include "loaders/files/package_path.h"

namespace f1tenth_sim2d
{
/// Finds what model://, file:// and package:// URIs mean. ROS packages are searched only if nothing else helps.
class UriLookup
{
public:
  /// @param world_file  its folder, the folder `models` in it and the one beside it are searched after the model
  ///                    folders; empty: there is none
  UriLookup(const SearchPath & search_path, const std::string & world_file);

  /// Path of the file or folder; empty if there is none.
  std::string find(const std::string & uri) const;

  /// The same for a URI in a file in that folder: a path without scheme means a file beside it, if there is one.
  std::string findFrom(const std::string & folder, const std::string & uri) const;

  /// The folders that are searched, for error messages.
  std::string searchedFolders() const;

private:
  std::string findInPackages(const std::string & path) const;

  std::vector<std::string> folders_;
  std::vector<std::string> package_folders_;
  mutable std::optional<PackagePath> packages_;
};
}  // namespace f1tenth_sim2d
