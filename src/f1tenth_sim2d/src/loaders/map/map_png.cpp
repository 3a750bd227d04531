#include <png.h>

#include <csetjmp>
#include <cstring>

#include "f1tenth_sim2d/errors.h"
#include "loaders/map/map_image.h"

namespace f1tenth_sim2d
{
namespace
{
/// A PNG file in memory. libpng reports errors by jumping out, so everything that it may leave behind lives here, and
/// the functions between setjmp and the jump have nothing to destroy.
class PngReader
{
public:
  explicit PngReader(const std::string & bytes) : bytes_(bytes)
  {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, &PngReader::fail, &PngReader::ignore);
    info_ = png_ != nullptr ? png_create_info_struct(png_) : nullptr;
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader &) = delete;
  PngReader & operator=(const PngReader &) = delete;

  /// Width, height and channels. @return whether it worked
  bool readHeader(MapImage & image)
  {
    if (info_ == nullptr || setjmp(png_jmpbuf(png_)) != 0) {
      return false;
    }
    png_set_read_fn(png_, this, &PngReader::take);
    png_read_info(png_, info_);
    toEightBitChannels();
    image.width = png_get_image_width(png_, info_);
    image.height = png_get_image_height(png_, info_);
    image.channels = png_get_channels(png_, info_);
    return true;
  }

  /// @param rows  where each row goes
  bool readRows(std::vector<png_bytep> & rows)
  {
    if (setjmp(png_jmpbuf(png_)) != 0) {
      return false;
    }
    png_read_image(png_, rows.data());
    return true;
  }

  const std::string & message() const { return message_; }

private:
  static void fail(png_structp png, png_const_charp message)
  {
    static_cast<PngReader *>(png_get_error_ptr(png))->message_ = message;
    png_longjmp(png, 1);
  }
  static void ignore(png_structp, png_const_charp) {}

  static void take(png_structp png, png_bytep data, std::size_t size)
  {
    auto & reader = *static_cast<PngReader *>(png_get_io_ptr(png));
    if (reader.bytes_.size() - reader.at_ < size) {
      png_error(png, "ends too early");
    }
    std::memcpy(data, reader.bytes_.data() + reader.at_, size);
    reader.at_ += size;
  }

  void toEightBitChannels()
  {
    png_set_expand(png_);
    png_set_strip_16(png_);
    if (
      (png_get_color_type(png_, info_) & PNG_COLOR_MASK_ALPHA) != 0 || png_get_valid(png_, info_, PNG_INFO_tRNS) != 0) {
      png_set_gray_to_rgb(png_);
    }
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
  }

  const std::string & bytes_;
  std::size_t at_{0};
  std::string message_{"libpng does not start"};
  png_structp png_{nullptr};
  png_infop info_{nullptr};
};
}  // namespace

MapImage readPng(const std::string & path, const std::string & bytes)
{
  PngReader reader(bytes);
  MapImage image;
  if (!reader.readHeader(image)) {
    throw LoadError(path, "", "PNG image: " + reader.message());
  }
  requireMapSize(path, image.width, image.height);
  image.samples.resize(image.width * image.height * image.channels);
  std::vector<png_bytep> rows;
  for (std::size_t row = 0; row < image.height; ++row) {
    rows.push_back(image.samples.data() + row * image.width * image.channels);
  }
  if (!reader.readRows(rows)) {
    throw LoadError(path, "", "PNG image: " + reader.message());
  }
  return image;
}
}  // namespace f1tenth_sim2d
