#pragma once

#include <optional>
#include <string>
#include <vector>

namespace f1tenth_sim2d
{
/// The words of a text, with blanks between them.
std::vector<std::string> wordsIn(const std::string & text);

/// A number, whatever the locale: digits with sign, point and exponent, "inf" and "nan" too. None for anything
/// else.
std::optional<double> numberIn(const std::string & text);

/// The numbers of a text, with blanks between them. None if one of them is no number.
std::optional<std::vector<double>> numbersIn(const std::string & text);

/// Repairs what XML readers before tinyxml2 accepted and it does not: attributes without quotes or without a value, and
/// a declaration that is not at the beginning. Lines stay where they are.
std::string repairedXml(const std::string & text);
}  // namespace f1tenth_sim2d
