#include "loaders/sdf/world_document.h"

#include <sdf/Model.hh>
#include <sdf/parser.hh>

#include "f1tenth_sim2d/errors.h"
#include "loaders/sdf/sdf_errors.h"
#include "loaders/sdf/sdf_schema.h"
#include "loaders/sdf/world_text.h"

namespace f1tenth_sim2d
{
namespace
{
sdf::ParserConfig configWith(const UriLookup & uris)
{
  sdf::ParserConfig config = parserConfig();
  config.SetFindCallback([&uris](const std::string & uri) { return uris.find(uri); });
  return config;
}

/// Whether a text has been read without anything to say about it.
bool readCleanly(
  const tinyxml2::XMLDocument & text, const SdfSchema & schema, const sdf::ParserConfig & config, sdf::Root & root)
{
  const sdf::SDFPtr document = schema.emptyDocument();
  sdf::Errors errors;
  return sdf::readString(printed(text), config, document, errors) && errors.empty() &&
         root.Load(document, config).empty();
}

/// Reads a world and each model that it includes on its own, with as much of the schema as they use. Null for a world
/// that cannot be taken apart, or that is not perfect.
std::unique_ptr<WorldDocument> readInParts(const std::string & path, const UriLookup & uris)
{
  auto document = std::make_unique<WorldDocument>();
  const WorldText text(path, uris);
  if (!text.complete()) {
    return nullptr;
  }
  const sdf::ParserConfig config = configWith(uris);
  const SdfSchema schema(text.tags());
  if (!readCleanly(text.world(), schema, config, document->roots.emplace_back())) {
    return nullptr;
  }
  document->world = document->roots.front().WorldByIndex(0);
  for (const WorldText::Model & model : text.models()) {
    if (!model.included) {
      document->models.push_back(document->world->ModelByName(model.name));
    } else if (readCleanly(*model.included, schema, config, document->roots.emplace_back())) {
      document->models.push_back(document->roots.back().Model());
      document->models.back()->Element()->SetParent(document->world->Element());
    } else {
      return nullptr;
    }
  }
  const bool silent = document->messages.errors().empty() && document->messages.warnings().empty();
  return silent ? std::move(document) : nullptr;
}

const sdf::World & onlyWorld(const sdf::Root & root, const std::string & path)
{
  if (root.WorldCount() != 1) {
    throw LoadError(path, "", "holds " + std::to_string(root.WorldCount()) + " worlds, allowed is one <world>");
  }
  return *root.WorldByIndex(0);
}

std::unique_ptr<WorldDocument> readInOnePiece(
  const std::string & path, const UriLookup & uris, WarningCollector & warnings)
{
  auto document = std::make_unique<WorldDocument>();
  sdf::Root & root = document->roots.emplace_back();
  const sdf::Errors errors = loadFile(path, configWith(uris), root);
  checkSdfErrors(errors, document->messages, root, path, "; searched: " + uris.searchedFolders(), warnings);
  document->world = &onlyWorld(root, path);
  for (std::uint64_t i = 0; i < document->world->ModelCount(); ++i) {
    document->models.push_back(document->world->ModelByIndex(i));
  }
  return document;
}
}  // namespace

std::unique_ptr<WorldDocument> readWorldDocument(
  const std::string & path, const UriLookup & uris, WarningCollector & warnings)
{
  if (auto document = readInParts(path, uris)) {
    return document;
  }
  return readInOnePiece(path, uris, warnings);
}
}  // namespace f1tenth_sim2d
