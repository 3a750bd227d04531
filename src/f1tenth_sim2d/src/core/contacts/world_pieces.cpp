#include "core/contacts/world_pieces.h"

#include "core/math/planar_pose.h"

namespace f1tenth_sim2d
{
namespace
{
using ignition::math::Pose3d;

ModelBody bodyOf(const ModelDescription & model)
{
  if (model.is_static) {
    return {};
  }
  const auto centre = withoutPlanar(model.pose).CoordPositionAdd({model.centre_of_mass.x, model.centre_of_mass.y, 0.0});
  return {planar(model.pose), {centre.X(), centre.Y()}};
}

Pose3d solidPose(const ModelDescription & model, const Solid & solid)
{
  return (model.is_static ? model.pose : withoutPlanar(model.pose)) * solid.pose;
}

void appendPieces(
  std::vector<Piece> & pieces, const Section & footprint, const Vec2 & origin, const Solid & solid,
  const Piece & properties)
{
  for (PieceShape & shape : pieceShapes(footprint, origin)) {
    Piece & piece = pieces.emplace_back(properties);
    piece.shape = shape;
    piece.friction = static_cast<float>(solid.mu);
    piece.restitution = static_cast<float>(solid.restitution);
  }
}

template <typename Visit>
void forEachSolid(const WorldDescription & world, Visit visit)
{
  for (std::uint32_t m = 0; m < world.models.size(); ++m) {
    const ModelDescription & model = world.models[m];
    for (std::uint32_t s = 0; s < model.solids.size(); ++s) {
      const Pose3d pose = solidPose(model, model.solids[s]);
      const VerticalSpan span = verticalSpan(model.solids[s], pose);
      if (span.bottom <= span.top) {
        visit(model.solids[s], pose, Piece{{}, Piece::Owner::kModel, m, s, span});
      }
    }
  }
}
}  // namespace

WorldPieces::WorldPieces(const WorldDescription & world) : world_(world)
{
  for (const ModelDescription & model : world.models) {
    bodies_.push_back(bodyOf(model));
  }
  forEachSolid(world, [this](const Solid & solid, const Pose3d & pose, Piece properties) {
    properties.layer = isUprightPrism(solid, pose) ? Layer::kWholeSolid : Layer::kModelsOnly;
    const Section footprint = footprintBetween(solid, pose, properties.span.bottom, properties.span.top);
    const Vec2 & origin = bodies_[properties.body].centre_of_mass;
    appendPieces(of(whole_solids_, properties), footprint, origin, solid, properties);
  });
  addStatics(whole_solids_);
}

std::vector<Piece> & WorldPieces::of(Pieces & pieces, const Piece & properties) const
{
  return world_.models[properties.body].is_static ? pieces.fixed : pieces.movable;
}

void WorldPieces::addStatics(const Pieces & pieces)
{
  for (const Piece & piece : pieces.fixed) {
    statics_.add(piece);
  }
}

Layer WorldPieces::layerFor(const VerticalSpan & span)
{
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    if (spans_[i].bottom == span.bottom && spans_[i].top == span.top) {
      return static_cast<Layer>(i);
    }
  }
  const auto layer = static_cast<Layer>(spans_.size());
  spans_.push_back(span);
  Pieces & pieces = layers_.emplace_back();
  forEachSolid(world_, [&](const Solid & solid, const Pose3d & pose, Piece properties) {
    if (!isUprightPrism(solid, pose) && overlap(properties.span, span)) {
      properties.layer = layer;
      const Section footprint = footprintBetween(solid, pose, span.bottom, span.top);
      const Vec2 & origin = bodies_[properties.body].centre_of_mass;
      appendPieces(of(pieces, properties), footprint, origin, solid, properties);
    }
  });
  addStatics(pieces);
  return layer;
}

std::vector<Piece> carPieces(
  const std::vector<Solid> & solids, double centre_of_mass, std::uint32_t car, WorldPieces & world)
{
  std::vector<Piece> pieces;
  for (std::uint32_t i = 0; i < solids.size(); ++i) {
    const VerticalSpan span = verticalSpan(solids[i], solids[i].pose);
    if (span.bottom <= span.top) {
      const Piece properties{{}, Piece::Owner::kCar, car, i, span, world.layerFor(span)};
      const Section footprint = footprintBetween(solids[i], solids[i].pose, span.bottom, span.top);
      appendPieces(pieces, footprint, {centre_of_mass, 0.0}, solids[i], properties);
    }
  }
  return pieces;
}
}  // namespace f1tenth_sim2d
