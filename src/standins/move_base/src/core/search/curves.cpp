#include "move_base/search/curves.h"

#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>

#include <cmath>
#include <iterator>

namespace move_base
{
namespace
{
namespace ob = ompl::base;

// Dubins words are written with three letters, Reeds-Shepp words with up to five; a length below this is an empty letter.
constexpr double kEmptyArc = 1e-6;
// OMPL uses the C library's sine and arc tangent, whose last bits differ between processors. m, far above those bits.
constexpr double kPrecision = 1e-6;

double rounded(double length)
{
  return kPrecision * std::round(length / kPrecision);
}

ob::ScopedState<ob::SE2StateSpace> stateIn(const ob::StateSpacePtr & space, const Pose2 & pose)
{
  ob::ScopedState<ob::SE2StateSpace> state(space);
  state->setXY(pose.x, pose.y);
  state->setYaw(pose.yaw);
  return state;
}

template <class Word, class Letter>
std::vector<Arc> arcsOf(const Word & word, Letter left, Letter right, double radius)
{
  std::vector<Arc> arcs;
  for (std::size_t i = 0; i < std::size(word.length_); ++i) {
    if (std::abs(word.length_[i]) > kEmptyArc) {
      const double sense = word.type_[i] == left ? 1.0 : word.type_[i] == right ? -1.0 : 0.0;
      arcs.push_back({rounded(word.length_[i] * radius), sense / radius});
    }
  }
  return arcs;
}
}  // namespace

ShortestCurves::ShortestCurves(double minimum_radius, bool allow_reversing)
: radius_(minimum_radius),
  allow_reversing_(allow_reversing),
  dubins_(std::make_shared<ob::DubinsStateSpace>(minimum_radius)),
  reeds_shepp_(std::make_shared<ob::ReedsSheppStateSpace>(minimum_radius))
{
}

double ShortestCurves::length(const Pose2 & from, const Pose2 & to) const
{
  const auto start = stateIn(dubins_, from);
  const auto end = stateIn(dubins_, to);
  return rounded(
    allow_reversing_ ? reeds_shepp_->distance(start.get(), end.get()) : dubins_->distance(start.get(), end.get()));
}

std::vector<Arc> ShortestCurves::arcs(const Pose2 & from, const Pose2 & to) const
{
  const auto start = stateIn(dubins_, from);
  const auto end = stateIn(dubins_, to);
  if (allow_reversing_) {
    const auto word = reeds_shepp_->reedsShepp(start.get(), end.get());
    return arcsOf(word, ob::ReedsSheppStateSpace::RS_LEFT, ob::ReedsSheppStateSpace::RS_RIGHT, radius_);
  }
  const auto word = dubins_->dubins(start.get(), end.get());
  return arcsOf(word, ob::DubinsStateSpace::DUBINS_LEFT, ob::DubinsStateSpace::DUBINS_RIGHT, radius_);
}
}  // namespace move_base
