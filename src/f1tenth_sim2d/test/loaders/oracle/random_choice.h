#pragma once

#include <cstdint>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace f1tenth_sim2d
{
/// Choices that follow from a seed alone, on every machine: the distributions of the standard library differ.
class RandomChoice
{
public:
  explicit RandomChoice(std::uint32_t seed) : engine_(seed) {}

  int below(int count) { return static_cast<int>(engine_() % static_cast<std::uint32_t>(count)); }
  bool chance(int percent) { return below(100) < percent; }
  const std::string & of(const std::vector<std::string> & texts)
  {
    return texts[static_cast<std::size_t>(below(static_cast<int>(texts.size())))];
  }

  /// A number with three decimals.
  std::string number(double low, double high)
  {
    std::ostringstream text;
    text << low + (high - low) * below(10001) / 10000.0;
    return text.str();
  }
  std::string numbers(int count, double low, double high)
  {
    std::string text;
    for (int i = 0; i < count; ++i) {
      text += (i > 0 ? " " : "") + number(low, high);
    }
    return text;
  }
  /// "x y z roll pitch yaw", without pitches near the poles, where roll and yaw cannot be told apart.
  std::string pose() { return numbers(3, -5, 5) + " " + number(-3, 3) + " " + number(-1.4, 1.4) + " " + number(-3, 3); }

private:
  std::mt19937 engine_;
};
}  // namespace f1tenth_sim2d
