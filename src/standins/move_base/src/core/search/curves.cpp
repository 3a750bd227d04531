#include "search/curves.h"

#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>

#include <iterator>

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

template <class Word, class Letter>
std::vector<Arc> arcsOf(const Word & word, Letter left, Letter right, double radius)
{
  std::vector<Arc> arcs;
  for (std::size_t i = 0; i < std::size(word.length_); ++i) {
    if (std::abs(word.length_[i]) > kEmptyArc) {
      const double sense = word.type_[i] == left ? 1.0 : word.type_[i] == right ? -1.0 : 0.0;
      arcs.push_back({word.length_[i] * radius, sense / radius});
    }
  }
  return arcs;
}
}  // namespace

struct ShortestCurves::Spaces
{
  explicit Spaces(double radius)
  : dubins(radius), reeds_shepp(radius), from(dubins.allocState()), to(dubins.allocState())
  {
  }
  ~Spaces()
  {
    dubins.freeState(from);
    dubins.freeState(to);
  }
  Spaces(const Spaces &) = delete;
  Spaces & operator=(const Spaces &) = delete;

  ob::DubinsStateSpace dubins;
  ob::ReedsSheppStateSpace reeds_shepp;
  ob::State * from;
  ob::State * to;
};

ShortestCurves::ShortestCurves(double minimum_radius, bool allow_reversing)
: radius_(minimum_radius), allow_reversing_(allow_reversing), spaces_(std::make_unique<Spaces>(minimum_radius))
{
}

ShortestCurves::~ShortestCurves() = default;

double ShortestCurves::length(const Pose2 & from, const Pose2 & to) const
{
  assign(spaces_->from, from);
  assign(spaces_->to, to);
  return radius_ * (allow_reversing_ ? spaces_->reeds_shepp.reedsShepp(spaces_->from, spaces_->to).length()
                                     : spaces_->dubins.dubins(spaces_->from, spaces_->to).length());
}

std::vector<Arc> ShortestCurves::arcs(const Pose2 & from, const Pose2 & to) const
{
  assign(spaces_->from, from);
  assign(spaces_->to, to);
  if (allow_reversing_) {
    const auto word = spaces_->reeds_shepp.reedsShepp(spaces_->from, spaces_->to);
    return arcsOf(word, ob::ReedsSheppStateSpace::RS_LEFT, ob::ReedsSheppStateSpace::RS_RIGHT, radius_);
  }
  const auto word = spaces_->dubins.dubins(spaces_->from, spaces_->to);
  return arcsOf(word, ob::DubinsStateSpace::DUBINS_LEFT, ob::DubinsStateSpace::DUBINS_RIGHT, radius_);
}
}  // namespace move_base
