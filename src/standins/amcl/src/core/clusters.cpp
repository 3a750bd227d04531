#include "clusters.h"

#include <workspace_support/maths/trigonometry.h>

#include <cassert>
#include <cmath>
#include <map>
#include <utility>

namespace amcl
{
namespace
{
using Members = std::vector<WeightedPose>;
using Bins = std::map<Bin, Members>;

constexpr double kBinSize = 0.5;                   // m
constexpr double kBinAngle = 10.0 * M_PI / 180.0;  // rad
constexpr long kBinsPerTurn = 36;

void takeNeighbours(Bins & bins, const Bin & centre, std::vector<Bin> & open, Members & members)
{
  for (int i = 0; i < 27; ++i) {
    const long turn = (centre[2] + i / 9 - 1 + kBinsPerTurn) % kBinsPerTurn;
    const auto found = bins.find({centre[0] + i % 3 - 1, centre[1] + i / 3 % 3 - 1, turn});
    if (found != bins.end()) {
      open.push_back(found->first);
      members.insert(members.end(), found->second.begin(), found->second.end());
      bins.erase(found);
    }
  }
}

// Takes a group out of the bins.
Members takeGroup(Bins & bins)
{
  std::vector<Bin> open{bins.begin()->first};
  Members members;
  while (!open.empty()) {
    const Bin centre = open.back();
    open.pop_back();
    takeNeighbours(bins, centre, open, members);
  }
  return members;
}

double weightOf(const Members & members)
{
  double weight = 0.0;
  for (const WeightedPose & member : members) {
    weight += member.weight;
  }
  return weight;
}

Pose2 meanOf(const Members & members, double weight)
{
  Pose2 mean;
  double c = 0.0;
  double s = 0.0;
  for (const WeightedPose & member : members) {
    const maths::SineCosine heading = maths::sineCosine(member.pose.yaw);
    mean.x += member.weight / weight * member.pose.x;
    mean.y += member.weight / weight * member.pose.y;
    c += member.weight * heading.cosine;
    s += member.weight * heading.sine;
  }
  mean.yaw = maths::atan2(s, c);
  return mean;
}

std::array<double, 9> covarianceOf(const Members & members, double weight, const Pose2 & mean)
{
  std::array<double, 9> covariance{};
  for (const WeightedPose & member : members) {
    const Pose2 & pose = member.pose;
    const std::array<double, 3> offset{pose.x - mean.x, pose.y - mean.y, normalizeAngle(pose.yaw - mean.yaw)};
    for (int i = 0; i < 9; ++i) {
      covariance[i] += member.weight / weight * offset[i / 3] * offset[i % 3];
    }
  }
  return covariance;
}
}  // namespace

Bin binOf(const Pose2 & pose)
{
  const long turn = static_cast<long>(std::floor(pose.yaw / kBinAngle));
  return {
    static_cast<long>(std::floor(pose.x / kBinSize)), static_cast<long>(std::floor(pose.y / kBinSize)),
    (turn % kBinsPerTurn + kBinsPerTurn) % kBinsPerTurn};
}

Estimate heaviestCluster(const std::vector<WeightedPose> & particles)
{
  assert(!particles.empty());
  Bins bins;
  for (const WeightedPose & particle : particles) {
    bins[binOf(particle.pose)].push_back(particle);
  }
  Members heaviest;
  double greatest = -1.0;
  while (!bins.empty()) {
    Members group = takeGroup(bins);
    const double weight = weightOf(group);
    if (weight > greatest) {
      greatest = weight;
      heaviest = std::move(group);
    }
  }
  const Pose2 mean = meanOf(heaviest, greatest);
  return {mean, covarianceOf(heaviest, greatest, mean)};
}
}  // namespace amcl
