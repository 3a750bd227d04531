#include "search/curves.h"

#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>

#include <optional>

namespace move_base
{
namespace
{
namespace ob = ompl::base;

// Dubins words are written with three letters, Reeds-Shepp words with up to five; a length below this is an empty letter.
constexpr double kEmptyArc = 1e-6;

void assign(ob::State * state, const Pose2 & pose)
{
  auto * se2 = state->as<ob::SE2StateSpace::StateType>();
  se2->setXY(pose.x, pose.y);
  se2->setYaw(pose.yaw);
}
}  // namespace

class ShortestCurves::Impl
{
public:
  Impl(double minimum_radius, bool allow_reversing)
  : radius_(minimum_radius), allow_reversing_(allow_reversing), dubins_(minimum_radius), reeds_shepp_(minimum_radius)
  {
    from_ = dubins_.allocState();
    to_ = dubins_.allocState();
  }
  ~Impl()
  {
    dubins_.freeState(from_);
    dubins_.freeState(to_);
  }
  Impl(const Impl &) = delete;
  Impl & operator=(const Impl &) = delete;

  double length(const Pose2 & from, const Pose2 & to)
  {
    assign(from_, from);
    assign(to_, to);
    return radius_ *
           (allow_reversing_ ? reeds_shepp_.reedsShepp(from_, to_).length() : dubins_.dubins(from_, to_).length());
  }

  std::vector<Arc> arcs(const Pose2 & from, const Pose2 & to)
  {
    assign(from_, from);
    assign(to_, to);
    return allow_reversing_ ? reedsSheppArcs() : dubinsArcs();
  }

private:
  std::vector<Arc> dubinsArcs()
  {
    const ob::DubinsStateSpace::DubinsPath path = dubins_.dubins(from_, to_);
    std::vector<Arc> arcs;
    for (int i = 0; i < 3; ++i) {
      const bool left = path.type_[i] == ob::DubinsStateSpace::DUBINS_LEFT;
      const bool right = path.type_[i] == ob::DubinsStateSpace::DUBINS_RIGHT;
      append(arcs, path.length_[i], left, right);
    }
    return arcs;
  }

  std::vector<Arc> reedsSheppArcs()
  {
    const ob::ReedsSheppStateSpace::ReedsSheppPath path = reeds_shepp_.reedsShepp(from_, to_);
    std::vector<Arc> arcs;
    for (int i = 0; i < 5; ++i) {
      const bool left = path.type_[i] == ob::ReedsSheppStateSpace::RS_LEFT;
      const bool right = path.type_[i] == ob::ReedsSheppStateSpace::RS_RIGHT;
      append(arcs, path.length_[i], left, right);
    }
    return arcs;
  }

  void append(std::vector<Arc> & arcs, double unit_length, bool left, bool right) const
  {
    if (std::abs(unit_length) > kEmptyArc) {
      arcs.push_back({unit_length * radius_, (left ? 1.0 : right ? -1.0 : 0.0) / radius_});
    }
  }

  double radius_;
  bool allow_reversing_;
  ob::DubinsStateSpace dubins_;
  ob::ReedsSheppStateSpace reeds_shepp_;
  ob::State * from_;
  ob::State * to_;
};

ShortestCurves::ShortestCurves(double minimum_radius, bool allow_reversing)
: impl_(std::make_unique<Impl>(minimum_radius, allow_reversing))
{
}

ShortestCurves::~ShortestCurves() = default;

double ShortestCurves::length(const Pose2 & from, const Pose2 & to) const
{
  return impl_->length(from, to);
}

std::vector<Arc> ShortestCurves::arcs(const Pose2 & from, const Pose2 & to) const
{
  return impl_->arcs(from, to);
}
}  // namespace move_base
