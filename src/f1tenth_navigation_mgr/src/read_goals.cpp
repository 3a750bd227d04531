#include <workspace_support/maths/trigonometry.h>
#include <array>
#include <boost/algorithm/string/join.hpp>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>

#include "f1tenth_navigation_mgr/goals_file.h"

namespace f1tenth_navigation_mgr
{
namespace
{
// Files written with two decimals are off by at most this much.
constexpr double kQuaternionTolerance{0.01};

namespace maths = workspace_support::maths;
using boost::algorithm::join;

constexpr const char * kForms{R"("x y yaw" or "x y z qx qy qz qw")"};
constexpr std::array<const char *, 3> kPlanarNames{"x", "y", "yaw"};
constexpr std::array<const char *, 7> kFullNames{"x", "y", "z", "qx", "qy", "qz", "qw"};

std::vector<std::string> fieldsOf(const std::string & line)
{
  std::istringstream stream{line.substr(0, line.find('#'))};
  std::vector<std::string> fields;
  for (std::string field; stream >> field;) fields.push_back(field);
  return fields;
}

/// In quotes, with anything but printable ASCII as \xNN: a message is one line of text, whatever a file holds.
std::string inQuotes(const std::string & text)
{
  constexpr const char * kDigits = "0123456789abcdef";
  std::string shown{'"'};
  for (const char each : text) {
    const auto code = static_cast<unsigned char>(each);
    if (code >= 0x20 && code < 0x7f) {
      shown += each;
    } else {
      shown.append({'\\', 'x', kDigits[code / 16], kDigits[code % 16]});
    }
  }
  return shown + '"';
}

/// What editors on Windows write before UTF-8.
constexpr char kByteOrderMark[] = "\xEF\xBB\xBF";

/// Reads one file line by line; every error names the line that is being read.
class Reader
{
public:
  Reader(std::string name, const std::vector<std::string> & known_frames)
  : name_{std::move(name)}, known_frames_{known_frames}
  {
  }

  Goals read(std::istream & text)
  {
    for (std::string line; std::getline(text, line);) {
      if (++line_ == 1 && line.rfind(kByteOrderMark, 0) == 0) line.erase(0, std::strlen(kByteOrderMark));
      const auto fields = fieldsOf(line);
      if (!fields.empty()) readLine(fields);
    }
    if (text.bad()) throw GoalsFileError{name_ + ": cannot be read: " + std::strerror(errno)};
    if (goals_.empty()) throw GoalsFileError{name_ + ": no goals in the file; expected lines of " + kForms};
    return goals_;
  }

private:
  [[noreturn]] void fail(const std::string & what) const
  {
    throw GoalsFileError{name_ + ":" + std::to_string(line_) + ": " + what};
  }

  void readLine(const std::vector<std::string> & fields)
  {
    if (fields.front() == "frame_id:") {
      readFrame(fields);
    } else {
      goals_.push_back(readGoal(fields));
    }
    at_first_entry_ = false;
  }

  void readFrame(const std::vector<std::string> & fields)
  {
    if (!at_first_entry_) fail("frame_id must stand before everything else, and once");
    frame_id_ = join(std::vector<std::string>{fields.begin() + 1, fields.end()}, " ");
    for (const auto & known : known_frames_) {
      if (frame_id_ == known) return;
    }
    fail("unknown frame " + inQuotes(frame_id_) + ", expected one of: " + join(known_frames_, ", "));
  }

  Goal readGoal(const std::vector<std::string> & fields) const
  {
    if (fields.size() == kPlanarNames.size()) {
      const auto n = readNumbers(fields, kPlanarNames);
      return PlanarGoal(n[0], n[1], n[2], frame_id_);
    }
    if (fields.size() == kFullNames.size()) {
      const auto n = readNumbers(fields, kFullNames);
      checkQuaternion(n);
      return Goal{frame_id_, n[0], n[1], n[2], n[3], n[4], n[5], n[6]};
    }
    const std::string wrong{
      fields.size() < 3   ? "too few numbers"
      : fields.size() > 7 ? "too many numbers"
                          : "wrong count of numbers"};
    fail(wrong + ": " + std::to_string(fields.size()) + ", expected 3 or 7: " + kForms);
  }

  template <std::size_t N>
  std::array<double, N> readNumbers(
    const std::vector<std::string> & fields, const std::array<const char *, N> & names) const
  {
    std::array<double, N> numbers{};
    for (std::size_t i = 0; i < N; ++i) numbers[i] = readNumber(fields[i], names[i]);
    return numbers;
  }

  double readNumber(const std::string & field, const std::string & name) const
  {
    // from_chars, because strtod reads "1,5" or "1.5" depending on the locale; it knows no plus sign.
    const char * begin = field.data() + (field.size() > 1 && field[0] == '+' && field[1] != '-' ? 1 : 0);
    const char * end = field.data() + field.size();
    double value{0.0};
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (error == std::errc::result_out_of_range && stop == end) fail(name + " is out of range: " + field);
    if (error != std::errc{} || stop != end) fail(name + " is not a number: " + inQuotes(field));
    if (!std::isfinite(value)) fail(name + " is not finite: " + field);
    return value;
  }

  void checkQuaternion(const std::array<double, 7> & n) const
  {
    const double length = maths::hypot(maths::hypot(n[3], n[4]), maths::hypot(n[5], n[6]));
    if (std::abs(length - 1.0) <= kQuaternionTolerance) return;
    std::ostringstream text;
    text << "qx qy qz qw is not a unit quaternion: its length is " << length << ", expected 1 within "
         << kQuaternionTolerance;
    fail(text.str());
  }

  const std::string name_;
  const std::vector<std::string> & known_frames_;
  std::size_t line_{0};
  bool at_first_entry_{true};
  std::string frame_id_{"map"};
  Goals goals_;
};
}  // namespace

Goals LoadGoalsFile(const std::string & path, const std::vector<std::string> & known_frames)
{
  errno = 0;
  std::ifstream file{path};
  if (!file) throw GoalsFileError{path + ": cannot be read: " + std::strerror(errno)};
  return Reader{path, known_frames}.read(file);
}
}  // namespace f1tenth_navigation_mgr
