#pragma once

#include <cstddef>

/// The loops of beam_kernels.h and noise.h on fixed inputs, compiled for one vector unit each; see CMakeLists.txt.
constexpr std::size_t kPathResults = 8192;

extern "C" void runPath(double * results);
