#include "loaders/sdf/sdf_errors.h"

#include <algorithm>
#include <functional>
#include <regex>
#include <sdf/Sensor.hh>

#include "f1tenth_sim2d/errors.h"
#include "loaders/sdf/element_reader.h"

namespace f1tenth_sim2d
{
namespace
{
bool startsWith(const std::string & text, const std::string & start)
{
  return text.rfind(start, 0) == 0;
}

/// /sdf/world[@name="w"]/include[0]/uri -> world[w]/include[0]/uri
std::string shortened(const std::string & xml_path)
{
  // Not by a regular expression: those of the standard library recurse once a character, and names may be long.
  static const std::string mark = "[@name=\"";
  std::string path = startsWith(xml_path, "/sdf/") ? xml_path.substr(5) : xml_path;
  for (std::size_t at = path.find(mark); at != std::string::npos; at = path.find(mark, at + 1)) {
    path.erase(at + 1, mark.size() - 1);
    if (const std::size_t quote = path.find('"', at); quote != std::string::npos) {
      path.erase(quote, 1);
    }
  }
  return path;
}

/// First element, depth first, of which the test is true; null if there is none.
sdf::ElementPtr findElement(const sdf::ElementPtr & parent, const std::function<bool(const sdf::ElementPtr &)> & is_it)
{
  for (auto child = parent ? parent->GetFirstElement() : nullptr; child; child = child->GetNextElement()) {
    if (is_it(child)) {
      return child;
    }
    if (const auto found = findElement(child, is_it)) {
      return found;
    }
  }
  return nullptr;
}

bool hasNameOfEarlierSibling(const sdf::ElementPtr & element)
{
  if (!element->HasAttribute("name")) {
    return false;
  }
  const auto name = element->Get<std::string>("name");
  auto sibling = element->GetParent()->GetFirstElement();
  while (sibling != element && !(sibling->GetName() == element->GetName() && sibling->HasAttribute("name") &&
                                 sibling->Get<std::string>("name") == name)) {
    sibling = sibling->GetNextElement();
  }
  return sibling != element;
}

bool isModelWithoutLink(const sdf::ElementPtr & element)
{
  return element->GetName() == "model" && !element->HasElement("link") && !element->HasElement("model");
}

bool isSensorOfUnknownType(const sdf::ElementPtr & element)
{
  return element->GetName() == "sensor" && !sdf::Sensor().SetType(element->Get<std::string>("type"));
}

/// Path of the element that an error is about where libsdformat itself does not say it; may be empty.
std::string placeOf(const sdf::Error & error, const sdf::Root & root, const std::string & file)
{
  if (error.XmlPath()) {
    const bool elsewhere = error.FilePath() && *error.FilePath() != file && *error.FilePath() != "<urdf-string>";
    return (elsewhere ? *error.FilePath() + ": " : "") + shortened(*error.XmlPath());
  }
  if (error.Code() == sdf::ErrorCode::DUPLICATE_NAME) {
    return elementPath(findElement(root.Element(), hasNameOfEarlierSibling));
  }
  if (error.Code() == sdf::ErrorCode::MODEL_WITHOUT_LINK) {
    return elementPath(findElement(root.Element(), isModelWithoutLink));
  }
  return "";
}

bool isUnknownElement(const sdf::Error & error)
{
  return error.Code() == sdf::ErrorCode::ELEMENT_INCORRECT_TYPE &&
         error.Message().find("not defined in SDF") != std::string::npos;
}

bool isUnknownSensor(const sdf::Error & error)
{
  return error.Code() == sdf::ErrorCode::ATTRIBUTE_INVALID &&
         error.Message().find("sensor type is missing or invalid") != std::string::npos;
}

/// Whether the error can be passed over with a warning.
bool becomesWarning(
  const sdf::Error & error, const sdf::Root & root, const std::string & file, WarningCollector & warnings)
{
  if (isUnknownElement(error)) {
    warnings.add("is not an element of SDF and left out", placeOf(error, root, file));
    return true;
  }
  if (isUnknownSensor(error)) {
    warnings.add(
      "is no type of sensor of SDF and left out", elementPath(findElement(root.Element(), isSensorOfUnknownType)));
    return true;
  }
  return false;
}

[[noreturn]] void throwMalformed(const std::string & file, const std::string & printed)
{
  static const std::regex pattern(
    R"(Error parsing XML (?:in file \[(.*)\]|from string): Error=XML_(?:ERROR_)?(\w+).*Line number=(\d+)(?:: (.*))?)");
  std::smatch match;
  if (!std::regex_match(printed, match, pattern)) {
    throw LoadError(file, "", printed);
  }
  const bool elsewhere = match[1].matched && match[1] != file;
  const std::string line = match[3] == "0" ? "" : "line " + match[3].str();  // an empty document has no line
  const std::string detail = match[4].matched ? ", " + match[4].str() : "";
  throw LoadError(
    file, elsewhere ? match[1].str() + (line.empty() ? "" : ", ") + line : line,
    "malformed XML: " + match[2].str() + detail);
}

/// Further words may follow what libsdformat says.
std::string withoutFullStop(const std::string & message)
{
  return !message.empty() && message.back() == '.' ? message.substr(0, message.size() - 1) : message;
}

[[noreturn]] void throwError(
  const sdf::Error & error, const std::vector<std::string> & printed, const sdf::Root & root, const std::string & file,
  const std::string & uri_hint)
{
  const std::string place = placeOf(error, root, file);
  const std::string message = withoutFullStop(error.Message());
  if (error.Code() == sdf::ErrorCode::DUPLICATE_NAME) {
    throw LoadError(file, place, "this name is taken; names are unique among the elements of one parent");
  }
  if (error.Code() == sdf::ErrorCode::URI_LOOKUP) {
    throw LoadError(file, place, message + uri_hint);
  }
  // What failed in detail is printed only, not returned.
  const bool says_little = startsWith(message, "Error reading") || startsWith(message, "Unable to read");
  throw LoadError(file, place, says_little && !printed.empty() ? withoutFullStop(printed.front()) : message);
}
}  // namespace

sdf::ParserConfig parserConfig()
{
  sdf::ParserConfig config;
  config.SetUnrecognizedElementsPolicy(sdf::EnforcementPolicy::ERR);
  return config;
}

void checkSdfErrors(
  const sdf::Errors & errors, const SdfMessages & messages, const sdf::Root & root, const std::string & file,
  const std::string & uri_hint, WarningCollector & warnings)
{
  const std::vector<std::string> printed = messages.errors();
  for (const std::string & line : printed) {
    if (startsWith(line, "Error parsing XML")) {
      throwMalformed(file, line);
    }
  }
  for (const sdf::Error & error : errors) {
    if (!becomesWarning(error, root, file, warnings)) {
      throwError(error, printed, root, file, uri_hint);
    }
  }
  if (!printed.empty()) {
    throw LoadError(file, "", withoutFullStop(printed.front()));
  }
  for (const std::string & warning : messages.warnings()) {
    warnings.add(warning, file);
  }
}
}  // namespace f1tenth_sim2d
