#pragma once

#include <string>

#include "f1tenth_sim2d/loaders.h"

namespace f1tenth_sim2d
{
/// Finds what model:// and file:// URIs mean.
class UriLookup
{
public:
  /// @param world_file  its folder, the folder `models` in it and the one beside it are looked through last
  UriLookup(const ModelPath & model_path, const std::string & world_file);

  /// Path of the file or folder; empty if there is none.
  std::string find(const std::string & uri) const;

  /// The folders that are looked through, for error messages.
  std::string searchedFolders() const;

private:
  ModelPath folders_;
};
}  // namespace f1tenth_sim2d
