#pragma once

#include <string>
#include <vector>

namespace f1tenth_sim2d
{
/// Gathers what is left out: one warning per kind, with the first place and how many more there are.
class WarningCollector
{
public:
  /// @param kind  what is left out and why, "<light>: a lidar needs none"
  void add(const std::string & kind, const std::string & place);

  /// "world[default]/light[sun] and 2 more: <light>: ..."
  std::vector<std::string> messages() const;

private:
  struct Entry
  {
    std::string kind;
    std::string first_place;
    int more;
  };
  std::vector<Entry> entries_;
};
}  // namespace f1tenth_sim2d
