#include "f1tenth_sim2d/trajectory_hash.h"

#include <openssl/evp.h>

#include <array>
#include <boost/algorithm/hex.hpp>
#include <iterator>
#include <stdexcept>

namespace f1tenth_sim2d
{
namespace
{
/// OpenSSL's calls fail only when memory or the algorithm is missing.
void check(int result)
{
  if (result != 1) {
    throw std::runtime_error("OpenSSL cannot compute SHA-256");
  }
}

std::string hex(const std::array<std::uint8_t, EVP_MAX_MD_SIZE> & digest, unsigned int size)
{
  std::string text;
  boost::algorithm::hex_lower(digest.begin(), digest.begin() + size, std::back_inserter(text));
  return text;
}
}  // namespace

std::string sha256(const std::string & bytes)
{
  std::array<std::uint8_t, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  check(EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr));
  return hex(digest, size);
}

void TrajectoryHash::Free::operator()(Context * context) const
{
  EVP_MD_CTX_free(context);
}

TrajectoryHash::TrajectoryHash() : context_(EVP_MD_CTX_new())
{
  reset();
}

TrajectoryHash::TrajectoryHash(const TrajectoryHash & other) : context_(EVP_MD_CTX_new())
{
  *this = other;
}

TrajectoryHash & TrajectoryHash::operator=(const TrajectoryHash & other)
{
  check(EVP_MD_CTX_copy_ex(context_.get(), other.context_.get()));
  return *this;
}

void TrajectoryHash::reset()
{
  check(EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr));
}

void TrajectoryHash::add(const Simulation & simulation)
{
  bytes_.clear();
  simulation.appendStateBytes(bytes_);
  check(EVP_DigestUpdate(context_.get(), bytes_.data(), bytes_.size()));
}

// Finalizing ends a digest, so a copy is finalized.
std::string TrajectoryHash::hexDigest() const
{
  const TrajectoryHash copy(*this);
  std::array<std::uint8_t, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  check(EVP_DigestFinal_ex(copy.context_.get(), digest.data(), &size));
  return hex(digest, size);
}
}  // namespace f1tenth_sim2d
