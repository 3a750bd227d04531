#include <algorithm>
#include <cctype>

#include "f1tenth_sim2d/errors.h"
#include "loaders/map/map_image.h"

namespace f1tenth_sim2d
{
namespace
{
/// Numbers of a PGM file, with white space and comments between them.
class PgmReader
{
public:
  PgmReader(const std::string & path, const std::string & bytes) : path_(path), bytes_(bytes) {}

  std::size_t number(const char * what, std::size_t max)
  {
    skipBlanks();
    std::size_t value = 0;
    const std::size_t begin = at_;
    for (; at_ < bytes_.size() && std::isdigit(static_cast<unsigned char>(bytes_[at_])) != 0; ++at_) {
      value = value * 10 + static_cast<std::size_t>(bytes_[at_] - '0');
      if (value > max) {
        fail(std::string(what) + " is above " + std::to_string(max));
      }
    }
    if (at_ == begin) {
      fail(at_ == bytes_.size() ? "ends too early" : std::string(what) + " is not a number");
    }
    return value;
  }

  std::size_t binary(std::size_t size)
  {
    if (bytes_.size() - at_ < size) {
      fail("ends too early");
    }
    std::size_t value = 0;
    for (; size > 0; --size) {
      value = value << 8 | static_cast<unsigned char>(bytes_[at_++]);
    }
    return value;
  }

  /// The one blank between the header and binary pixels.
  void skipOne() { at_ = std::min(at_ + 1, bytes_.size()); }

private:
  [[noreturn]] void fail(const std::string & reason) const { throw LoadError(path_, "", "PGM image: " + reason); }

  void skipBlanks()
  {
    while (at_ < bytes_.size() && (std::isspace(static_cast<unsigned char>(bytes_[at_])) != 0 || bytes_[at_] == '#')) {
      at_ = bytes_[at_] == '#' ? std::min(bytes_.find('\n', at_), bytes_.size()) : at_ + 1;
    }
  }

  const std::string & path_;
  const std::string & bytes_;
  std::size_t at_{2};
};
}  // namespace

MapImage readPgm(const std::string & path, const std::string & bytes)
{
  PgmReader reader(path, bytes);
  MapImage image;
  image.width = reader.number("the width", 1'000'000);
  image.height = reader.number("the height", 1'000'000);
  requireMapSize(path, image.width, image.height);
  const std::size_t white = reader.number("the greatest value", 65535);
  if (white == 0) {
    throw LoadError(path, "", "PGM image: the greatest value is 0, allowed are 1 to 65535");
  }
  const bool is_text = bytes[1] == '2';
  reader.skipOne();
  const std::size_t count = image.width * image.height;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t value = is_text ? reader.number("a pixel", white) : reader.binary(white < 256 ? 1 : 2);
    image.samples.push_back(static_cast<std::uint8_t>(std::min(value, white) * 255 / white));
  }
  return image;
}
}  // namespace f1tenth_sim2d
