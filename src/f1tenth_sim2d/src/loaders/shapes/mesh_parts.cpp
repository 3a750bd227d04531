#include "loaders/shapes/mesh_parts.h"

#include <cstring>

namespace f1tenth_sim2d
{
namespace
{
template <typename Values>
void pack(const Values & values, std::string & bytes)
{
  const std::uint64_t count = values.size();
  bytes.append(reinterpret_cast<const char *>(&count), sizeof(count));
  bytes.append(reinterpret_cast<const char *>(values.data()), count * sizeof(values[0]));
}

/// @return where the next ones begin
template <typename Values>
const char * unpack(const char * bytes, Values & values)
{
  std::uint64_t count = 0;
  std::memcpy(&count, bytes, sizeof(count));
  values.resize(count);
  std::memcpy(values.data(), bytes + sizeof(count), count * sizeof(values[0]));
  return bytes + sizeof(count) + count * sizeof(values[0]);
}

void packNames(const std::vector<std::string> & names, std::string & bytes)
{
  std::string text;
  for (const std::string & name : names) {
    text += name + '\0';
  }
  pack(text, bytes);
}

const char * unpackNames(const char * bytes, std::vector<std::string> & names)
{
  std::string text;
  const char * const end = unpack(bytes, text);
  for (std::size_t begin = 0; begin < text.size(); begin += names.back().size() + 1) {
    names.emplace_back(text.c_str() + begin);
  }
  return end;
}
}  // namespace

std::string packed(const MeshParts & mesh)
{
  std::string bytes;
  packNames(mesh.names, bytes);
  packNames(mesh.missing, bytes);
  for (const MeshPart & part : mesh.parts) {
    packNames(part.names, bytes);
    pack(part.corners, bytes);
    pack(part.triangles, bytes);
    pack(part.normals, bytes);
    pack(part.texture_points, bytes);
    pack(part.colour, bytes);
    packNames(part.textures, bytes);
  }
  return bytes;
}

MeshParts unpacked(const std::string & bytes)
{
  MeshParts mesh;
  const char * at = unpackNames(unpackNames(bytes.data(), mesh.names), mesh.missing);
  while (at < bytes.data() + bytes.size()) {
    MeshPart & part = mesh.parts.emplace_back();
    at = unpack(unpack(unpackNames(at, part.names), part.corners), part.triangles);
    at = unpack(unpack(unpack(at, part.normals), part.texture_points), part.colour);
    at = unpackNames(at, part.textures);
  }
  return mesh;
}
}  // namespace f1tenth_sim2d
