#pragma once

#include <map>
#include <sdf/Element.hh>

#include "loaders/files/mesh_file.h"
#include "loaders/files/uri_lookup.h"
#include "loaders/files/warning_collector.h"

namespace f1tenth_sim2d
{
/// The meshes of one document; what is used several times is read once.
class MeshLibrary
{
public:
  /// Both must outlive the library.
  MeshLibrary(const UriLookup & uris, WarningCollector & warnings) : uris_(uris), warnings_(warnings) {}

  /// @param element  a <mesh>
  /// @param file     what error messages call the document
  /// @throws LoadError
  Mesh read(const sdf::ElementPtr & element, const std::string & file);

private:
  std::string find(const sdf::ElementPtr & element, const std::string & file) const;
  std::shared_ptr<const TriangleMesh> readNew(
    const sdf::ElementPtr & element, const std::string & path, const MeshSelection & selection,
    const std::string & file);

  const UriLookup & uris_;
  WarningCollector & warnings_;
  std::map<std::string, std::shared_ptr<const TriangleMesh>> known_;
};
}  // namespace f1tenth_sim2d
