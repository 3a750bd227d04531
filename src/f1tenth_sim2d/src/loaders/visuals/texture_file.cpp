#include "loaders/visuals/texture_file.h"

#include <map>
#include <mutex>

#include "loaders/files/files.h"
#include "loaders/files/pix_file.h"

namespace f1tenth_sim2d
{
namespace
{
Image toImage(const std::string & path)
{
  const PixOwner original = readPix(path, readFile(path));
  const PixOwner direct(pixRemoveColormap(original.get(), REMOVE_CMAP_BASED_ON_SRC));
  const PixOwner pix(pixConvertTo32(direct.get()));
  Image image{static_cast<std::size_t>(pixGetWidth(pix.get())), static_cast<std::size_t>(pixGetHeight(pix.get())), {}};
  image.bytes.reserve(3 * image.width * image.height);
  for (std::size_t row = 0; row < image.height; ++row) {
    const l_uint32 * const words = pixGetData(pix.get()) + row * static_cast<std::size_t>(pixGetWpl(pix.get()));
    for (std::size_t column = 0; column < image.width; ++column) {
      for (const int shift : {L_RED_SHIFT, L_GREEN_SHIFT, L_BLUE_SHIFT}) {
        image.bytes.push_back(static_cast<std::uint8_t>(words[column] >> shift));
      }
    }
  }
  return image;
}
}  // namespace

std::shared_ptr<const Texture> readTexture(const std::string & path)
{
  static std::mutex mutex;
  static std::map<std::string, std::weak_ptr<const Texture>> known;
  const std::lock_guard<std::mutex> lock(mutex);
  std::weak_ptr<const Texture> & entry = known[path];
  std::shared_ptr<const Texture> texture = entry.lock();
  if (!texture) {
    texture = std::make_shared<const Texture>(toImage(path));
    entry = texture;
  }
  return texture;
}
}  // namespace f1tenth_sim2d
