#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "environment/environment.h"
#include "environment/worker_pool.h"

namespace f1tenth_sim2d
{
/// Environments of one world, which they share, stepped together by several threads. Each behaves as if it were alone:
/// the number of threads or neighbours changes no bit.
class Environments
{
public:
  /// @throws Error for zero environments or threads, or options that do not make an environment
  Environments(const PreparedWorld & world, EnvironmentOptions options, std::size_t count, std::size_t threads);
  Environments(const Environments &) = delete;
  Environments & operator=(const Environments &) = delete;

  std::size_t count() const { return environments_.size(); }
  std::size_t cars() const { return options_.cars.size(); }
  const Observation & observation() const { return observation_; }

  /// Begins an episode of one environment. @throws Error as Environment::reset
  void reset(std::size_t index, std::uint64_t seed, const std::vector<CarStart> & starts);

  /// Writes what the cars of one environment do. @throws Error as Environment::record
  void record(std::size_t index, const std::string & file) { environments_.at(index).record(file); }

  /// The episode of one environment, for any environment of the same options. @throws Error as Environment::snapshot
  Episode snapshot(std::size_t index) const { return environments_.at(index).snapshot(); }
  /// @throws Error as Environment::restore
  void restore(std::size_t index, const Episode & episode);

  /// What a car of one environment sees. @throws Error as Environment::look
  void look(std::size_t index, std::size_t car, Picture & picture) const { environments_.at(index).look(car, picture); }

  /// Drives all by one period, except those of which no car is driven.
  /// @param actions  of all cars of all environments
  /// @param driven   likewise; see Environment::step
  void step(const Action * actions, const std::uint8_t * driven);

  /// What follows keeps its place in memory.
  std::vector<float> & observations() { return observations_; }  ///< row by row: environments, cars
  std::vector<CarResult> & results() { return results_; }        ///< likewise
  std::vector<double> & times() { return times_; }               ///< s, of each environment

private:
  void publish(std::size_t index);

  const EnvironmentOptions options_;
  const Observation observation_;
  std::deque<Environment> environments_;
  std::vector<float> observations_;
  std::vector<CarResult> results_;
  std::vector<double> times_;
  WorkerPool pool_;
};
}  // namespace f1tenth_sim2d
