#pragma once

#include <tinyxml2.h>

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "loaders/files/uri_lookup.h"

namespace f1tenth_sim2d
{
/// The XML of a world and of the models that it includes, without what has no counterpart in the simulation and is left
/// out in silence. Only for worlds that can be taken apart: see complete().
class WorldText
{
public:
  /// A <model> of the world, in the order of the file.
  struct Model
  {
    std::string name;
    std::unique_ptr<tinyxml2::XMLDocument> included;  ///< null: it stands in the world itself
  };

  WorldText(const std::string & path, const UriLookup & uris);

  /// Whether all of it has been found, every included model stands for itself, and all names differ. Of a world that
  /// ties models to frames, or that has a mistake, nothing is known here: libsdformat has to read it in one piece.
  bool complete() const { return complete_; }

  const tinyxml2::XMLDocument & world() const { return world_; }
  const std::vector<Model> & models() const { return models_; }

  /// Names of all elements of all documents.
  std::set<std::string> tags() const;

private:
  bool takeApart(const std::string & path, const UriLookup & uris);
  bool takeInclude(tinyxml2::XMLElement & include, const UriLookup & uris);

  tinyxml2::XMLDocument world_;
  std::vector<Model> models_;
  bool complete_{false};
};

/// The file of a model that the URI of an <include> means; empty if there is none.
std::string modelFile(const std::string & uri, const UriLookup & uris);

/// A document as text.
std::string printed(const tinyxml2::XMLDocument & document);
}  // namespace f1tenth_sim2d
