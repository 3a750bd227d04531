#pragma once

#include <cstddef>
#include <cstdint>

/// What a fuzzer feeds with bytes, one function per loader. Each returns if the input was loaded, or refused with an Error;
/// everything else is a finding. Inputs that are files are written into a folder of this process first.
namespace f1tenth_sim2d::fuzz
{
using Target = void (*)(const std::uint8_t * data, std::size_t size);

/// An SDF world, which is then put into a simulation and stepped.
void world(const std::uint8_t * data, std::size_t size);
/// A URDF or SDF model, which is then driven in an empty world.
void car(const std::uint8_t * data, std::size_t size);
/// The YAML file of a map up to the first zero byte, then its image.
void map(const std::uint8_t * data, std::size_t size);
/// The YAML file of a car's parameters, with which a car is then driven.
void vehicle(const std::uint8_t * data, std::size_t size);
/// An image as the texture of a box.
void texture(const std::uint8_t * data, std::size_t size);
}  // namespace f1tenth_sim2d::fuzz
