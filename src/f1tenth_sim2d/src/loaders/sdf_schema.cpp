#include "sdf_schema.h"

#include <sdf/Element.hh>
#include <sdf/parser.hh>

namespace f1tenth_sim2d
{
namespace
{
const sdf::ElementPtr & wholeSchema()
{
  static const sdf::ElementPtr root = [] {
    const sdf::SDFPtr document = std::make_shared<sdf::SDF>();
    sdf::init(document);
    return document->Root();
  }();
  return root;
}

/// Whether reading makes up the element where a document lacks it.
bool isMadeUp(const sdf::ElementPtr & description)
{
  return description->GetRequired() == "1" || description->GetRequired() == "+";
}

/// Empties what describes elements that hold others and that no document will have. Their names stay known.
void cutDown(const sdf::ElementPtr & description, const std::set<std::string> & tags)
{
  for (unsigned i = 0; i < description->GetElementDescriptionCount(); ++i) {
    const sdf::ElementPtr child = description->GetElementDescription(i);
    if (child == description) {
      continue;  // a model may hold models
    }
    if (tags.count(child->GetName()) > 0 || isMadeUp(child)) {
      cutDown(child, tags);
    } else if (child->GetElementDescriptionCount() > 0) {
      child->Reset();
    }
  }
}
}  // namespace

SdfSchema::SdfSchema(const std::set<std::string> & tags) : root_(wholeSchema()->Clone())
{
  cutDown(root_, tags);
}

sdf::SDFPtr SdfSchema::emptyDocument() const
{
  const sdf::SDFPtr document = std::make_shared<sdf::SDF>();
  document->Root(root_->Clone());
  return document;
}
}  // namespace f1tenth_sim2d
