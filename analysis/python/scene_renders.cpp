#include "analysis/python/scene_renders.h"

#include <atomic>
#include <chrono>
#include <future>
#include <stop_token>
#include <thread>

#include <fmt/format.h>
#include <unistd.h>

#include "renderer/base/error.h"
#include "renderer/base/transformed.h"
#include "renderer/film/equirect_film.h"
#include "scenes/find_scene.h"

namespace py = pybind11;

namespace foveola::analysis {
namespace {

/// Python shows it as a warning of the caller.
void warn(const std::string& text) {
  if (PyErr_WarnEx(PyExc_UserWarning, text.c_str(), 1) != 0) {
    throw py::error_already_set();
  }
}

void require_not_forked(const char* function) {
  if (is_forked()) {
    throw Error(function, "does not work in a process that was forked after load_scene()",
                R"(fork first, or use multiprocessing.set_start_method("spawn"))");
  }
}

AzimuthElevation angles_of(const AnglesDeg& angles_deg) {
  return {radians(angles_deg.first), radians(angles_deg.second)};
}

constexpr SettingNames names{.camera = "camera_m",
                             .head = "head_deg",
                             .gaze = "gaze_deg",
                             .size = "size",
                             .samples_per_pixel = "samples_per_pixel",
                             .samples = "samples",
                             .seconds = "seconds",
                             .max_depth = "max_depth",
                             .threads = "threads",
                             .remedy = "see help(foveola)"};

RenderSettings settings_of(const RenderArguments& arguments) {
  constexpr IVec2 default_size{1024, 512};
  RenderSettings settings;
  settings.budget = budget_of(arguments.budget, names);
  settings.progressive.trace = arguments.trace;
  std::optional<IVec2> size;
  if (arguments.size) {
    size = IVec2(arguments.size->first, arguments.size->second);
  }
  if (!arguments.method) {
    if (arguments.gaze_deg) {
      throw UsageError("gaze_deg", "cannot be combined with a picture",
                       "give a method, such as \"fv\"");
    }
    settings.picture = PictureChoices{.size = size};
    require_possible(settings, names);
    return settings;
  }
  if (arguments.method->find('\0') != std::string::npos) {
    throw UsageError("method", "contains a NUL character", names.remedy);
  }
  settings.method = *arguments.method;
  settings.progressive.film_size = size.value_or(default_size);
  if (arguments.gaze_deg) {
    settings.gaze = angles_of(*arguments.gaze_deg);
  }
  require_possible(settings, names);
  return settings;
}

std::atomic<int> running_renders = 0;
std::atomic<std::thread::id> last_thread;  // in which the interpreter ends; no thread before

bool is_interpreter_ending() {
  const std::thread::id last = last_thread;
  return last != std::thread::id() && last != std::this_thread::get_id();
}

/// Counts a render until its thread holds Python's lock again. At the interpreter's end Python
/// unwinds daemon threads that want the lock, through destructors, which aborts the process. Such a
/// thread stays asleep instead.
class RunningRender {
 public:
  RunningRender() {
    ++running_renders;
    if (is_interpreter_ending()) {
      const py::gil_scoped_release unlocked;
      sleep_forever();
    }
  }
  ~RunningRender() { --running_renders; }
  RunningRender(const RunningRender&) = delete;
  RunningRender& operator=(const RunningRender&) = delete;

  /// To be called without Python's lock.
  [[noreturn]] static void sleep_forever() {
    --running_renders;
    while (true) {
      ::pause();
    }
  }
};

/// Renders on another thread, because only this one receives Python's Ctrl-C.
Rendering render_interruptibly(const SceneForPython& scene, const RenderSettings& settings) {
  constexpr auto between_looks = std::chrono::milliseconds(50);
  const RunningRender running;
  std::stop_source stop;
  std::future<Rendering> rendering = std::async(std::launch::async, [&] {
    return render(scene.loaded, settings, scene.workers, stop.get_token());
  });
  const py::gil_scoped_release unlocked;
  while (rendering.wait_for(between_looks) != std::future_status::ready) {
    if (is_interpreter_ending()) {
      stop.request_stop();
      rendering.wait();
      RunningRender::sleep_forever();
    }
    const py::gil_scoped_acquire locked;
    if (PyErr_CheckSignals() != 0) {
      stop.request_stop();
      {
        const py::gil_scoped_release while_it_ends;
        rendering.wait();
      }
      throw py::error_already_set();
    }
  }
  return rendering.get();
}

std::vector<std::array<std::uint32_t, 3>> places_of(const std::vector<DroppedSample>& dropped,
                                                    std::uint32_t width) {
  return transformed(dropped, [&](const DroppedSample& sample) {
    return std::array<std::uint32_t, 3>{sample.pixel % width, sample.pixel / width,
                                        sample.sample_number};
  });
}

}  // namespace

bool is_forked() {
  static const pid_t loading_process = ::getpid();
  return ::getpid() != loading_process;
}

void end_renders() {
  if (is_forked()) {
    return;
  }
  last_thread = std::this_thread::get_id();
  const py::gil_scoped_release unlocked;
  while (running_renders > 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

void DeleteUnlessForked::operator()(const SceneForPython* scene) const {
  if (!is_forked()) {
    delete scene;
  }
}

SceneForPython::SceneForPython(const std::string& name_or_path, const RenderSettings& settings)
    : workers(settings.threads), loaded(scenes::find_scene(name_or_path), workers, settings.scene) {
  for (const std::string& warning : loaded.warnings) {
    warn(warning);
  }
}

RenderSettings scene_settings(const std::optional<std::array<double, 3>>& camera_m,
                              const std::optional<AnglesDeg>& head_deg, int threads) {
  require_not_forked("load_scene");
  RenderSettings settings;
  if (camera_m) {
    settings.scene.camera = DVec3((*camera_m)[0], (*camera_m)[1], (*camera_m)[2]);
  }
  if (head_deg) {
    settings.scene.head = angles_of(*head_deg);
  }
  settings.threads = threads;
  require_possible(settings, names);
  return settings;
}

RenderForPython render_for_python(const SceneForPython& scene, const RenderArguments& arguments) {
  require_not_forked("render");
  const Rendering rendering = render_interruptibly(scene, settings_of(arguments));
  const RgbImage& color = rendering.image.color;
  const py::ssize_t height = color.height;
  const py::ssize_t width = color.width;
  RenderForPython result{
      .radiance = py::array_t<float>({height, width, py::ssize_t{3}}, &color.pixels.front().x),
      .samples = py::array_t<std::uint32_t>({height, width}, rendering.image.samples.data()),
      .seconds = rendering.report.seconds,
      .dropped = places_of(rendering.report.non_finite, static_cast<std::uint32_t>(color.width))};
  if (const std::size_t count = result.dropped.size(); count > 0) {
    warn(fmt::format("{} sample{} not finite and left out: see dropped", count,
                     count == 1 ? " was" : "s were"));
  }
  return result;
}

}  // namespace foveola::analysis
