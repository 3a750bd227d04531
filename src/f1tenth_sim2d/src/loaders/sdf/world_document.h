#pragma once

#include <list>
#include <memory>
#include <sdf/Root.hh>
#include <sdf/World.hh>
#include <string>
#include <vector>

#include "loaders/files/uri_lookup.h"
#include "loaders/files/warning_collector.h"
#include "loaders/sdf/sdf_messages.h"

namespace f1tenth_sim2d
{
/// A world as libsdformat has read it. While it lives, nothing that libsdformat prints reaches the terminal.
struct WorldDocument
{
  SdfMessages messages;
  std::list<sdf::Root> roots;              ///< of the world, and of models that it includes
  const sdf::World * world{nullptr};       ///< in one of the roots
  std::vector<const sdf::Model *> models;  ///< in the order of the file
};

/// Reads a world file.
/// @throws LoadError
std::unique_ptr<WorldDocument> readWorldDocument(
  const std::string & path, const UriLookup & uris, WarningCollector & warnings);
}  // namespace f1tenth_sim2d
