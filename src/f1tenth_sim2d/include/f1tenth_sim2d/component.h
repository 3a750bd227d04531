#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "f1tenth_sim2d/geometry.h"
#include "f1tenth_sim2d/simulation_types.h"

namespace f1tenth_sim2d
{
class Simulation;

/// Where a component is and how it is called.
struct Mount
{
  std::string name;     ///< unique among the components of a car
  std::string topic;    ///< in the namespace of the car, unless it is absolute
  std::string frame;    ///< frame id without the car's prefix
  Pose3 pose;           ///< in the frame of the car
  double rate_hz{0.0};  ///< Hz, at which it is sampled; 0: at every physics step
};

/// Numbers that a component measures, and the bounds of each.
struct Channel
{
  std::string name;
  std::size_t size;
  double least;
  double greatest;
};

/// Something that is put on a car: a sensor, a drive, a controller, a plug-in. A CarDescription holds its components as
/// prototypes; each car gets clones of them, and others may be mounted on it later.
class Component
{
public:
  virtual ~Component() = default;

  /// A copy with all its state; null for one that belongs to somebody else and does not go along with copies of a car.
  virtual std::unique_ptr<Component> clone() const { return nullptr; }

  /// Whether the hooks that follow are to be called; the simulation asks once.
  virtual bool acts() const { return false; }
  /// Before the physics step that begins now. May command the car; may not add, remove or put anything.
  virtual void beforeStep(Simulation & /*simulation*/, CarId /*car*/) {}
  /// After the physics step that has ended now.
  virtual void afterStep(const Simulation & /*simulation*/, CarId /*car*/) {}
  /// For everything that touches the car in a physics step, before afterStep().
  virtual void onContact(const Contact & /*contact*/) {}
  /// The cars are back where they started, and time may be: what came before is forgotten.
  virtual void restart() {}

  /// What it measures, in order; nothing for one that cannot be sampled. The same for clones.
  virtual std::vector<Channel> channels() const { return {}; }
  /// Writes what it measures now: the numbers of all channels, one after the other. Noise depends on seed, car, name and
  /// time only, so that reading or not reading changes nothing.
  virtual void sample(const Simulation & /*simulation*/, CarId /*car*/, double * /*numbers*/) const {}

  const Mount & mount() const { return mount_; }

protected:
  Component() = default;
  explicit Component(Mount mount) : mount_(std::move(mount)) {}
  Component(const Component &) = default;
  Component & operator=(const Component &) = default;

private:
  Mount mount_;
};

/// A component of a type that is copied as it is.
template <class Derived>
class CopiedComponent : public Component
{
public:
  std::unique_ptr<Component> clone() const override
  {
    return std::make_unique<Derived>(static_cast<const Derived &>(*this));
  }

protected:
  using Component::Component;
};

/// How many numbers a component measures.
inline std::size_t sampleSize(const Component & component)
{
  std::size_t size = 0;
  for (const Channel & channel : component.channels()) {
    size += channel.size;
  }
  return size;
}
}  // namespace f1tenth_sim2d
