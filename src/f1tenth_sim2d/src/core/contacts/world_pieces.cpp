#include "core/contacts/world_pieces.h"

#include <workspace_support/maths/trigonometry.h>
#include <cmath>
#include <optional>

#include "core/math/planar_pose.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr double kUprightTolerance = 1e-9;

ModelBody bodyOf(const ModelDescription & model)
{
  return model.is_static ? ModelBody{} : ModelBody{planar(model.pose), model.centre_of_mass};
}

Pose3 solidPose(const ModelDescription & model, const Solid & solid)
{
  return (model.is_static ? model.pose : withoutPlanar(model.pose)) * solid.pose;
}

/// Whether the solid looks the same from above whatever part of its height is taken.
bool isUprightPrism(const Solid & solid, const Pose3 & pose)
{
  const Eigen::Vector3d up = pose.climb();
  const bool is_prism = std::holds_alternative<Box>(solid.shape) || std::holds_alternative<Cylinder>(solid.shape) ||
                        std::holds_alternative<Polyline>(solid.shape);
  return is_prism && maths::hypot(up.x(), up.y()) < kUprightTolerance;
}

template <typename Visit>
void forEachSolid(const WorldDescription & world, Visit visit)
{
  for (std::uint32_t m = 0; m < world.models.size(); ++m) {
    const ModelDescription & model = world.models[m];
    for (std::uint32_t s = 0; s < model.solids.size(); ++s) {
      const Pose3 pose = solidPose(model, model.solids[s]);
      const Heights span = heightsOf(model.solids[s].shape, pose);
      if (!span.isEmpty()) {
        visit(model.solids[s], pose, Piece{{}, {}, Piece::Owner::kModel, m, s, span});
      }
    }
  }
}

/// The pieces of the solids for which cut(solid, pose, properties) gives a footprint.
template <typename Cut>
std::unique_ptr<const PieceSet> cutPieces(
  const WorldDescription & world, const std::vector<ModelBody> & bodies, Layer layer, Cut cut)
{
  std::vector<Piece> movable;
  std::vector<Piece> fixed;
  forEachSolid(world, [&](const Solid & solid, const Pose3 & pose, Piece properties) {
    if (const std::optional<Section> footprint = cut(solid, pose, properties)) {
      std::vector<Piece> & pieces = world.models[properties.body].is_static ? fixed : movable;
      appendPieces(pieces, *footprint, bodies[properties.body].centre_of_mass, solid, properties);
    }
  });
  return std::make_unique<PieceSet>(layer, std::move(movable), std::move(fixed));
}

std::vector<ModelBody> bodiesOf(const WorldDescription & world)
{
  std::vector<ModelBody> bodies;
  for (const ModelDescription & model : world.models) {
    bodies.push_back(bodyOf(model));
  }
  return bodies;
}
}  // namespace

WorldPieces::WorldPieces(const WorldDescription & world) : world_(world), bodies_(bodiesOf(world)), whole_(cutWhole())
{
}

std::unique_ptr<const PieceSet> WorldPieces::cutWhole() const
{
  const auto cut = [](const Solid & solid, const Pose3 & pose, Piece & properties) -> std::optional<Section> {
    properties.layer = isUprightPrism(solid, pose) ? Layer::kWholeSolid : Layer::kModelsOnly;
    return footprintBetween(solid, pose, properties.span.lowest, properties.span.highest);
  };
  return cutPieces(world_, bodies_, Layer::kWholeSolid, cut);
}

const PieceSet & WorldPieces::layerFor(const Heights & span) const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const SpanLayer & layer : layers_) {
    if (layer.span.lowest == span.lowest && layer.span.highest == span.highest) {
      return *layer.pieces;
    }
  }
  const auto number = static_cast<Layer>(layers_.size());
  const auto cut = [&](const Solid & solid, const Pose3 & pose, Piece & properties) -> std::optional<Section> {
    if (isUprightPrism(solid, pose) || !overlap(properties.span, span)) {
      return std::nullopt;
    }
    properties.layer = number;
    return footprintBetween(solid, pose, span.lowest, span.highest);
  };
  layers_.push_back({span, cutPieces(world_, bodies_, number, cut)});
  return *layers_.back().pieces;
}
}  // namespace f1tenth_sim2d
