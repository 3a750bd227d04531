#include "loaders/sdf/element_reader.h"

#include <cmath>
#include <sstream>

#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr double kFarthest = 1e5;  // m

std::string toText(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}
}  // namespace

std::string withoutBlanksAround(const std::string & text)
{
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

std::string elementPath(sdf::ElementPtr element)
{
  std::string path;
  for (; element && element->GetName() != "sdf"; element = element->GetParent()) {
    const std::string name = element->HasAttribute("name") ? "[" + element->Get<std::string>("name") + "]" : "";
    path = element->GetName() + name + (path.empty() ? "" : "/") + path;
  }
  return path;
}

sdf::ElementPtr descend(sdf::ElementPtr element, std::initializer_list<const char *> tags)
{
  for (const char * const tag : tags) {
    if (!element || !element->HasElement(tag)) {
      return nullptr;
    }
    element = element->GetElement(tag);
  }
  return element;
}

ElementReader::ElementReader(sdf::ElementPtr element, const std::string & file)
: element_(std::move(element)), file_(file)
{
}

void ElementReader::fail(const std::string & reason) const
{
  throw LoadError(file_, elementPath(element_), reason);
}

void ElementReader::requireGiven(const std::string & tag) const
{
  if (!element_->HasElement(tag) || !element_->GetElement(tag)->GetExplicitlySetInFile()) {
    fail("has no <" + tag + ">");
  }
}

std::string ElementReader::requiredText(const std::string & tag) const
{
  const std::string text = withoutBlanksAround(required<std::string>(tag));
  if (text.empty()) {
    fail("<" + tag + "> is empty");
  }
  return text;
}

std::string ElementReader::text(const std::string & tag, const std::string & fallback) const
{
  const std::string text = withoutBlanksAround(element_->Get<std::string>(tag, fallback).first);
  return text.empty() ? fallback : text;
}

Eigen::Vector3d ElementReader::vector(const std::string & numbers, const std::string & tag) const
{
  std::istringstream stream(numbers);
  Eigen::Vector3d vector = Eigen::Vector3d::Zero();
  std::string rest;
  if (!(stream >> vector.x() >> vector.y() >> vector.z()) || stream >> rest) {
    fail("<" + tag + "> is '" + numbers + "', allowed are three numbers");
  }
  return vector;
}

double ElementReader::positive(const std::string & tag) const
{
  const auto value = required<double>(tag);
  requirePositive(tag, value);
  return value;
}

double ElementReader::notNegative(const std::string & tag, double fallback) const
{
  const double value = element_->Get<double>(tag, fallback).first;
  requireNotNegative(tag, value);
  return value;
}

void ElementReader::requirePositive(const std::string & tag, double value) const
{
  if (!std::isfinite(value) || value <= 0.0) {
    fail("<" + tag + "> is " + toText(value) + ", allowed are finite numbers greater than 0");
  }
}

double ElementReader::length(const std::string & tag) const
{
  const auto value = required<double>(tag);
  requireLength(tag, value);
  return value;
}

void ElementReader::requireLength(const std::string & tag, double value) const
{
  requirePositive(tag, value);
  if (value > kFarthest) {
    fail("<" + tag + "> is " + toText(value) + ", allowed is at most " + toText(kFarthest) + " m");
  }
}

void ElementReader::requireNear(const Eigen::Vector3d & place) const
{
  if (!place.allFinite() || place.cwiseAbs().maxCoeff() > kFarthest) {
    fail("is not within " + toText(kFarthest) + " m of the origin");
  }
}

void ElementReader::requireNotNegative(const std::string & tag, double value) const
{
  if (!std::isfinite(value) || value < 0.0) {
    fail("<" + tag + "> is " + toText(value) + ", allowed are finite numbers from 0");
  }
}
}  // namespace f1tenth_sim2d
