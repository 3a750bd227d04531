#include <algorithm>
#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <cmath>
#include <sstream>

#include "f1tenth_sim2d/errors.h"
#include "f1tenth_sim2d/loaders.h"
#include "loaders/files/files.h"
#include "loaders/xml/xml_text.h"

namespace f1tenth_sim2d
{
namespace
{
const char * const kByteOrderMark = "\xEF\xBB\xBF";
const char * const kAllowed =
  "allowed is x_m, y_m, w_tr_right_m, w_tr_left_m (or x_m, y_m alone) in every line, finite, with points in numbers, "
  "and widths greater than 0";

using Row = std::vector<double>;

/// The numbers of a line; empty if one is none.
Row numbersOf(const std::string & line)
{
  std::vector<std::string> parts;
  boost::algorithm::split(parts, line, boost::algorithm::is_any_of(","));
  Row row;
  for (const std::string & part : parts) {
    const std::optional<double> number = numberIn(boost::algorithm::trim_copy(part));
    if (!number || !std::isfinite(*number)) {
      return {};
    }
    row.push_back(*number);
  }
  return row;
}

bool isSound(const Row & row)
{
  return row.size() == 2 || (row.size() == 4 && row[2] > 0.0 && row[3] > 0.0);
}

/// Recorders of waypoints log a car that stands many times, and some files close the line with its first point.
void dropRepeated(std::vector<CentrelinePoint> & points)
{
  const auto isSame = [](const CentrelinePoint & a, const CentrelinePoint & b) { return a.x == b.x && a.y == b.y; };
  points.erase(std::unique(points.begin(), points.end(), isSame), points.end());
  while (points.size() > 1 && isSame(points.front(), points.back())) {
    points.pop_back();
  }
}
}  // namespace

Centreline readCentreline(const std::string & path)
{
  std::string text = readFile(path);
  if (boost::algorithm::starts_with(text, kByteOrderMark)) {
    text.erase(0, std::string(kByteOrderMark).size());
  }
  Centreline centreline;
  std::size_t columns = 0;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    const std::string text_only = boost::algorithm::trim_copy(line.substr(0, line.find('#')));
    if (text_only.empty()) {
      continue;
    }
    const Row row = numbersOf(text_only);
    columns = columns == 0 ? row.size() : columns;
    if (!isSound(row) || row.size() != columns) {
      throw LoadError(path + ":" + std::to_string(number), "", "found '" + text_only + "', " + kAllowed);
    }
    centreline.points.push_back({row[0], row[1], columns > 2 ? row[2] : 0.0, columns > 2 ? row[3] : 0.0});
  }
  dropRepeated(centreline.points);
  if (centreline.points.size() < 2) {
    throw LoadError(
      path, "", "has " + std::to_string(centreline.points.size()) + " different points, allowed are 2 or more");
  }
  centreline.has_widths = columns > 2;
  return centreline;
}
}  // namespace f1tenth_sim2d
