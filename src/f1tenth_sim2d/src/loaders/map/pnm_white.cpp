#include "loaders/map/pnm_white.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
namespace
{
bool isSpace(char letter)
{
  return std::isspace(static_cast<unsigned char>(letter)) != 0;
}

/// Where the next word of the header begins.
std::size_t afterBlanks(const std::string & bytes, std::size_t at)
{
  while (at < bytes.size() && (isSpace(bytes[at]) || bytes[at] == '#')) {
    at = bytes[at] == '#' ? std::min(bytes.find('\n', at), bytes.size()) : at + 1;
  }
  return at;
}

std::size_t afterWord(const std::string & bytes, std::size_t at)
{
  const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(at);
  return static_cast<std::size_t>(std::find_if(begin, bytes.end(), isSpace) - bytes.begin());
}
}  // namespace

unsigned takeWhite(const std::string & path, std::string & bytes)
{
  if (bytes[1] == '1' || bytes[1] == '4') {  // bitmaps
    return 255;
  }
  const std::size_t width = afterBlanks(bytes, 2);
  const std::size_t height = afterBlanks(bytes, afterWord(bytes, width));
  const std::size_t begin = afterBlanks(bytes, afterWord(bytes, height));
  const std::size_t size = afterWord(bytes, begin) - begin;
  const std::string found = bytes.substr(begin, std::min<std::size_t>(size, 20));
  const long white = std::atol(found.c_str());
  if ((white < 1 || white > 255) && white != 65535) {
    throw LoadError(path, "", "PNM image: its greatest value is '" + found + "', allowed are 1 to 255, and 65535");
  }
  if (white >= 255) {
    return 255;
  }
  bytes.replace(begin, size, "255");
  return static_cast<unsigned>(white);
}
}  // namespace f1tenth_sim2d
