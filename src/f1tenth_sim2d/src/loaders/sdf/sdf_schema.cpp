#include "loaders/sdf/sdf_schema.h"

#include <sdf/Element.hh>
#include <sdf/parser.hh>

#include "loaders/files/xml_text.h"

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

/// A copy of an element's description without those of the elements that it may hold.
sdf::ElementPtr withoutChildren(const sdf::Element & description)
{
  const auto copy = std::make_shared<sdf::Element>();
  copy->SetName(description.GetName());
  copy->SetRequired(description.GetRequired());
  copy->SetDescription(description.GetDescription());
  copy->SetCopyChildren(description.GetCopyChildren());
  copy->SetReferenceSDF(description.ReferenceSDF());
  for (const sdf::ParamPtr & each : description.GetAttributes()) {
    copy->AddAttribute(
      each->GetKey(), each->GetTypeName(), each->GetDefaultAsString(), each->GetRequired(), each->GetDescription());
  }
  return copy;
}

/// A copy of an element's description, with a choice for each element that it may hold.
/// @param choose  gives a description that nobody changes, so that many may share it
template <class Choose>
sdf::ElementPtr copyOf(const sdf::Element & description, const Choose & choose)
{
  const sdf::ElementPtr copy = withoutChildren(description);
  for (unsigned i = 0; i < description.GetElementDescriptionCount(); ++i) {
    copy->AddElementDescription(choose(description.GetElementDescription(i)));
  }
  return copy;
}

/// Empties what describes elements that hold others and that no document will have. Their names stay known.
sdf::ElementPtr cutDown(const sdf::Element & description, const std::set<std::string> & tags)
{
  return copyOf(description, [&tags](const sdf::ElementPtr & child) {
    if (child->GetElementDescriptionCount() == 0) {
      return child;
    }
    return tags.count(child->GetName()) > 0 || isMadeUp(child) ? cutDown(*child, tags) : withoutChildren(*child);
  });
}

/// Empties only what describes elements of a world that hold whole models, three quarters of all. Reading an old version
/// of SDF changes names of elements, but gives none of these.
sdf::ElementPtr withoutUnusedWorlds(const sdf::Element & description, const std::set<std::string> & tags)
{
  static const std::set<std::string> hold_models{"actor", "population", "state"};
  return copyOf(description, [&tags](const sdf::ElementPtr & child) {
    if (child->GetName() == "world") {
      return withoutUnusedWorlds(*child, tags);
    }
    const bool unused = hold_models.count(child->GetName()) > 0 && tags.count(child->GetName()) == 0;
    return unused ? withoutChildren(*child) : child;
  });
}

sdf::SDFPtr documentWith(const sdf::ElementPtr & root)
{
  const sdf::SDFPtr document = std::make_shared<sdf::SDF>();
  document->Root(root);
  return document;
}

/// @param text  the document as XML; with a mistake in it, it has no tags
/// @param read  reads into a document; whether it could
/// @param failure  what libsdformat says if it could not
template <class Read>
sdf::Errors loadWith(
  const tinyxml2::XMLDocument & text, const Read & read, const sdf::Error & failure, const sdf::ParserConfig & config,
  sdf::Root & root)
{
  const sdf::SDFPtr document = documentWith(withoutUnusedWorlds(*wholeSchema(), elementNames(text)));
  sdf::Errors errors;
  const bool could_read = read(document, errors);
  const sdf::Errors more = could_read ? root.Load(document, config) : sdf::Errors{failure};
  errors.insert(errors.end(), more.begin(), more.end());
  return errors;
}
}  // namespace

sdf::Errors loadFile(const std::string & path, const sdf::ParserConfig & config, sdf::Root & root)
{
  tinyxml2::XMLDocument text;
  text.LoadFile(path.c_str());
  const auto read = [&](const sdf::SDFPtr & document, sdf::Errors & errors) {
    return sdf::readFile(path, config, document, errors);
  };
  return loadWith(text, read, {sdf::ErrorCode::FILE_READ, "Unable to read file:" + path}, config, root);
}

sdf::Errors loadText(const std::string & text, const sdf::ParserConfig & config, sdf::Root & root)
{
  tinyxml2::XMLDocument parsed;
  parsed.Parse(text.c_str(), text.size());
  const auto read = [&](const sdf::SDFPtr & document, sdf::Errors & errors) {
    return sdf::readString(text, config, document, errors);
  };
  return loadWith(parsed, read, {sdf::ErrorCode::STRING_READ, "Unable to read SDF string: " + text}, config, root);
}

SdfSchema::SdfSchema(const std::set<std::string> & tags) : root_(cutDown(*wholeSchema(), tags)) {}

sdf::SDFPtr SdfSchema::emptyDocument() const
{
  return documentWith(root_->Clone());
}
}  // namespace f1tenth_sim2d
