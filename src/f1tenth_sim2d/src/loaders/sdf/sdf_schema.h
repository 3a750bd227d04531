#pragma once

#include <sdf/ParserConfig.hh>
#include <sdf/Root.hh>
#include <sdf/SDFImpl.hh>
#include <set>
#include <string>

namespace f1tenth_sim2d
{
/// As root.Load(path, config), without working out libsdformat's description of SDF anew, and without copies of what the
/// document does not have: together most of what reading a small file costs.
sdf::Errors loadFile(const std::string & path, const sdf::ParserConfig & config, sdf::Root & root);
/// As root.LoadSdfString(text, config), likewise.
sdf::Errors loadText(const std::string & text, const sdf::ParserConfig & config, sdf::Root & root);

/// libsdformat's description of SDF, cut down to the tags of some documents.
///
/// libsdformat copies the description of an element, with all that it could hold, for every element that it reads: that
/// is nearly all the time that reading takes. Cut down, reading is about ten times faster. The whole description is
/// worked out once a process.
class SdfSchema
{
public:
  /// @param tags  all names of elements that documents to be read have
  explicit SdfSchema(const std::set<std::string> & tags);

  /// A document without content, to read text into.
  sdf::SDFPtr emptyDocument() const;

private:
  sdf::ElementPtr root_;
};
}  // namespace f1tenth_sim2d
