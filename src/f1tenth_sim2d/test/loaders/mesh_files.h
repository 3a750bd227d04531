#pragma once

#include <array>
#include <sstream>
#include <string>
#include <vector>

/// Small mesh files as text.
namespace f1tenth_sim2d
{
/// The faces of a box from low to high, counter-clockwise seen from outside, as an OBJ object.
/// @param first  number of its first vertex in the file, from 1
inline std::string objBox(
  const std::string & name, const std::array<double, 3> & low, const std::array<double, 3> & high, int first = 1)
{
  std::ostringstream text;
  text << "o " << name << "\n";
  for (int i = 0; i < 8; ++i) {
    text << "v " << ((i & 1) != 0 ? high : low)[0] << " " << ((i & 2) != 0 ? high : low)[1] << " "
         << ((i & 4) != 0 ? high : low)[2] << "\n";
  }
  const std::vector<std::array<int, 4>> faces{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                              {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto & face : faces) {
    text << "f";
    for (const int corner : face) {
      text << " " << first + corner;
    }
    text << "\n";
  }
  return text.str();
}

/// The same turned inside out: every face clockwise.
inline std::string objHollow(
  const std::string & name, const std::array<double, 3> & low, const std::array<double, 3> & high, int first = 1)
{
  std::istringstream lines(objBox(name, low, high, first));
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string tag, a, b, c, d;
    words >> tag >> a >> b >> c >> d;
    text += (tag == "f" ? "f " + a + " " + d + " " + c + " " + b : line) + "\n";
  }
  return text;
}

/// A tetrahedron with its corner at the origin and legs of one unit, as DAE.
inline std::string daeTetrahedron(const std::string & asset)
{
  return R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset>)" +
         asset + R"(</asset>
<library_geometries><geometry id="g" name="g"><mesh>
<source id="p"><float_array id="a" count="12">0 0 0 1 0 0 0 1 0 0 0 1</float_array><technique_common>
<accessor source="#a" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/><p>0 2 1 0 1 3 0 3 2 1 2 3</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n" name="peak"><translate>0 0 0</translate>
<instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}
}  // namespace f1tenth_sim2d
