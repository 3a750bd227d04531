#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cmath>
#include <filesystem>
#include <optional>

#include "f1tenth_sim2d/loaders.h"
#include "f1tenth_sim2d/section.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/python_world.h"

namespace f1tenth_sim2d
{
namespace
{
namespace py = pybind11;

py::tuple toTuple(const Section & section)
{
  py::list outlines;
  for (const Outline & outline : section.outlines) {
    outlines.append(toArray(outline));
  }
  return py::make_tuple(outlines, toArray(section.circles));
}

void requireFinite(double z)
{
  if (!std::isfinite(z)) {
    throw py::value_error("z is not finite");
  }
}

py::tuple sectionOfStaticModels(const PythonWorld & world, double z)
{
  requireFinite(z);
  return toTuple(staticSectionAt(world.description(), z));
}

py::tuple sectionOfModel(const ModelDescription & model, double z)
{
  requireFinite(z);
  return toTuple(sectionAt(model.solids, model.pose, z));
}

PythonWorld load(const std::filesystem::path & path, const std::optional<std::vector<std::string>> & model_path)
{
  return {
    loadWorld(path.string(), model_path ? SearchPath{*model_path, {}} : searchPathFromEnvironment()),
    {std::filesystem::absolute(path).string(), model_path}};
}

PythonWorld empty()
{
  return {emptyWorld(), {}};
}

py::tuple toPickle(const PythonWorld & world)
{
  return py::make_tuple(world.source().file, world.source().model_path);
}

PythonWorld fromPickle(const py::tuple & source)
{
  const auto file = source[0].cast<std::string>();
  return file.empty() ? empty() : load(file, source[1].cast<std::optional<std::vector<std::string>>>());
}

/// Reads a member of the description.
template <typename Member>
auto part(Member WorldDescription::*member)
{
  return [member](const PythonWorld & world) { return world.description().*member; };
}

/// An array of two columns for a line without widths, else of four.
py::array centrelineOf(const std::filesystem::path & path)
{
  const Centreline line = readCentreline(path.string());
  const py::array_t<double> all = toArray(line.points);
  return line.has_widths ? py::array(all) : py::array(all[py::make_tuple(py::ellipsis(), py::slice(0, 2, 1))]);
}

py::tuple mapOf(const std::filesystem::path & path)
{
  const MapGrid map = readMap(path.string());
  const py::array_t<std::int8_t> cells({map.rows, map.columns}, map.cells.data());
  return py::make_tuple(cells, map.resolution, py::make_tuple(map.origin.x, map.origin.y, map.origin.yaw));
}

std::vector<ModelDescription> loadModels(
  const std::string & xml, const std::string & name, const std::string & source, double x, double y, double z,
  double yaw)
{
  const LoadedModel loaded = loadModel(xml, name, Pose3(x, y, z, 0.0, 0.0, yaw), source, searchPathFromEnvironment());
  return loaded.models;
}
}  // namespace

void bindWorld(py::module_ & module)
{
  py::class_<ModelDescription>(module, "Model", "A rigid model of a world.")
    .def_readonly("name", &ModelDescription::name, "Name; that of a nested model is \"outer::inner\".")
    .def_readonly("is_static", &ModelDescription::is_static, "Whether it stays where it is whatever pushes it.")
    .def_readonly("mass", &ModelDescription::mass, "Mass of all links, kg.")
    .def_property_readonly(
      "pose",
      [](const ModelDescription & model) {
        return py::make_tuple(model.pose.position.x(), model.pose.position.y(), model.pose.yaw());
      },
      "Pose in the world at the start: (x, y, yaw), m and rad.")
    .def_property_readonly(
      "collisions", ofEach(&ModelDescription::solids, &Solid::name),
      "Scoped names of the collision elements, \"model::link::collision\".")
    .def(
      "section", &sectionOfModel, py::arg("z"),
      "What a level lidar at height z (m) sees of the model at its start: as World.section, which see.");

  py::class_<PythonWorld>(module, "World", R"(A world as its file describes it; see load_world.

It never changes, so a copy is the same world. Pickled, it is the name of its file, which is read again.)")
    .def(py::pickle(&toPickle, &fromPickle))
    .def("__copy__", [](const py::object & world) { return world; })
    .def(
      "__deepcopy__", [](const py::object & world, const py::dict &) { return world; }, py::arg("memo"))
    .def_property_readonly("file", part(&WorldDescription::file), "Path it was read from.")
    .def_property_readonly("name", part(&WorldDescription::name))
    .def_property_readonly("gravity", part(&WorldDescription::gravity), "Downwards, m/s^2.")
    .def_property_readonly(
      "start",
      [](const PythonWorld & world) {
        const Pose2 & start = world.description().start;
        return py::make_tuple(start.x, start.y, start.yaw);
      },
      "(x, y, yaw) where a car starts unless told otherwise, m and rad.")
    .def_property_readonly("models", part(&WorldDescription::models), "All models.")
    .def_property_readonly("warnings", part(&WorldDescription::warnings), "What was left out: one line per kind.")
    .def(
      "section", &sectionOfStaticModels, py::arg("z"),
      R"(What a level lidar at height z sees of the static models.

Args:
    z: height in the world, m.

Returns:
    (outlines, circles): outlines is a list of float64 arrays of shape (n, 2), the corners of a closed outline
    in the world, m, counter-clockwise around solid matter; circles is a float64 array of shape (m, 3) of centres
    and radii (x, y, radius), m. Outlines may overlap or share edges.

Raises:
    ValueError: z is not finite.
)");

  module.def(
    "load_world", &load, py::arg("path"), py::arg("model_path") = py::none(),
    R"(Read a world: an SDF file, or an occupancy-grid map in map_server's format.

The occupied cells of a map are walls, exactly along the edges of the pixels. Its start is on the centreline of the
track if X_centerline.csv lies beside X_map.yaml.

Args:
    path: a .world file, or a .yaml file with a PNG or PGM image.
    model_path: folders in which model:// URIs are looked up, in order; default: those of GAZEBO_MODEL_PATH.
        Afterwards the world file's folder, the folder models in it and the one beside it are looked through.

Raises:
    LoadError: a missing or malformed file, or something that would make the simulation wrong.
)",
    py::call_guard<py::gil_scoped_release>());
  module.def(
    "read_map", &mapOf, py::arg("path"),
    R"(Read the cells of an occupancy-grid map in map_server's format, as load_world reads it.

Returns:
    (cells, resolution, origin): cells is an int8 array of shape (rows, columns), the lowest row first: 100 is
    occupied, 0 free, -1 neither; resolution is the edge length of a cell, m; origin the pose (x, y, yaw) of the
    lower left corner, m and rad.

Raises:
    LoadError: a missing or malformed file.
)");
  module.def(
    "read_centreline", &centrelineOf, py::arg("path"),
    R"(Read the centreline of a track, a file X_centerline.csv of f1tenth_racetracks.

A point that is there several times, one after the other or at both ends, counts once.

Returns:
    float64 array of shape (n, 4): x, y, width of the road to the right and to the left, m; of shape (n, 2) if the
    file gives no widths. The last point is joined to the first.

Raises:
    LoadError: no such file, a line that is not of this form, a width that is not above 0, or fewer than two
        different points.
)");
  module.def(
    "load_model", &loadModels, py::arg("xml"), py::arg("name"), py::arg("source"), py::arg("x") = 0.0,
    py::arg("y") = 0.0, py::arg("z") = 0.0, py::arg("yaw") = 0.0,
    R"(Read a URDF or SDF model that is no car, for Simulation.add_model.

Args:
    xml: the text.
    name: that it gets in the world.
    source: what error messages call the text, for example its path.
    x, y, z, yaw: where to put it in the world, m and rad; the pose in its description is relative to this.

Returns:
    List of Model: the model, then those nested in it.

Raises:
    LoadError: malformed text, or something that would make the simulation wrong.
)");
  module.def("empty_world", &empty, "The ground and nothing on it.");
}
}  // namespace f1tenth_sim2d
