#include "loaders/xml/element.h"

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <cmath>
#include <sstream>

#include "f1tenth_sim2d/errors.h"
#include "loaders/files/farthest.h"
#include "loaders/xml/xml_document.h"
#include "loaders/xml/xml_text.h"

namespace f1tenth_sim2d
{
namespace
{
using tinyxml2::XMLElement;

constexpr double kFastest = 1e6;  // Hz: no physics step is as short as its period

const char * nameOf(const XMLElement & node)
{
  const bool is_extension = node.Name() == std::string("gazebo");
  return node.Attribute(is_extension ? "reference" : "name");
}

/// "link[base]", "include[0]"; elements without name are counted where there are several.
std::string pathPart(const XMLElement & node)
{
  if (const char * const name = nameOf(node)) {
    return node.Name() + ("[" + std::string(name) + "]");
  }
  int index = 0;
  const XMLElement * sibling = node.PreviousSiblingElement(node.Name());
  for (; sibling; sibling = sibling->PreviousSiblingElement(node.Name())) {
    ++index;
  }
  const bool is_counted = index > 0 || node.NextSiblingElement(node.Name()) || node.Name() == std::string("include");
  return node.Name() + (is_counted ? "[" + std::to_string(index) + "]" : "");
}
}  // namespace

std::string Element::attribute(const char * attribute) const
{
  const char * const text = node_ ? node_->Attribute(attribute) : nullptr;
  return text ? boost::algorithm::trim_copy(std::string(text)) : "";
}

std::string Element::text() const
{
  const char * const text = node_ ? node_->GetText() : nullptr;
  return text ? boost::algorithm::trim_copy(std::string(text)) : "";
}

std::string Element::value() const
{
  return has("value") ? attribute("value") : text();
}

std::vector<std::string> Element::attributes() const
{
  std::vector<std::string> names;
  for (auto attribute = node_ ? node_->FirstAttribute() : nullptr; attribute; attribute = attribute->Next()) {
    names.emplace_back(attribute->Name());
  }
  return names;
}

Element Element::child(const char * tag) const
{
  const XMLElement * const child = node_ ? node_->FirstChildElement(tag) : nullptr;
  return child ? Element(child, document_) : Element();
}

std::vector<Element> Element::children(const char * tag) const
{
  std::vector<Element> found;
  for (auto child = node_ ? node_->FirstChildElement(tag) : nullptr; child; child = child->NextSiblingElement(tag)) {
    found.emplace_back(child, document_);
  }
  return found;
}

Element Element::root() const
{
  return {document_->text.RootElement(), document_};
}

std::string Element::path() const
{
  std::string path;
  for (const tinyxml2::XMLNode * node = node_; node && node->ToElement(); node = node->Parent()) {
    if (const XMLElement & element = *node->ToElement(); element.Name() != std::string("sdf")) {
      path = pathPart(element) + (path.empty() ? "" : "/") + path;
    }
  }
  return path.empty() ? tag() : path;
}

std::string Element::place() const
{
  return document_->file + ": " + path();
}

std::string Element::fileLine() const
{
  return document_->file + ":" + std::to_string(node_->GetLineNum()) + ": " + path();
}

void Element::fail(const std::string & reason) const
{
  const std::string & includer = document_->included_by;
  throw LoadError(document_->file, path(), reason + (includer.empty() ? "" : "; included by " + includer));
}

Element Element::descend(const std::string & path) const
{
  Element found = *this;
  std::istringstream tags(path);
  for (std::string tag; std::getline(tags, tag, '/');) {
    found = found.child(tag.c_str());
  }
  return found;
}

std::string Element::textOf(const char * tag, const std::string & fallback) const
{
  const std::string text = child(tag).text();
  return text.empty() ? fallback : text;
}

std::string Element::requiredText(const char * tag) const
{
  if (!child(tag)) {
    fail("has no <" + std::string(tag) + ">");
  }
  const std::string text = child(tag).text();
  if (text.empty()) {
    fail("<" + std::string(tag) + "> is empty");
  }
  return text;
}

std::string Element::requiredAttribute(const char * attribute) const
{
  if (!has(attribute)) {
    fail("has no attribute '" + std::string(attribute) + "'");
  }
  return this->attribute(attribute);
}

double Element::toNumber(const std::string & what, const std::string & text) const
{
  const std::optional<double> number = numberIn(text);
  if (!number) {
    fail(what + " is '" + text + "', which is no number");
  }
  return *number;
}

double Element::number(const std::string & tag, std::optional<double> fallback) const
{
  const Element child = descend(tag);
  if (!child && !fallback) {
    fail("has no <" + tag + ">");
  }
  return child ? toNumber("<" + tag + ">", child.text()) : *fallback;
}

double Element::notNegative(const std::string & tag, double fallback) const
{
  const double value = number(tag, fallback);
  requireNotNegative("<" + tag + ">", value);
  return value;
}

double Element::rate(const std::string & tag, double fallback) const
{
  const double value = notNegative(tag, fallback);
  if (value > kFastest) {
    fail("<" + tag + "> is " + toText(value) + ", allowed is at most " + toText(kFastest) + " Hz");
  }
  return value;
}

double Element::length(const std::string & tag) const
{
  const double value = number(tag);
  requireLength("<" + tag + ">", value);
  return value;
}

bool Element::flag(const char * tag, bool fallback) const
{
  return toFlag("<" + std::string(tag) + ">", child(tag).text(), fallback);
}

bool Element::flagAttribute(const char * attribute, bool fallback) const
{
  return toFlag("attribute '" + std::string(attribute) + "'", this->attribute(attribute), fallback);
}

bool Element::toFlag(const std::string & what, const std::string & given, bool fallback) const
{
  const std::string text = boost::algorithm::to_lower_copy(given);
  if (text.empty()) {
    return fallback;
  }
  const bool is_true = text == "true" || text == "1";
  if (!is_true && text != "false" && text != "0") {
    fail(what + " is '" + text + "', allowed are true, false, 1 and 0");
  }
  return is_true;
}

Eigen::Vector3d Element::vector(const char * tag, const Eigen::Vector3d & fallback) const
{
  return child(tag) ? toVector("<" + std::string(tag) + ">", child(tag).text()) : fallback;
}

double Element::numberAttribute(const char * attribute, std::optional<double> fallback) const
{
  if (!has(attribute) && fallback) {
    return *fallback;
  }
  return toNumber("attribute '" + std::string(attribute) + "'", requiredAttribute(attribute));
}

Eigen::Vector3d Element::toVector(const std::string & what, const std::string & text) const
{
  const auto numbers = numbersIn(text);
  if (!numbers || numbers->size() != 3) {
    fail(what + " is '" + text + "', allowed are three numbers");
  }
  return {numbers->at(0), numbers->at(1), numbers->at(2)};
}

void Element::requirePositive(const std::string & what, double value) const
{
  if (!std::isfinite(value) || value <= 0.0) {
    fail(what + " is " + toText(value) + ", allowed are finite numbers greater than 0");
  }
}

void Element::requireNotNegative(const std::string & what, double value) const
{
  if (!std::isfinite(value) || value < 0.0) {
    fail(what + " is " + toText(value) + ", allowed are finite numbers from 0");
  }
}

void Element::requireLength(const std::string & what, double value) const
{
  requirePositive(what, value);
  if (value > kFarthest) {
    fail(what + " is " + toText(value) + ", allowed is at most " + toText(kFarthest) + " m");
  }
}

void Element::requireNear(const Eigen::Vector3d & place) const
{
  if (!place.allFinite() || place.cwiseAbs().maxCoeff() > kFarthest) {
    fail("is not within " + toText(kFarthest) + " m of the origin");
  }
}
}  // namespace f1tenth_sim2d
