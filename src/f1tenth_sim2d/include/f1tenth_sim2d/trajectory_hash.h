#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "f1tenth_sim2d/simulation.h"

struct evp_md_ctx_st;

namespace f1tenth_sim2d
{
/// SHA-256 of a text or a file's content, 64 hexadecimal digits.
std::string sha256(const std::string & bytes);

/// SHA-256 over all car states at each control period (OpenSSL).
class TrajectoryHash
{
public:
  TrajectoryHash();
  TrajectoryHash(const TrajectoryHash & other);
  TrajectoryHash & operator=(const TrajectoryHash & other);

  void add(const Simulation & simulation);
  /// Digest of everything added so far, 64 hexadecimal digits; more may be added afterwards.
  std::string hexDigest() const;
  void reset();

private:
  using Context = evp_md_ctx_st;  // of OpenSSL
  struct Free
  {
    void operator()(Context * context) const;
  };

  std::unique_ptr<Context, Free> context_;
  std::vector<std::uint8_t> bytes_;  // of one period
};
}  // namespace f1tenth_sim2d
