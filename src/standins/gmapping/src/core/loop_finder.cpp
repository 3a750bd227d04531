#include "loop_finder.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "wall_search.h"

namespace gmapping
{
namespace
{
// The search ends within a few centimetres: cells as large as that catch the walls. Finer ones would see the steps
// between the pixels of a wall from a map, and take one for the next.
constexpr double kCell = 0.05;       // m
constexpr double kEvery = 1.0;       // m between searches
constexpr double kEveryKnown = 3.0;  // m, once a loop is known for certain: the next ones only confirm it
constexpr double kLeastLoop = 15.0;  // m driven; what is nearer is in the local map
// Drift of the local poses, as a standard deviation that grows with the way.
constexpr double kLeastDrift = 0.05;      // m
constexpr double kDriftRate = 0.003;      // m per m
constexpr double kLeastTurnDrift = 0.01;  // rad
constexpr double kTurnDriftRate = 2e-4;   // rad per m
constexpr double kGate = 2.5;             // standard deviations that are searched
// m of way before and behind the earlier stop that show what was there. With less before it, points behind the start
// of the map find nothing and pull the last stop ahead.
constexpr double kAround = 8.0;
constexpr double kBehind = 6.0;            // m of way before the last stop that are matched to it
constexpr std::size_t kPoints = 500;       // of them, about, for the search
constexpr std::size_t kMorePoints = 3000;  // for matching: a single scan fits a straight road of pixels at many places
constexpr double kLeastKnown = 0.6;        // share of the points that the earlier map knows anything about
constexpr int kBetweenBeams = 1;           // cells
constexpr double kLeastAgreement = 0.85;   // share of those that fall onto its walls
// A straight road looks alike everywhere: what tells less in one direction than this share of what it tells in the
// other one tells nothing.
constexpr double kLeastHold = 0.2;
// 1/m^2 and 1/rad^2: tells nothing, so that no matrix is singular. What was expected is in the graph already.
constexpr double kUnknown = 1e-4;

void addEnds(const Stop & stop, const Pose2 & pose, std::size_t every, std::vector<Vec2> & points)
{
  const BeamCaster caster(pose);
  for (std::size_t i = 0; i < stop.beams.size(); i += every) {
    points.push_back(caster.along(caster.direction(stop.beams[i]), stop.beams[i].range));
  }
}

/// Ends of beams of the last stops, about as many as are asked for, in the frame of the last one: held together by
/// their local poses.
std::vector<Vec2> recentPoints(const Way & way, std::size_t count)
{
  const Stop & last = way.back();
  const auto first =
    std::find_if(way.begin(), way.end(), [&](const Stop & stop) { return stop.distance >= last.distance - kBehind; });
  std::size_t beams = 0;
  std::for_each(first, way.end(), [&](const Stop & stop) { beams += stop.beams.size(); });
  std::vector<Vec2> points;
  std::for_each(first, way.end(), [&](const Stop & stop) {
    addEnds(stop, compose(inverse(last.local), stop.local), std::max<std::size_t>(1, beams / count), points);
  });
  return points;
}

/// What was seen from the stops about an earlier one, in its frame.
CellMap mapAbout(const Way & way, std::size_t earlier)
{
  CellMap map(kCell);
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    if (std::abs(way[i].distance - way[earlier].distance) <= kAround) {
      const auto farthest = std::max_element(
        way[i].beams.begin(), way[i].beams.end(), [](const Beam & a, const Beam & b) { return a.range < b.range; });
      const double reach = farthest == way[i].beams.end() ? 0.0 : farthest->range;
      registerBeams(map, way[i].beams, compose(inverse(way[earlier].local), way[i].local), reach);
    }
  }
  return map;
}

/// The ends of the beams in it.
std::vector<Vec2> wallsAbout(const Way & way, std::size_t earlier)
{
  std::vector<Vec2> walls;
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    if (std::abs(way[i].distance - way[earlier].distance) <= kAround) {
      addEnds(way[i], compose(inverse(way[earlier].local), way[i].local), 2, walls);
    }
  }
  return walls;
}

/// Beams skip cells between them.
bool isKnown(const CellMap & map, const Cell & place)
{
  for (int dx = -kBetweenBeams; dx <= kBetweenBeams; ++dx) {
    for (int dy = -kBetweenBeams; dy <= kBetweenBeams; ++dy) {
      const MapCell * cell = map.cell({place.x + dx, place.y + dy});
      if (cell != nullptr && cell->visits > 0) {
        return true;
      }
    }
  }
  return false;
}

