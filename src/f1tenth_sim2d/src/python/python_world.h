#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "f1tenth_sim2d/simulation.h"
#include "f1tenth_sim2d/world_model.h"

namespace f1tenth_sim2d
{
/// A world as Python sees it: prepared when the first simulation is built from it, and shared by all.
class PythonWorld
{
public:
  /// What it is read from; no file for the empty world.
  struct Source
  {
    std::string file;
    std::optional<std::vector<std::string>> model_path;
  };

  PythonWorld(WorldDescription description, Source source) : source_(std::move(source)), loaded_(std::move(description))
  {
  }

  const Source & source() const { return source_; }

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
  Source source_;
  std::optional<WorldDescription> loaded_;  // until it is prepared
  std::optional<PreparedWorld> prepared_;
};
}  // namespace f1tenth_sim2d
