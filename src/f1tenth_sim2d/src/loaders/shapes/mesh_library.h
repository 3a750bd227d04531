#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "loaders/files/uri_lookup.h"
#include "loaders/shapes/mesh_file.h"
#include "loaders/xml/element.h"
#include "loaders/xml/warning_collector.h"

namespace f1tenth_sim2d
{
/// The meshes of one world or car; what is used several times is read once.
class MeshLibrary
{
public:
  /// Both must outlive the library.
  MeshLibrary(const UriLookup & uris, WarningCollector & warnings) : uris_(uris), warnings_(warnings) {}

  /// @param element  a <mesh>, which messages name
  /// @param uri      of its file; one without scheme is first looked up beside the file that the element is in
  /// @return none, with a warning, if a scale of 0 leaves nothing of it
  /// @throws LoadError
  std::optional<Mesh> read(const Element & element, const std::string & uri, const MeshSelection & selection);

  /// A copy of where files are looked up, shared by all that asks for it.
  std::shared_ptr<const UriLookup> sharedUris();

private:
  std::string find(const Element & element, const std::string & uri) const;
  std::shared_ptr<const TriangleMesh> readNew(
    const Element & element, const std::string & path, const MeshSelection & selection);

  const UriLookup & uris_;
  std::shared_ptr<const UriLookup> shared_uris_;
  WarningCollector & warnings_;
  std::map<std::string, std::shared_ptr<const TriangleMesh>> known_;
};
}  // namespace f1tenth_sim2d
