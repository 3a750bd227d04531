#include "f1tenth_sim2d/trajectory_hash.h"

#include <openssl/evp.h>

#include <array>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <vector>

namespace f1tenth_sim2d
{
namespace
{
using Context = std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)>;

/// OpenSSL's calls fail only when memory or the algorithm is missing.
void check(int result)
{
  if (result != 1) {
    throw std::runtime_error("OpenSSL cannot compute SHA-256");
  }
}

Context newContext()
{
  return {EVP_MD_CTX_new(), &EVP_MD_CTX_free};
}
}  // namespace

class TrajectoryHash::Impl
{
public:
  Impl() { restart(); }
  void restart()
  {
    bytes_.clear();
    check(EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr));
  }

  void add(const Simulation & simulation)
  {
    simulation.appendStateBytes(bytes_);
    if (bytes_.size() >= kEnough) {
      check(EVP_DigestUpdate(context_.get(), bytes_.data(), bytes_.size()));
      bytes_.clear();
    }
  }

  // Finishing ends a digest, so a copy is finished.
  std::string hexDigest() const
  {
    const Context copy = newContext();
    check(EVP_MD_CTX_copy_ex(copy.get(), context_.get()));
    check(EVP_DigestUpdate(copy.get(), bytes_.data(), bytes_.size()));
    std::array<std::uint8_t, EVP_MAX_MD_SIZE> digest{};
    unsigned int size = 0;
    check(EVP_DigestFinal_ex(copy.get(), digest.data(), &size));
    std::string text;
    for (unsigned int i = 0; i < size; ++i) {
      text += "0123456789abcdef"[digest[i] >> 4];
      text += "0123456789abcdef"[digest[i] & 15];
    }
    return text;
  }

private:
  static constexpr std::size_t kEnough = 4096;  // bytes, to make a call of OpenSSL worth its price

  Context context_{newContext()};
  std::vector<std::uint8_t> bytes_;  ///< that are not in the digest yet
};

TrajectoryHash::TrajectoryHash() : impl_(std::make_unique<Impl>()) {}
TrajectoryHash::~TrajectoryHash() = default;
void TrajectoryHash::add(const Simulation & simulation)
{
  impl_->add(simulation);
}
std::string TrajectoryHash::hexDigest() const
{
  return impl_->hexDigest();
}
void TrajectoryHash::reset()
{
  impl_->restart();
}
}  // namespace f1tenth_sim2d
