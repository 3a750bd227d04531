#include <dlfcn.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include "vector_path.h"

namespace
{
std::vector<double> resultsOf(const char * library)
{
  std::vector<double> results(kPathResults, 0.0);
  void * const opened = dlopen(library, RTLD_NOW | RTLD_LOCAL);
  void * const run = opened ? dlsym(opened, "runPath") : nullptr;
  EXPECT_NE(run, nullptr) << dlerror();
  if (run) {
    reinterpret_cast<decltype(&runPath)>(run)(results.data());
  }
  return results;
}

std::uint64_t bitsOf(double value)
{
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

void expectSameBits(const std::vector<double> & a, const std::vector<double> & b)
{
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(bitsOf(a[i]), bitsOf(b[i])) << i << ": " << a[i] << " and " << b[i];
  }
}

TEST(VectorPaths, ThereIsSomethingToCompare)
{
  const std::vector<double> results = resultsOf(F1TENTH_PATH_SSE2);
  EXPECT_GT(std::count_if(results.begin(), results.end(), [](double value) { return value != 0.0; }), 4000);
}

TEST(VectorPaths, Avx2GivesTheBitsOfSse2)
{
  if (__builtin_cpu_supports("avx2") == 0 || __builtin_cpu_supports("fma") == 0) {
    GTEST_SKIP() << "this processor has no AVX2 and FMA";
  }
  expectSameBits(resultsOf(F1TENTH_PATH_AVX2), resultsOf(F1TENTH_PATH_SSE2));
}

TEST(VectorPaths, Avx512GivesTheBitsOfSse2)
{
  if (__builtin_cpu_supports("avx512vl") == 0 || __builtin_cpu_supports("avx512dq") == 0) {
    GTEST_SKIP() << "this processor has no AVX-512";
  }
  expectSameBits(resultsOf(F1TENTH_PATH_AVX512), resultsOf(F1TENTH_PATH_SSE2));
}
}  // namespace
