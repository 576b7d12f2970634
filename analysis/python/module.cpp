// The Python module `foveola`: three functions that load a scene, render it, and read a study's
// file as data frames.
#include <exception>
#include <new>
#include <string_view>
#include <utility>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "analysis/python/scene_renders.h"
#include "analysis/python/study_frames.h"
#include "renderer/base/angles.h"
#include "renderer/base/build_info.h"
#include "renderer/base/error.h"

namespace py = pybind11;

namespace foveola::analysis {
namespace {

constexpr const char* load_scene_text = R"(Load a scene for rendering.

scene: a built-in scene's name ("arcade", "church", "meeting-room", "schoolroom", "studio-car"),
or the path of a .glb, .gltf or .obj file, or of a descriptor, as str or pathlib.Path.
camera_m: where the camera stands, (x, y, z) in metres; None: where the scene says.
head_deg: where it looks, (azimuth, elevation) in degrees; None: where the scene says.
threads: of loading and of rendering; 0: one for each core.

What loading warns of is given to Python's warnings. Raises foveola.Error for what is wrong with
the scene.)";

constexpr const char* render_text = R"(Render a scene.

method: where the samples go: "od" (uniform over the 360-degree image), "vp" (uniform over the
view), "fv" (by visual acuity around the gaze), or any text that `foveola render --method` takes;
the image is then of 360 degrees. None: an ordinary picture of what the camera sees.
gaze_deg: (azimuth, elevation) of the gaze in degrees; None: where the head points.
size: (width, height) in pixels; None: 1024 x 512, or what suits the camera in a picture.
samples_per_pixel, samples, seconds: how much is rendered; one of them at most. Without any: 16
samples for each pixel.
seed: the same seed gives the same image, but for `seconds`.
max_depth: the maximum number of surface vertices of a path.

Returns a Rendering. Ctrl-C stops it with KeyboardInterrupt. Samples that are not finite are left
out, listed in `dropped`, and warned of.)";

constexpr const char* read_study_text = R"(Read a study's file as data frames of pandas.

file: a study's .sqlite. It is verified first, and never changed.
unverified: read it even if it fails its verification.
withdrawn: with the data of sessions that participants withdrew from.

Returns a dictionary of data frames: "trials" (a row for each trial's last timing), "answers" (of
questionnaires), "participants" (a row for each analysed participant), "trials_timed_again" (the
timings that do not count), with the columns of the files that `foveola analyze` writes. attrs of
each has "participant_kind" ("human", "pilot" or "simulated"), "record" ("verified" or "changed"),
and "units" and "meanings" of its columns.)";

/// Returns a text, or a pathlib path. Throws UsageError if it contains NUL, which ends names in the
/// system.
std::string file_name(const py::object& text_or_path, const char* name) {
  auto text = py::module_::import("os").attr("fsencode")(text_or_path).cast<std::string>();
  if (text.find('\0') != std::string::npos) {
    throw UsageError(name, "contains a NUL character", "remove the character");
  }
  return text;
}

py::tuple degrees_of(const AzimuthElevation& angles) {
  return py::make_tuple(degrees(angles.azimuth_rad), degrees(angles.elevation_rad));
}

/// Makes `__new__`, which would leave an object without a value, a TypeError.
void forbid_construction(const py::handle& type) {
  reinterpret_cast<PyTypeObject*>(type.ptr())->tp_new = nullptr;
}

void define_scene(py::module_& module) {
  using Scene = std::unique_ptr<SceneForPython, DeleteUnlessForked>;
  py::class_<SceneForPython, Scene> type(module, "Scene", "A scene that load_scene() loaded.");
  forbid_construction(type);
  type.def_property_readonly("name",
                             [](const SceneForPython& scene) { return scene.loaded.source.name; })
      .def_property_readonly(
          "camera_m",
          [](const SceneForPython& scene) {
            const DVec3 place = DVec3(scene.loaded.camera.position) + scene.loaded.scene.origin;
            return py::make_tuple(place.x, place.y, place.z);
          },
          "The camera's position, in metres.")
      .def_property_readonly(
          "head_deg",
          [](const SceneForPython& scene) { return degrees_of(scene.loaded.camera.heading); },
          "The camera's direction: azimuth and elevation in degrees.")
      .def_property_readonly("triangles", [](const SceneForPython& scene) {
        return scene.loaded.scene.triangle_count();
      });
  module.def(
      "load_scene",
      [](const py::object& scene, const std::optional<std::array<double, 3>>& camera_m,
         const std::optional<AnglesDeg>& head_deg, int threads) {
        const RenderSettings settings = scene_settings(camera_m, head_deg, threads);
        return Scene(new SceneForPython(file_name(scene, "scene"), settings));
      },
      load_scene_text, py::arg("scene"), py::kw_only(), py::arg("camera_m") = py::none(),
      py::arg("head_deg") = py::none(), py::arg("threads") = 0);
}