std::vector<Vec2> knownPoints(const std::vector<Vec2> & points, const Pose2 & pose, const CellMap & map)
{
  std::vector<Vec2> known;
  std::copy_if(points.begin(), points.end(), std::back_inserter(known), [&](const Vec2 & point) {
    return isKnown(map, map.index(transform(pose, point)));
  });
  return known;
}

/// What walls tell of a pose, and whether they hold it in every direction.
struct Hold
{
  Eigen::Matrix3d information;  ///< without the direction along a straight road, if there is nothing else
  bool is_firm{false};
};

Hold holdOf(const Eigen::Matrix3d & information)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(information.topLeftCorner<2, 2>());
  if (solver.eigenvalues().x() >= kLeastHold * solver.eigenvalues().y()) {
    return {information, true};
  }
  Eigen::Matrix3d across = Eigen::Matrix3d::Identity();
  across.topLeftCorner<2, 2>() -= solver.eigenvectors().col(0) * solver.eigenvectors().col(0).transpose();
  return {across * information * across, false};
}
}  // namespace

std::optional<PoseEdge> LoopFinder::find(const Way & way, const std::vector<Pose2> & poses)
{
  if (way.back().distance - last_search_ < (last_ ? kEveryKnown : kEvery)) {
    return std::nullopt;
  }
  const auto earlier = earlierStop(way, poses);
  if (!earlier) {
    return std::nullopt;
  }
  last_search_ = way.back().distance;
  return match(way, poses, *earlier, doubt(way, *earlier));
}

LoopFinder::Doubt LoopFinder::doubt(const Way & way, std::size_t earlier) const
{
  const double way_between = way.back().distance - std::max(way[earlier].distance, last_.value_or(0.0));
  return {kLeastDrift + kDriftRate * way_between, kLeastTurnDrift + kTurnDriftRate * way_between};
}

/// The one that is believed to be nearest, if it can be here.
std::optional<std::size_t> LoopFinder::earlierStop(const Way & way, const std::vector<Pose2> & poses) const
{
  std::optional<std::size_t> nearest;
  double least = 0.0;
  for (std::size_t i = 0; i < way.size() && way.back().distance - way[i].distance >= kLeastLoop; ++i) {
    const double between = distance(poses[i], poses.back());
    const bool shown = way[i].distance >= kAround;
    const bool reachable = shown && between < kEvery + kGate * doubt(way, i).position;
    if (reachable && (!nearest || between < least)) {
      nearest = i;
      least = between;
    }
  }
  return nearest;
}

std::optional<PoseEdge> LoopFinder::match(
  const Way & way, const std::vector<Pose2> & poses, std::size_t earlier, const Doubt & doubt)
{
  const std::vector<Vec2> walls = wallsAbout(way, earlier);
  const std::vector<Vec2> points = recentPoints(way, kPoints);
  if (walls.empty() || points.empty()) {
    return std::nullopt;
  }
  const Pose2 expected = compose(inverse(poses[earlier]), poses.back());
  const WallSearch search(walls);
  const SearchWindow window{expected, kGate * doubt.position, kGate * doubt.yaw};
  PoseBelief prior{search.best(points, window)};
  const double certainty = 1.0 / (doubt.position * doubt.position);
  prior.information.diagonal() << certainty, certainty, 1.0 / (doubt.yaw * doubt.yaw);
  const CellMap map = mapAbout(way, earlier);
  const PoseBelief matched = matcher_.match(map, recentPoints(way, kMorePoints), prior);
  const std::vector<Vec2> known = knownPoints(points, matched.mean, map);
  const bool agrees = static_cast<double>(known.size()) >= kLeastKnown * static_cast<double>(points.size()) &&
                      search.share(known, matched.mean) >= kLeastAgreement;
  if (!agrees) {
    return std::nullopt;
  }
  const Hold walls_tell = holdOf(matched.information - prior.information);
  if (walls_tell.is_firm) {
    last_ = way.back().distance;
  }
  const Eigen::Matrix3d information = walls_tell.information + kUnknown * Eigen::Matrix3d::Identity();
  return PoseEdge{earlier, way.size() - 1, matched.mean, information, true, walls_tell.is_firm};
}
}  // namespace gmapping
