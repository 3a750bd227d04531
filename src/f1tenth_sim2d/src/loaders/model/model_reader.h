#pragma once

#include <optional>
#include <string>
#include <vector>

#include "loaders/files/uri_lookup.h"
#include "loaders/model/model.h"
#include "loaders/shapes/mesh_library.h"
#include "loaders/xml/warning_collector.h"
#include "loaders/xml/xml_document.h"

namespace f1tenth_sim2d
{
/// Reads models in one walk over their document and over those that it includes.
class ModelReader
{
public:
  /// Both must outlive the reader.
  ModelReader(const UriLookup & uris, WarningCollector & warnings)
  : uris_(uris), warnings_(warnings), documents_(warnings), meshes_(uris, warnings)
  {
  }

  XmlDocuments & documents() { return documents_; }
  WarningCollector & warnings() { return warnings_; }
  MeshLibrary & meshes() { return meshes_; }

  /// The model of a text.
  /// @param source  what error messages call the text
  /// @param what    it should be, for them: "robot description"
  /// @throws LoadError, also if it holds none
  Model readText(const std::string & xml, const std::string & source, const std::string & what);

  /// The model of a document: <robot>, or <model> in <sdf>. None if it holds none.
  /// @throws LoadError
  std::optional<Model> readDocument(const Element & root);

  /// A <model>, or the model of an <include>; none for any other element, and for documents that hold none, with a
  /// warning unless they hold lights.
  /// Its own pose is not resolved: see nestFrames().
  std::optional<Model> readNested(const Element & element);

private:
  Model readModel(const Element & element);
  std::optional<Model> readInclude(const Element & include);
  void readChildren(const Element & element, Model & model);
  std::string includedFile(const Element & include) const;

  const UriLookup & uris_;
  WarningCollector & warnings_;
  XmlDocuments documents_;
  MeshLibrary meshes_;
  std::vector<std::string> open_files_;  ///< included by each other; canonical paths
};
}  // namespace f1tenth_sim2d
