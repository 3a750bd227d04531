#pragma once

#include <memory>
#include <utility>

#include "f1tenth_sim2d/plugin.h"
#include "node/messages/output.h"

namespace f1tenth_sim2d
{
/// A plugin among the outputs.
class PluginOutput : public Output
{
public:
  explicit PluginOutput(std::shared_ptr<CarPlugin> plugin) : plugin_(std::move(plugin)) {}
  double rate() const override { return plugin_->updateRate(); }

  void update(SimTime now, bool /*anyway*/) override
  {
    stamp_ = toRosTime(now);
    plugin_->update(stamp_);
  }

  void repeat() override
  {
    if (!stamp_.isZero()) {
      plugin_->update(stamp_);
    }
  }

private:
  const std::shared_ptr<CarPlugin> plugin_;
  ros::Time stamp_;
};
}  // namespace f1tenth_sim2d
