#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace f1tenth_sim2d
{
/// One geometry of a mesh file where one of its nodes puts it, seen from outside counter-clockwise.
struct MeshPart
{
  std::vector<std::string> names;             ///< of the geometry and of all nodes around it
  std::vector<std::array<float, 3>> corners;  ///< m
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<float, 3>> normals;         ///< one per corner, or none
  std::vector<std::array<float, 2>> texture_points;  ///< one per corner, or none
  std::vector<float> colour;                         ///< red, green and blue, 0 to 1; empty: it has none
  std::vector<std::string> textures;                 ///< its file as written; empty: it has none
};

/// What is of use in a mesh file, in its order.
struct MeshParts
{
  std::vector<std::string> names;    ///< of all nodes and geometries, also of those without triangles
  std::vector<std::string> missing;  ///< files of materials that it names, as written, and that cannot be opened
  std::vector<MeshPart> parts;
};

/// As bytes, for another process on this machine.
std::string packed(const MeshParts & mesh);
MeshParts unpacked(const std::string & bytes);
}  // namespace f1tenth_sim2d
