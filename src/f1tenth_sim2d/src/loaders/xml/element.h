#pragma once

#include <tinyxml2.h>

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace f1tenth_sim2d
{
struct XmlDocument;

/// An element of an XML document, or none. Reading a child that is not there gives none, so that paths can be followed
/// without checking at each step. Errors name the place.
class Element
{
public:
  Element() = default;
  Element(const tinyxml2::XMLElement * node, const XmlDocument * document) : node_(node), document_(document) {}

  explicit operator bool() const { return node_ != nullptr; }

  std::string tag() const { return node_ ? node_->Name() : ""; }
  bool is(const char * tag) const { return node_ && node_->Name() == std::string(tag); }

  std::vector<std::string> attributes() const;  ///< their names
  bool has(const char * attribute) const { return node_ && node_->Attribute(attribute); }
  std::string attribute(const char * attribute) const;  ///< without surrounding blanks; empty if there is none
  std::string name() const { return attribute("name"); }
  std::string text() const;   ///< without surrounding blanks
  std::string value() const;  ///< the attribute `value` or else the text, as tags of a URDF are written

  Element child(const char * tag) const;
  std::vector<Element> children(const char * tag = nullptr) const;  ///< all of them, or those of one tag
  Element root() const;

  const XmlDocument & document() const { return *document_; }
  std::string path() const;      ///< "world[default]/model[walls]/link[Wall_0]"
  std::string place() const;     ///< "FILE: PATH"
  std::string fileLine() const;  ///< "FILE:LINE: PATH"

  /// @throws LoadError "FILE: PATH: reason"
  [[noreturn]] void fail(const std::string & reason) const;

  /// Texts of children.
  std::string textOf(const char * tag, const std::string & fallback) const;  ///< the fallback also if it is empty
  std::string requiredText(const char * tag) const;
  std::string requiredAttribute(const char * attribute) const;

  /// Numbers of children; a path of tags ("range/min") follows children of children. Required without a fallback.
  double number(const std::string & tag, std::optional<double> fallback = std::nullopt) const;
  double notNegative(const std::string & tag, double fallback) const;  ///< finite
  double rate(const std::string & tag, double fallback) const;         ///< Hz, at most 1e6; 0: at every physics step
  double length(const std::string & tag) const;  ///< m, positive and at most 100 km: beyond it numbers lose precision
  bool flag(const char * tag, bool fallback) const;
  Eigen::Vector3d vector(const char * tag, const Eigen::Vector3d & fallback) const;

  /// The same for attributes, and for texts, which messages call `what`.
  double numberAttribute(const char * attribute, std::optional<double> fallback = std::nullopt) const;
  bool flagAttribute(const char * attribute, bool fallback) const;
  double toNumber(const std::string & what, const std::string & text) const;
  Eigen::Vector3d toVector(const std::string & what, const std::string & text) const;

  void requirePositive(const std::string & what, double value) const;
  void requireNotNegative(const std::string & what, double value) const;
  void requireLength(const std::string & what, double value) const;
  void requireNear(const Eigen::Vector3d & place) const;  ///< no coordinate is farther than 100 km from the origin

private:
  bool toFlag(const std::string & what, const std::string & text, bool fallback) const;
  Element descend(const std::string & path) const;

  const tinyxml2::XMLElement * node_{nullptr};
  const XmlDocument * document_{nullptr};
};
}  // namespace f1tenth_sim2d
