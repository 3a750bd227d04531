#pragma once

#include <Eigen/Core>
#include <sdf/Element.hh>
#include <string>

namespace f1tenth_sim2d
{
/// "world[default]/model[walls]/link[Wall_0]"
std::string elementPath(sdf::ElementPtr element);

/// Text without the blanks around it.
std::string withoutBlanksAround(const std::string & text);

/// Element at the end of a path of tags below element; null if there is none.
sdf::ElementPtr descend(sdf::ElementPtr element, std::initializer_list<const char *> tags);

/// Reads the children of one element, and says where they are when they are wrong.
class ElementReader
{
public:
  /// @param file  what error messages call the file; must outlive the reader
  ElementReader(sdf::ElementPtr element, const std::string & file);

  /// @throws LoadError with file and element path
  [[noreturn]] void fail(const std::string & reason) const;

  /// A child without which SDF would silently take a default.
  template <typename T>
  T required(const std::string & tag) const
  {
    requireGiven(tag);
    return element_->Get<T>(tag);
  }

  /// Text of a child; blanks around it are dropped.
  std::string requiredText(const std::string & tag) const;

  /// Numbers of children.
  double positive(const std::string & tag) const;
  double length(const std::string & tag) const;
  double notNegative(const std::string & tag, double fallback) const;

  /// Checks of numbers that came from elsewhere, said to be those of a tag.
  void requirePositive(const std::string & tag, double value) const;
  void requireNotNegative(const std::string & tag, double value) const;
  /// A length, m: positive and at most 100 km, beyond which nothing is meant and numbers lose their precision.
  void requireLength(const std::string & tag, double value) const;
  /// The same for a place: no coordinate is farther than 100 km from the origin.
  void requireNear(const Eigen::Vector3d & place) const;

  /// Text of a child, blanks around it dropped; the fallback if there is none or it is empty.
  std::string text(const std::string & tag, const std::string & fallback) const;

  /// Three finite numbers in a text, said to be those of a tag.
  Eigen::Vector3d vector(const std::string & numbers, const std::string & tag) const;

  void requireGiven(const std::string & tag) const;

private:
  sdf::ElementPtr element_;
  const std::string & file_;
};
}  // namespace f1tenth_sim2d
