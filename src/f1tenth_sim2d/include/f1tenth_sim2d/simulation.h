#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "f1tenth_sim2d/car_model.h"
#include "f1tenth_sim2d/component.h"
#include "f1tenth_sim2d/simulation_types.h"
#include "f1tenth_sim2d/vehicle_parameters.h"
#include "f1tenth_sim2d/world_model.h"

/// The simulator's core: no ROS, no wall clock, no global state, no unseeded randomness.
namespace f1tenth_sim2d
{
class WorldGeometry;
struct Picture;
struct Pinhole;

/// A world that is ready to be simulated: its solids cut into the pieces that cars touch and the walls that lidars see.
/// No simulation changes it, so that any number of them, on any threads, can share one. A copy is the same world.
class PreparedWorld
{
public:
  /// @throws Error for what a simulation cannot be built from
  explicit PreparedWorld(WorldDescription world);

  const WorldDescription & description() const;

private:
  friend class Simulation;
  std::shared_ptr<const WorldGeometry> geometry_;
};

struct SimulationOptions
{
  double physics_step{0.001};  ///< s
  std::uint64_t seed{0};
  /// Whether Box2D is spared cars that are far from everything: for one car, and until several touch, a matter of time only.
  bool spares_far_cars{true};
};

/// A world with cars in it, advanced in fixed steps. Same calls, same seed: same states, bit for bit.
class Simulation
{
public:
  /// @throws Error for options out of range
  explicit Simulation(const PreparedWorld & world, const SimulationOptions & options = {});
  /// In a world of its own. @throws Error likewise, and as PreparedWorld does
  explicit Simulation(const WorldDescription & world, const SimulationOptions & options = {});
  /// A state of a simulation, to go on from any number of times; never changes. A copy is the same snapshot.
  class Snapshot;
  /// As the simulation was when the snapshot was taken.
  explicit Simulation(const Snapshot & snapshot);
  ~Simulation();
  Simulation(Simulation &&) noexcept;
  Simulation & operator=(Simulation &&) noexcept;

  /// Puts a car with its base_footprint at pose.
  /// All or nothing: whatever is thrown, the simulation is as before.
  /// @throws Error if the name is taken or the place is not free (the message names what is in the way)
  CarId addCar(const CarDescription & car, const VehicleParameters & parameters, const Pose2 & pose);

  /// Removes a car. The others keep their noise; a car that is added later gets the noise of the removed one.
  void removeCar(CarId car);

  /// Puts a car somewhere else, as if by hand. Its commands stay in force; wheel odometry does not notice.
  /// @param velocity  m/s, in the frame of the car, of base_footprint
  /// @param yaw_rate  rad/s
  /// @throws Error if a number is not finite or the place is not free; the car then stays where it is
  void placeCar(CarId car, const Pose2 & pose, const Vec2 & velocity = {}, double yaw_rate = 0.0);

  /// The cars that are there, in the order in which they were added. Any other id causes std::out_of_range.
  const std::vector<CarId> & cars() const;
  const CarDescription & car(CarId car) const;
  const VehicleParameters & parameters(CarId car) const;

  SimTime time() const;        ///< ns
  SimTime stepLength() const;  ///< ns

  /// Advances by one physics step.
  /// @throws Error if a car's motion diverges: its parameters do not describe a possible car
  void step();
  /// Steps until time() >= end.
  void advanceTo(SimTime end);
  /// Back to time 0, the state after construction and all addCar calls, with the same seed: as if built anew.
  void reset();
  /// The same for cars and models only: time goes on.
  void resetPoses();

  /// Takes effect after the car's actuation latency; clamped to the car's limits.
  /// @throws Error for a value that is not finite or absurd (beyond 100 m/s or a full turn); it is then ignored
  void command(CarId car, const DriveCommand & command);
  /// A Twist as in cmd_vel: the steering angle follows from v, omega and the wheelbase. A car with a differential,
  /// skid-steer or planar drive takes it as it is; linear_y, m/s to the left, is for planar drives only.
  /// @throws Error likewise, also beyond 1000 rad/s
  void commandTwist(CarId car, double linear_x, double angular_z, double linear_y = 0.0);

