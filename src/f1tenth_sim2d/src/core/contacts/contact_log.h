#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/contacts/piece.h"
#include "f1tenth_sim2d/simulation_types.h"

namespace f1tenth_sim2d
{
/// What touches one solid of a car in one physics step.
struct StepContact
{
  std::uint32_t own_solid;
  Piece::Owner other_owner;
  std::uint32_t other_body;
  std::uint32_t other_solid;
  std::vector<Vec2> positions;  ///< m, world
  std::vector<Vec2> normals;    ///< from the other body towards the car
  std::vector<double> depths;   ///< m
  Vec2 impulse;                 ///< N s, on the car
  double angular_impulse{0.0};  ///< N m s, about the car's centre of mass
  double speed{0.0};            ///< m/s, greatest relative speed of the touching points, before the impact
  int substep{0};               ///< of the positions, normals and depths: the last one in which the pair touched

  bool isOfSamePair(const StepContact & other) const
  {
    return own_solid == other.own_solid && other_owner == other.other_owner && other_body == other.other_body &&
           other_solid == other.other_solid;
  }
};

/// The contacts of one car since they were last cleared, one entry per pair of collision elements: the physics step in
/// which the pair pushed hardest, so that a bump shorter than a control period shows with its full force.
class ContactLog
{
public:
  const std::vector<Contact> & contacts() const { return contacts_; }
  void clear();
  /// A model was removed from the world, and those after it have moved up. Its contacts stay.
  void forgetModel(std::size_t index) noexcept;

  /// @param describe  fills in the names of a new contact
  /// @param dt        s, of the step in which `step` was recorded
  template <typename Describe>
  void add(const StepContact & step, double dt, Describe describe)
  {
    const std::size_t place = find(step);
    if (place == contacts_.size()) {
      contacts_.emplace_back();
      describe(step, contacts_.back());
    }
    contacts_[place].speed = std::max(contacts_[place].speed, step.speed);
    if (place == steps_.size() || strength(step) > strength(steps_[place])) {
      keep(place, step, dt);
    }
  }

private:
  static double strength(const StepContact & step)
  {
    return step.impulse.x * step.impulse.x + step.impulse.y * step.impulse.y;
  }
  std::size_t find(const StepContact & step) const;
  void keep(std::size_t place, const StepContact & step, double dt);

  std::vector<StepContact> steps_;  ///< parallel to contacts_
  std::vector<Contact> contacts_;
};
}  // namespace f1tenth_sim2d
