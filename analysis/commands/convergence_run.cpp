#include "analysis/commands/convergence_run.h"

#include <algorithm>
#include <numbers>
#include <optional>
#include <utility>

#include "renderer/base/clock.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/progress.h"
#include "renderer/commands/warnings.h"
#include "renderer/progressive/loaded_scene.h"
#include "study/stage/scene_stage.h"

namespace foveola::analysis {
namespace {

constexpr int reference_halves_each = 2;

/// A progress line for each thing that is done.
class ProgressLines {
 public:
  void update(const std::string& what, double fraction) {
    if (what != what_) {
      line_.reset();
      line_.emplace(what);
      what_ = what;
    }
    line_->update(fraction);
  }

 private:
  std::string what_;
  std::optional<Progress> line_;
};

std::filesystem::path reference_cache() { return cache_folder() / "references"; }

/// A scene that is loaded to be measured.
struct LoadedSubject {
  LoadedScene loaded;
  Subject subject;

  LoadedSubject(const SceneSource& source, const Workers& workers)
      : loaded(source, workers), subject{.loaded = loaded, .key = study::scene_key(loaded)} {
    print_warnings(loaded.warnings);
  }
};

/// Turned into [-pi, pi], as directions have their azimuths.
AzimuthElevation gaze_of(const LoadedScene& loaded, int gaze, int gazes) {
  const double turn_rad = 2.0 * std::numbers::pi * gaze / gazes;
  return azimuth_elevation(
      direction_from({.azimuth_rad = loaded.camera.heading.azimuth_rad + turn_rad}));
}

/// Measures gaze after gaze, and shares out the time that is left.
class WholeMeasurement {
 public:
  WholeMeasurement(const ConvergenceRun& run, std::stop_token stop)
      : run_(run),
        stop_(std::move(stop)),
        start_(clock_.now()),
        gazes_left_(run.scenes.size() * static_cast<std::size_t>(run.gazes)) {}

  MeasuredGazes measure() {
    for (const SceneSource& source : run_.scenes) {
      measure_scene(source);
    }
    return std::move(results_);
  }

 private:
  void measure_scene(const SceneSource& source) {
    if (stop_.stop_requested()) {
      return;
    }
    const Workers workers(run_.threads);
    LoadedSubject scene(source, workers);
    scene.subject.add_tracers_for(run_.plan.configurations, workers);
    for (int i = 0; i < run_.gazes && !stop_.stop_requested(); ++i) {
      measure_gaze(scene.subject, workers, gaze_of(scene.loaded, i, run_.gazes));
    }
  }

  void measure_gaze(const Subject& subject, const Workers& workers, const AzimuthElevation& gaze) {
    ProgressLines lines;
    const ReportProgress progress = [&lines](const std::string& what, double fraction) {
      lines.update(what, fraction);
    };
    try {
      const GazeBench bench(subject, run_.plan, gaze, workers, reference_cache(), progress, stop_);
      GazeMeasurement measurement = bench.measure(limit_s(), progress);
      if (!measurement.repetitions.empty()) {
        results_.measurements.push_back(std::move(measurement));
        results_.crops.push_back(bench.crops());
        results_.exposure_stops.push_back(subject.loaded.source.exposure_stops.value_or(0.0));
      }
    } catch (const Error&) {
      // A reference that was stopped takes nothing from what was measured before.
      if (!stop_.stop_requested()) {
        throw;
      }
    }
    --gazes_left_;
  }

  /// The time that the repetitions of the next gaze may take; 0: no limit.
  double limit_s() const {
    constexpr double least_s = 1.0;
    if (run_.limit_s <= 0.0) {
      return 0.0;
    }
    const double left_s = run_.limit_s - seconds(clock_.now() - start_);
    return std::max(least_s, left_s / static_cast<double>(gazes_left_));
  }

