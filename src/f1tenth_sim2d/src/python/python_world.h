#pragma once

#include <optional>
#include <utility>

#include "f1tenth_sim2d/simulation.h"
#include "f1tenth_sim2d/world_model.h"

namespace f1tenth_sim2d
{
/// A world as Python sees it: prepared when the first simulation is built from it, and shared by all.
class PythonWorld
{
public:
  explicit PythonWorld(WorldDescription description) : loaded_(std::move(description)) {}

  const WorldDescription & description() const { return prepared_ ? prepared_->description() : *loaded_; }

  /// @throws Error for what a simulation cannot be built from
  const PreparedWorld & prepared()
  {
    if (!prepared_) {
      prepared_.emplace(*loaded_);
      loaded_.reset();
    }
    return *prepared_;
  }

private:
  std::optional<WorldDescription> loaded_;  // until it is prepared
  std::optional<PreparedWorld> prepared_;
};
}  // namespace f1tenth_sim2d
