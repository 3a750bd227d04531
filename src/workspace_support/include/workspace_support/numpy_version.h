#pragma once

#include <pybind11/pybind11.h>

#include <stdexcept>
#include <string>

namespace workspace_support
{
/// To be called by modules that exchange arrays. Before 2.12, pybind11 takes them to be laid out as in NumPy 1: with NumPy 2 each
/// number would be wrong, without an error (https://github.com/pybind/pybind11/pull/5050).
/// @throws std::runtime_error, of which pybind11 makes an ImportError
inline void requireKnownNumpy()
{
#if PYBIND11_VERSION_HEX < 0x020C0000
  const std::string version = pybind11::str(pybind11::module_::import("numpy").attr("__version__"));
  if (std::stoi(version) > 1) {
    throw std::runtime_error(
      "built for NumPy 1, as Debian's pybind11 is too old for NumPy 2; found NumPy " + version +
      ": install 'numpy<2', or f1tenth_sim2d by pip");
  }
#endif
}
}  // namespace workspace_support