  /// What simulations made from it do from then on is what this one does, bit for bit, for the same calls. For that, Box2D's
  /// memory of contacts starts anew here as it does there: contacts that last are solved as if they had just begun.
  /// @throws Error if a component cannot be copied (Component::clone)
  Snapshot snapshot();

  CarState state(CarId car) const;
  WheelOdometry wheelOdometry(CarId car) const;

  /// What is mounted on a car: its lidars, the components of its description, then what mount() has added.
  const std::vector<std::shared_ptr<Component>> & components(CarId car) const;
  /// Puts one more component on a car, until the car is removed. Its hooks are called from the next step on.
  void mount(CarId car, std::shared_ptr<Component> component);

  /// Ranges of a lidar now, m, +inf where nothing is hit within range_max. Writes beam_count floats; allocates nothing.
  /// A hit nearer than range_min is reported as -inf (REP-117).
  void scan(CarId car, std::size_t lidar, float * ranges) const;
  /// The same without noise.
  void exactScan(CarId car, std::size_t lidar, float * ranges) const;

  /// The range at which each ray from a car hits something now, m, +inf where nothing is within range_max. Exact; a car
  /// does not see itself. Writes as many numbers as the fan has directions. Allocates nothing, except that the first
  /// call at a height works out what can be seen there.
  /// @throws Error for a number that is not finite, or a range_max that is not 0 or more; it may be infinite
  void castRays(CarId car, const RayFan & fan, double * ranges) const;

  /// Sample `index` of the standard normal noise of a sensor of a car now: a function of seed, car, name of the sensor,
  /// time and index only.
  double noise(CarId car, const std::string & sensor, std::uint64_t index) const;
  /// The samples 0 to count - 1 of it.
  void noises(CarId car, const std::string & sensor, std::size_t count, double * samples) const;

  /// Draws what a camera on a car would see now, without noise. The first call reads what the visuals of world and cars
  /// look like.
  /// @param pose  of the camera in the frame of the car: it looks along x, z is up
  void draw(CarId car, const Pinhole & camera, const Pose3 & pose, Picture & picture) const;
  /// What of world and cars is not drawn as it is described: the first such thing and how many there are; empty for
  /// none. Reads what the visuals look like.
  std::string viewWarning() const;

  /// Contacts of the car in the physics steps since the last call to clearContacts, ground excluded.
  const std::vector<Contact> & contacts(CarId car) const;
  void clearContacts(CarId car);

  /// Least distance from the car's outline to anything it could touch, m; 0 in contact; at most limit, which may be
  /// infinite. Throws Error if limit is negative or not a number.
  double clearance(CarId car, double limit) const;

  /// The world: static models where they are, movable ones where they started. Valid until a
  /// model is added or removed, or a static one is moved or put back.
  const WorldDescription & world() const;
  /// Models of the world, in the order in which they were added.
  const std::vector<ModelDescription> & models() const;
  ModelState modelState(std::size_t index) const;
  /// @throws Error for an unknown name
  std::size_t indexOfModel(const std::string & model) const;
  /// Pose of a model of the world now (movable ones move). @throws Error for an unknown name
  Pose2 modelPose(const std::string & model) const;
  std::vector<std::string> modelNames() const;

  /// Puts one more model into the world; reset() brings it back to this pose. Costs as much as loading the world.
  /// @throws Error if the name is taken, or for a movable model without mass
  void addModel(const ModelDescription & model);
  /// Removes a model; those after it move up.
  void removeModel(std::size_t index);
  /// Puts a model somewhere else; its tilt stays. A static one has no velocity. Moving a static one, and lifting any,
  /// costs as much as loading the world. reset() brings it back.
  /// @param lift  m, by which it is put higher than it is
  /// @throws Error if a number is not finite
  void placeModel(std::size_t index, const ModelState & state, double lift = 0.0);

  /// Little-endian bytes of all car states, for the trajectory hash.
  void appendStateBytes(std::vector<std::uint8_t> & bytes) const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

class Simulation::Snapshot
{
private:
  friend class Simulation;
  std::shared_ptr<const Impl> impl_;
};
}  // namespace f1tenth_sim2d