  const ConvergenceRun& run_;
  std::stop_token stop_;
  SteadyClock clock_;
  Nanoseconds start_;
  std::size_t gazes_left_;
  MeasuredGazes results_;
};

/// The scenes of a run, of which the one that was last asked for is loaded: two would need twice
/// the memory.
class CurrentScene {
 public:
  /// With tracers for the configurations.
  CurrentScene(const std::vector<SceneSource>& sources,
               const std::vector<Configuration>& configurations, const Workers& workers)
      : sources_(sources), configurations_(configurations), workers_(workers) {}

  const LoadedSubject& at(std::size_t index) {
    if (!scene_ || index != index_) {
      scene_.reset();
      scene_.emplace(sources_[index], workers_);
      scene_->subject.add_tracers_for(configurations_, workers_);
      index_ = index;
    }
    return *scene_;
  }

 private:
  const std::vector<SceneSource>& sources_;
  const std::vector<Configuration>& configurations_;
  const Workers& workers_;
  std::optional<LoadedSubject> scene_;
  std::size_t index_ = 0;
};

}  // namespace

MeasuredGazes measure_all(const ConvergenceRun& run, const std::stop_token& stop) {
  return WholeMeasurement(run, stop).measure();
}

std::vector<GazePart> gaze_parts(const Shard& shard, std::size_t scenes, int gazes,
                                 int repetitions) {
  const std::int64_t each = repetitions;
  const ItemRange items = part_of(shard, static_cast<std::int64_t>(scenes) * gazes * each);
  std::vector<GazePart> parts;
  for (std::int64_t next = items.begin; next < items.end;) {
    const std::int64_t gaze = next / each;
    const std::int64_t first = next % each;
    const std::int64_t end = std::min(each, first + items.end - next);
    parts.push_back({.scene = static_cast<std::size_t>(gaze / gazes),
                     .gaze = static_cast<int>(gaze % gazes),
                     .repetitions = {.begin = first, .end = end}});
    next += end - first;
  }
  return parts;
}

std::vector<MeasuredPart> measure_part(const ConvergenceRun& run, const Shard& shard,
                                       const std::stop_token& stop) {
  const Workers workers(run.threads);
  std::vector<MeasuredPart> measured;
  CurrentScene scenes(run.scenes, run.plan.configurations, workers);
  for (const GazePart& part :
       gaze_parts(shard, run.scenes.size(), run.gazes, run.plan.most_repetitions)) {
    const LoadedSubject& scene = scenes.at(part.scene);
    ProgressLines lines;
    const ReportProgress progress = [&lines](const std::string& what, double fraction) {
      lines.update(what, fraction);
    };
    const GazeBench bench(scene.subject, run.plan, gaze_of(scene.loaded, part.gaze, run.gazes),
                          workers, reference_cache(), progress, stop);
    measured.push_back({scene.subject.key, bench.measure(part.repetitions, progress)});
  }
  return measured;
}

std::int64_t render_references(const ConvergenceRun& run, const Shard& shard,
                               const std::stop_token& stop) {
  const Workers workers(run.threads);
  const std::vector<Configuration> none;
  CurrentScene scenes(run.scenes, none, workers);
  std::int64_t halves = 0;
  for (const GazePart& part :
       gaze_parts(shard, run.scenes.size(), run.gazes, reference_halves_each)) {
    const LoadedSubject& scene = scenes.at(part.scene);
    const Vec3 gaze = direction_from(gaze_of(scene.loaded, part.gaze, run.gazes));
    for (std::int64_t half = part.repetitions.begin; half < part.repetitions.end; ++half) {
      Progress progress("reference of " + scene.loaded.source.name);
      (void)reference_half(
          scene.subject, run.plan, gaze, static_cast<std::uint32_t>(half), workers,
          reference_cache(), [&](double fraction) { progress.update(fraction); }, stop);
      ++halves;
    }
  }
  return halves;
}

}  // namespace foveola::analysis