void define_render(py::module_& module) {
  py::class_<RenderForPython> type(module, "Rendering", "The result of render().");
  forbid_construction(type);
  type.def_readonly("radiance", &RenderForPython::radiance,
                    "Linear Rec. 709, float32, of shape (height, width, 3); the first row is the "
                    "top. Black where there are no samples.")
      .def_readonly("samples", &RenderForPython::samples,
                    "Number of samples per pixel, of shape (height, width).")
      .def_readonly("seconds", &RenderForPython::seconds, "Duration of rendering.")
      .def_readonly("dropped", &RenderForPython::dropped,
                    "(x, y, index) of each sample that was not finite; `foveola render --replay` "
                    "traces it again.");
  const TraceSettings usual;
  module.def(
      "render",
      [](const SceneForPython& scene, const std::optional<std::string>& method,
         const std::optional<AnglesDeg>& gaze_deg, const std::optional<std::pair<int, int>>& size,
         const std::optional<double>& samples_per_pixel, const std::optional<std::int64_t>& samples,
         const std::optional<double>& seconds, std::uint32_t seed, int max_depth) {
        return render_for_python(scene, {.method = method,
                                         .gaze_deg = gaze_deg,
                                         .size = size,
                                         .budget = {samples_per_pixel, samples, seconds},
                                         .trace = {.max_depth = max_depth, .seed = seed}});
      },
      render_text, py::arg("scene"), py::arg("method") = py::none(), py::kw_only(),
      py::arg("gaze_deg") = py::none(), py::arg("size") = py::none(),
      py::arg("samples_per_pixel") = py::none(), py::arg("samples") = py::none(),
      py::arg("seconds") = py::none(), py::arg("seed") = usual.seed,
      py::arg("max_depth") = usual.max_depth);
}

/// A message may contain a file's name, whose bytes need not be UTF-8.
void raise(const py::object& kind, const Error& error) {
  const std::string_view message = error.what();
  const auto text = py::reinterpret_steal<py::object>(PyUnicode_DecodeUTF8(
      message.data(), static_cast<Py_ssize_t>(message.size()), "backslashreplace"));
  PyErr_SetObject(kind.ptr(), text.ptr());
}

void define_errors(py::module_& module) {
  static const py::exception<Error> error(module, "Error", PyExc_RuntimeError);
  static const py::exception<UsageError> usage_error(module, "UsageError", error.ptr());
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(std::move(thrown));
    } catch (const UsageError& fault) {
      raise(usage_error, fault);
    } catch (const Error& fault) {
      raise(error, fault);
    } catch (const std::bad_alloc&) {
      PyErr_SetString(PyExc_MemoryError, "not enough memory; try a smaller image or scene");
    }
  });
}

}  // namespace

PYBIND11_MODULE(foveola, module) {
  module.doc() = "A laboratory for foveated previews: load_scene, render and read_study.";
  module.attr("__version__") = build_info().version;
  // Imports numpy now, as its types need it. Otherwise, of two threads that need it first, one
  // imports it and waits for the lock of the other, which waits for that import.
  (void)py::dtype::of<float>();
  py::module_::import("atexit").attr("register")(py::cpp_function(end_renders));
  define_errors(module);
  define_scene(module);
  define_render(module);
  module.def(
      "read_study",
      [](const py::object& file, bool unverified, bool withdrawn) {
        return study_frames(file_name(file, "file"),
                            {.unverified = unverified, .withdrawn = withdrawn});
      },
      read_study_text, py::arg("file"), py::kw_only(), py::arg("unverified") = false,
      py::arg("withdrawn") = false);
}

}  // namespace foveola::analysis
