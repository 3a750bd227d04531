#include "sdf_document.h"

#include <algorithm>
#include <regex>
#include <set>

#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
namespace
{
/// /sdf/world[@name="w"]/include[0]/uri -> world[w]/include[0]/uri
std::string shortened(const std::string & xml_path)
{
  return std::regex_replace(
    std::regex_replace(xml_path, std::regex(R"(^/sdf/)"), ""), std::regex(R"(\[@name="([^"]*)\"\])"), "[$1]");
}

bool isUnknownElement(const sdf::Error & error)
{
  return error.Code() == sdf::ErrorCode::ELEMENT_INCORRECT_TYPE &&
         error.Message().find("not defined in SDF") != std::string::npos;
}

/// First element below parent that bears the name of an earlier sibling of its kind.
sdf::ElementPtr findDuplicate(const sdf::ElementPtr & parent)
{
  std::set<std::pair<std::string, std::string>> names;
  for (auto child = parent->GetFirstElement(); child; child = child->GetNextElement()) {
    if (child->HasAttribute("name") && !names.emplace(child->GetName(), child->Get<std::string>("name")).second) {
      return child;
    }
    if (const auto found = findDuplicate(child)) {
      return found;
    }
  }
  return nullptr;
}

[[noreturn]] void throwMalformed(const std::string & file, const std::string & printed)
{
  static const std::regex pattern(
    R"(Error parsing XML in (?:file \[(.*)\]|.*): Error=XML_(?:ERROR_)?(\w+).*Line number=(\d+)(?:: (.*))?)");
  std::smatch match;
  if (!std::regex_match(printed, match, pattern)) {
    throw LoadError(file, "", printed);
  }
  const std::string place =
    (match[1].matched && match[1] != file ? match[1].str() + ", " : "") + "line " + match[3].str();
  throw LoadError(file, place, "malformed XML: " + match[2].str() + (match[4].matched ? ", " + match[4].str() : ""));
}

[[noreturn]] void throwFirst(
  const sdf::Errors & errors, const std::vector<std::string> & printed, const sdf::Root & root,
  const std::string & file, const std::string & uri_hint)
{
  const sdf::Error & first = errors.front();
  const std::string place = first.XmlPath() ? shortened(*first.XmlPath()) : "";
  const bool in_other_file = first.FilePath() && *first.FilePath() != file;
  const std::string where = in_other_file ? *first.FilePath() + ": " + place : place;
  if (first.Code() == sdf::ErrorCode::DUPLICATE_NAME) {
    const sdf::ElementPtr duplicate = root.Element() ? findDuplicate(root.Element()) : nullptr;
    throw LoadError(
      file, duplicate ? elementPath(duplicate) : where,
      "this name is taken; names are unique among the elements of one parent");
  }
  if (first.Code() == sdf::ErrorCode::URI_LOOKUP) {
    throw LoadError(file, where, first.Message() + uri_hint);
  }
  // What failed in detail is printed only, not returned.
  const bool says_little =
    first.Message().rfind("Error reading", 0) == 0 || first.Message().rfind("Unable to read", 0) == 0;
  throw LoadError(file, where, says_little && !printed.empty() ? printed.front() : first.Message());
}
}  // namespace

std::string elementPath(sdf::ElementPtr element)
{
  std::string path;
  for (; element && element->GetName() != "sdf"; element = element->GetParent()) {
    const std::string name = element->HasAttribute("name") ? "[" + element->Get<std::string>("name") + "]" : "";
    path = element->GetName() + name + (path.empty() ? "" : "/") + path;
  }
  return path;
}

sdf::ParserConfig parserConfig(std::function<std::string(const std::string &)> find)
{
  sdf::ParserConfig config;
  config.SetFindCallback(std::move(find));
  config.SetUnrecognizedElementsPolicy(sdf::EnforcementPolicy::ERR);
  return config;
}

void checkSdfErrors(
  const sdf::Errors & errors, const SdfMessages & messages, const sdf::Root & root, const std::string & file,
  const std::string & uri_hint, WarningCollector & warnings)
{
  const std::vector<std::string> printed = messages.errors();
  const auto malformed = std::find_if(
    printed.begin(), printed.end(), [](const std::string & line) { return line.rfind("Error parsing XML", 0) == 0; });
  if (malformed != printed.end()) {
    throwMalformed(file, *malformed);
  }
  sdf::Errors serious;
  for (const sdf::Error & error : errors) {
    if (isUnknownElement(error)) {
      warnings.add("not an element of SDF, left out", shortened(error.XmlPath().value_or(file)));
    } else {
      serious.push_back(error);
    }
  }
  if (!serious.empty()) {
    throwFirst(serious, printed, root, file, uri_hint);
  }
  if (!printed.empty()) {
    throw LoadError(file, "", printed.front());
  }
  for (const std::string & warning : messages.warnings()) {
    warnings.add(warning, file);
  }
}
}  // namespace f1tenth_sim2d
