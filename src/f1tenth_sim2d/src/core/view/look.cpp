#include <exception>

#include "f1tenth_sim2d/visual.h"
#include "render/scene.h"

namespace f1tenth_sim2d
{
const Appearance & Look::appearance() const
{
  std::call_once(once_, [this] {
    try {
      appearance_ = std::make_shared<const Appearance>(read());
    } catch (const std::exception & error) {
      appearance_ = std::make_shared<const Appearance>(Appearance{{}, std::string(error.what()) + ": not drawn"});
    }
  });
  return *appearance_;
}
}  // namespace f1tenth_sim2d
