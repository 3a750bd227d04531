#include "core/contacts/car_body.h"

#include <algorithm>

#include "core/contacts/piece_extent.h"

namespace f1tenth_sim2d
{
CarBody::CarBody(
  CarId id, const std::vector<Solid> & solids, double centre_of_mass, double body_mass, double body_inertia,
  const WorldPieces & world)
: mass(body_mass), inertia(body_inertia)
{
  for (std::uint32_t i = 0; i < solids.size(); ++i) {
    const Heights span = heightsOf(solids[i].shape, solids[i].pose);
    if (span.isEmpty()) {
      continue;
    }
    const PieceSet & layer = world.layerFor(span);
    if (std::find(layers.begin(), layers.end(), &layer) == layers.end()) {
      layers.push_back(&layer);
    }
    const Section footprint = footprintBetween(solids[i], solids[i].pose, span.lowest, span.highest);
    const Piece properties{{}, {}, Piece::Owner::kCar, static_cast<std::uint32_t>(id), i, span, layer.layer()};
    appendPieces(pieces, footprint, {centre_of_mass, 0.0}, solids[i], properties);
  }
  participant.outer_radius = outerRadius(pieces);
}
}  // namespace f1tenth_sim2d
