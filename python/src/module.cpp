// SPDX-License-Identifier: GPL-3.0-or-later
// loopmend._core: what loopmend/*.py wraps. Arrays and words in, arrays and dictionaries out.
#include "arrays.h"
#include "carried.h"
#include "fill_job.h"
#include "interruptible.h"
#include "problems.h"
#include "results.h"
#include "words.h"

#include "analysis/curvature_field.h"
#include "core/version.h"
#include "export/write_scan.h"
#include "io/read_mesh.h"
#include "samples/sample_scan.h"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <limits>
#include <utility>

namespace loopmend {

namespace {

namespace py = pybind11;
using namespace py::literals;

/// None, or a number greater than 0.
template <class T>
std::optional<T> limit(const py::dict& options, const char* name) {
  const auto value = option<std::optional<T>>(options, name);
  if (value && !(*value > 0))
    throw InvalidArgument(say("%1 must be greater than 0, not %2", std::string(name), *value));
  return value;
}

int whole_number(const py::dict& options, const char* name, int most) {
  const int value = option<int>(options, name);
  if (value < 0 || value > most)
    throw InvalidArgument(say("%1 must lie between 0 and %2, not %3", std::string(name), most, value));
  return value;
}

/// True, a length, or a text such as "5%".
void take_stitch(const py::object& stitch, PrepareOptions& prepare) {
  if (stitch.is(py::bool_(false)) || stitch.is_none()) return;
  prepare.stitch = PrepareOptions::Stitch::yes;
  if (!stitch.is(py::bool_(true))) prepare.stitch_tolerance = stitch_tolerance_of(py::str(stitch));
}

LoopSelection loop_selection(const py::dict& options) {
  LoopSelection loops;
  if (const auto text = option<std::optional<std::string>>(options, "loops")) take_loops(*text, loops);
  if (const auto vertices = option<std::optional<std::vector<int>>>(options, "at_vertices")) {
    if (vertices->empty()) throw InvalidArgument(say("at_vertices names no vertex"));
    loops.at_vertices = *vertices;
  }
  loops.max_edges = limit<int>(options, "max_edges");
  loops.max_diameter = limit<double>(options, "max_diameter");
  loops.all_but_largest = whole_number(options, "all_but_largest", std::numeric_limits<int>::max());
  if (option<bool>(options, "include_outer_rim")) loops.outer_rim = LoopSelection::OuterRim::include;
  return loops;
}

PrepareOptions prepare_options(const py::dict& options) {
  PrepareOptions prepare;
  take_stitch(options["stitch"], prepare);
  const bool cut_intersections = option<bool>(options, "cut_intersections");
  const bool cut_handles = option<bool>(options, "cut_handles");
  const bool unite = option<bool>(options, "union");
  if (option<bool>(options, "turn_around")) prepare.sides = PrepareOptions::Sides::turned;
  if (option<bool>(options, "auto")) prepare.extent = PrepareOptions::Extent::where_needed;
  if (option<bool>(options, "repair") || cut_intersections || cut_handles || unite) prepare.repair = harmless_repairs;
  if (cut_intersections) prepare.repair.insert(Defect::intersections);
  if (cut_handles) prepare.repair.insert(Defect::handles);
  if (unite) prepare.repair.insert(Defect::overlaps);
  if (const auto base = option<std::optional<std::string>>(options, "base")) prepare.base = base_of(*base);
  if (!options["cut_plane"].is_none()) {
    const auto plane = option<std::array<double, 6>>(options, "cut_plane");
    prepare.cut_plane = make_cut_plane({plane[0], plane[1], plane[2]}, {plane[3], plane[4], plane[5]});
  }
  if (option<bool>(options, "cut_no_data")) prepare.no_data = PrepareOptions::NoData::cut;
  prepare.bridges = option<std::vector<std::pair<int, int>>>(options, "bridges");
  if (option<bool>(options, "trim_crossing")) prepare.trim_pierced = PrepareOptions::TrimPierced::yes;
  prepare.trim_rounds = whole_number(options, "trim_boundary", 100);
  return prepare;
}

FillOptions fill_options(const py::dict& options) {
  FillOptions fill;
  static_cast<GroupOptions&>(fill) = group_options(options);
  fill.threads = whole_number(options, "threads", 1024);
  if (fill.evolution)
    fill.evolution->edge_edits = {option<std::vector<std::pair<int, int>>>(options, "drawn_edges"),
                                  option<std::vector<int>>(options, "stopped_edges")};
  fill.islands = named(options, "islands", islands_names);
  if (option<bool>(options, "mirror")) fill.mirror = FillOptions::Mirror::find;
  if (!options["mirror_plane"].is_none()) {
    const auto plane = option<std::array<double, 6>>(options, "mirror_plane");
    fill.mirror_planes = {make_mirror_plane({plane[0], plane[1], plane[2]}, {plane[3], plane[4], plane[5]})};
  }
  check(fill);
  return fill;
}

py::dict fill(const py::array& vertices, const py::array& faces, const py::object& colors, const py::dict& options,
              const py::object& on_progress, const py::object& carried) {
  FillJob job{soup_of(vertices, faces, colors), {}, limit<double>(options, "max_time")};
  carry(carried, job.soup);
  job.job = {prepare_options(options), loop_selection(options), fill_options(options),
             limit<double>(options, "max_memory")};
  if (option<bool>(options, "patches_only")) job.content = FillJob::Content::patches;
  const bool keep = option<bool>(options, "keep_partial");
  FilledScan done;
  run_interruptibly(
      [&](const CancelToken& cancel, const PostEvent& post) {
        const auto tell = [&](const FillProgress& p) {
          post([p] { return py::make_tuple(p.loops_done, p.loops_total, p.loop_number); });
        };
        done = run_fill_job(std::move(job), tell, cancel);
      },
      on_progress, keep ? OnInterrupt::keep_finished : OnInterrupt::raise);
  return fill_result(std::move(done));
}

py::dict check_mesh(const py::array& vertices, const py::array& faces) {
  const TriangleSoup soup = soup_of(vertices, faces, py::none());
  Watertightness found;
  run_interruptibly([&](const CancelToken& cancel, const PostEvent&) { found = watertightness(soup, cancel); },
                    py::none());
  return check_figures(found);
}

py::list boundary_loops(const py::array& vertices, const py::array& faces) {
  TriangleSoup soup = soup_of(vertices, faces, py::none());
  SurfaceModel model;
  std::vector<BoundaryLoop> loops;
  run_interruptibly(
      [&](const CancelToken&, const PostEvent&) {
        model = make_surface_model(std::move(soup));
        loops = find_boundary_loops(model);
      },
      py::none());
  py::list result;
  for (const BoundaryLoop& loop : loops) {
    std::vector<int> indices;
    for (const int v : loop.vertices) indices.push_back(model.soup_vertex[v]);
    py::dict entry = loop_figures(loop);
    entry["vertices"] = array_of<int>(std::move(indices));
    result.append(entry);
  }
  return result;
}

/// One value per vertex of the arrays: that of its first view vertex; NaN where no face uses it.
py::dict curvatures(const py::array& vertices, const py::array& faces) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  TriangleSoup soup = soup_of(vertices, faces, py::none());
  const std::size_t count = soup.points.size();
  std::vector<double> H(count, none), K(count, none);
  Points normals(count, Vec3::Constant(none));
  run_interruptibly(
      [&](const CancelToken&, const PostEvent&) {
        const SurfaceModel model = make_surface_model(std::move(soup));
        const CurvatureField field = curvature_field(model.mesh);
        for (std::size_t v = model.soup_vertex.size(); v-- > 0;) {
          const auto point = static_cast<std::size_t>(model.soup_vertex[v]);
          H[point] = field.H[v];
          K[point] = field.K[v];
          normals[point] = field.normals[v];
        }
      },
      py::none());
  return py::dict("H"_a = array_of<double>(std::move(H)), "K"_a = array_of<double>(std::move(K)),
                  "normals"_a = points_array(std::move(normals)));
}

py::dict read(const std::filesystem::path& path, bool weld, bool all_digits) {
  ImportedMesh mesh;
  run_interruptibly(
      [&](const CancelToken&, const PostEvent&) {
        mesh = read_mesh(path, weld ? CoincidentVertices::weld : CoincidentVertices::keep,
                         all_digits ? FloatText::all_digits : FloatText::nearest_float);
      },
      py::none());
  const ImportReport& report = mesh.report;
  py::dict counts("format"_a = report.format, "vertices"_a = report.vertices, "faces"_a = report.faces,
                  "triangles"_a = report.triangles, "polygons_triangulated"_a = report.polygons_triangulated,
                  "vertices_welded"_a = report.vertices_welded, "vertices_joined"_a = report.vertices_joined,
                  "near_vertices_joined"_a = report.near_vertices_joined, "largest_join"_a = report.largest_join,
                  "unreferenced_vertices"_a = report.unreferenced_vertices,
                  "coincident_vertices"_a = report.coincident_vertices, "degenerate_faces"_a = report.degenerate_faces,
                  "duplicate_faces"_a = report.duplicate_faces);
  const py::object carried = carried_by(mesh.soup);
  return py::dict("vertices"_a = points_array(std::move(mesh.soup.points)),
                  "faces"_a = triangles_array(std::move(mesh.soup.triangles)),
                  "colors"_a = colors_array(std::move(mesh.soup.colors)), "report"_a = counts, "carried"_a = carried);
}

std::vector<std::string> write(const std::filesystem::path& path, const py::array& vertices, const py::array& faces,
                               const py::object& colors, bool ascii, const py::object& carried) {
  TriangleSoup soup = soup_of(vertices, faces, colors);
  if (!is_of_arrays(carried)) carry(carried, soup);  // which have names that no file format knows
  const py::gil_scoped_release others_may_run;
  WriteScanOptions options;
  options.encoding = ascii ? Encoding::ascii : Encoding::binary;
  std::vector<std::string> remarks;
  for (const Message& remark : write_scan(path, soup, options).remarks) remarks.push_back(remark.english());
  return remarks;
}

py::dict sample() {
  TriangleSoup soup = make_sample_scan();
  return py::dict("vertices"_a = points_array(std::move(soup.points)),
                  "faces"_a = triangles_array(std::move(soup.triangles)));
}

/// Each error of the engine as an exception of Python with the same words. Those registered last are tried first.
void register_errors(py::module_& m) {
  const auto bases = [](const py::object& first, PyObject* second) {
    return py::make_tuple(first, py::reinterpret_borrow<py::object>(second));
  };
  const auto& error = py::register_exception<Error>(m, "Error");
  const py::tuple file_error = bases(error, PyExc_OSError), value_error = bases(error, PyExc_ValueError);
  py::register_exception<ReadError>(m, "ReadError", file_error);
  py::register_exception<WriteError>(m, "WriteError", file_error);
  const py::object invalid = py::register_exception<InvalidArgument>(m, "InvalidArgument", value_error);
  error.attr("__doc__") = "Base of what Loopmend raises. The message says what is wrong, where, and what to do.";
  m.attr("ReadError").attr("__doc__") = "A file cannot be read: it is missing, no mesh, malformed or damaged.";
  m.attr("WriteError").attr("__doc__") = "A file cannot be written. What stood there before is untouched.";
  invalid.attr("__doc__") =
      "An argument is out of its range, of a wrong shape, or names something that does not exist.";
}

/// @throws ImportError where this pybind11 reads arrays as the NumPy at hand no longer lays them out.
void check_numpy() {
#if PYBIND11_VERSION_HEX < 0x020C0000
  const auto numpy = py::module_::import("numpy").attr("__version__").cast<std::string>();
  if (numpy.rfind("1.", 0) != 0)
    throw py::import_error("loopmend was built with pybind11 older than 2.12, which does not know NumPy " + numpy +
                           ". Build the wheel with a newer pybind11, or use NumPy 1.");
#endif
}

}  // namespace

PYBIND11_MODULE(_core, m) {
  check_numpy();
  m.doc() = "The engine of Loopmend. Use the package loopmend, which documents and types it.";
  m.attr("__version__") = version();
  register_errors(m);
  m.def("fill", &fill, "vertices"_a, "faces"_a, "colors"_a, "options"_a, "progress"_a, "carried"_a);
  m.def("check", &check_mesh, "vertices"_a, "faces"_a);
  m.def("boundary_loops", &boundary_loops, "vertices"_a, "faces"_a);
  m.def("curvatures", &curvatures, "vertices"_a, "faces"_a);
  m.def("read", &read, "path"_a, "weld"_a, "all_digits"_a);
  m.def("write", &write, "path"_a, "vertices"_a, "faces"_a, "colors"_a, "ascii"_a, "carried"_a);
  m.def("sample", &sample);
  define_carried(m);
  define_problems(m);
}

}  // namespace loopmend
