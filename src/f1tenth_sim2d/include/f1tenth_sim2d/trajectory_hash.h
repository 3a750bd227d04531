#pragma once

#include <memory>
#include <string>

#include "f1tenth_sim2d/simulation.h"

namespace f1tenth_sim2d
{
/// SHA-256 over all car states at each control period (OpenSSL).
class TrajectoryHash
{
public:
  TrajectoryHash();
  ~TrajectoryHash();

  void add(const Simulation & simulation);
  /// Digest of everything added so far, 64 hexadecimal digits; more may be added afterwards.
  std::string hexDigest() const;
  void reset();

private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};
}  // namespace f1tenth_sim2d
