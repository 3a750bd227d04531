#include "loaders/model/model_file.h"

#include <tinyxml2.h>

#include <boost/algorithm/string/trim.hpp>
#include <filesystem>
#include <optional>

#include "loaders/model/read_pose.h"
#include "loaders/xml/xml_document.h"

namespace f1tenth_sim2d
{
namespace
{
namespace fs = std::filesystem;

bool isRegularFile(const fs::path & path)
{
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

/// Name of the file that a model.config says; of several versions the newest that can be read here.
std::string newestFile(const fs::path & config)
{
  tinyxml2::XMLDocument document;
  document.LoadFile(config.c_str());
  const tinyxml2::XMLElement * const model = document.FirstChildElement("model");
  std::string newest;
  int best = -1;
  for (auto sdf = model ? model->FirstChildElement("sdf") : nullptr; sdf; sdf = sdf->NextSiblingElement("sdf")) {
    const char * const text = sdf->Attribute("version");
    const int version = text ? versionIn(text) : 0;
    if (sdf->GetText() && version > best && version <= kNewestSdfVersion) {
      best = version;
      newest = boost::algorithm::trim_copy(std::string(sdf->GetText()));
    }
  }
  return newest;
}
}  // namespace

std::string modelFile(const Element & include, const UriLookup & uris)
{
  include.requiredText("uri");
  const Element uri = include.child("uri");
  const std::string found = uris.findFrom(include.document().folder, uri.text());
  if (found.empty()) {
    uri.fail("Unable to find uri[" + uri.text() + "]; searched: " + uris.searchedFolders());
  }
  if (isRegularFile(found)) {
    return found;
  }
  const fs::path config = fs::path(found) / "model.config";
  const fs::path older_config = fs::path(found) / "manifest.xml";
  if (!isRegularFile(config) && !isRegularFile(older_config)) {
    uri.fail("uri[" + uri.text() + "] is the folder " + found + ", which holds no model.config");
  }
  const std::string name = newestFile(isRegularFile(config) ? config : older_config);
  const fs::path file = fs::path(found) / name;
  if (name.empty() || !isRegularFile(file)) {
    uri.fail(
      "uri[" + uri.text() +
      "]: " + (name.empty() ? config.string() + " names no <sdf> file" : file.string() + " is not there"));
  }
  return file.string();
}
}  // namespace f1tenth_sim2d
