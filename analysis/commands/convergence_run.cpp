#include "analysis/commands/convergence_run.h"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>

#include "renderer/base/clock.h"
#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "renderer/base/text/print.h"
#include "renderer/base/work/work_scope.h"
#include "renderer/progressive/loaded_scene.h"
#include "study/stage/scene_stage.h"

namespace foveola::analysis {
namespace {

std::filesystem::path reference_cache() { return cache_folder() / "references"; }

struct LoadedSubject {
  LoadedScene loaded;
  Subject subject;

  LoadedSubject(const SceneSource& source, const Workers& workers)
      : loaded(source, workers), subject{.loaded = loaded, .key = study::scene_key(loaded)} {
    print_warnings(loaded.warnings);
  }
};

/// Returns the gaze, wrapped to [-pi, pi] like azimuths of directions.
AzimuthElevation gaze_of(const LoadedScene& loaded, int gaze, int gazes) {
  const double turn_rad = 2.0 * std::numbers::pi * gaze / gazes;
  return azimuth_elevation(
      direction_from({.azimuth_rad = loaded.camera.heading.azimuth_rad + turn_rad}));
}

/// Measures one gaze after the other, and divides the remaining time among them.
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
    StepProgress lines;
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
      // A stopped reference does not affect the earlier measurements.
      if (!stop_.stop_requested()) {
        throw;
      }
    }
    --gazes_left_;
  }

  /// Returns the time limit of the next gaze's repetitions; 0: none.
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

}  // namespace

MeasuredGazes measure_all(const ConvergenceRun& run, const std::stop_token& stop) {
  return WholeMeasurement(run, stop).measure();
}

std::int64_t render_references(const ConvergenceRun& run, const Shard& shard,
                               const std::stop_token& stop) {
  constexpr std::int64_t halves = 2;
  const std::int64_t halves_of_scene = halves * run.gazes;
  const ItemRange part =
      part_of(shard, static_cast<std::int64_t>(run.scenes.size()) * halves_of_scene);
  const Workers workers(run.threads);
  std::optional<LoadedSubject> scene;
  for (std::int64_t i = part.begin; i < part.end; ++i) {
    const SceneSource& source = run.scenes[static_cast<std::size_t>(i / halves_of_scene)];
    if (i == part.begin || i % halves_of_scene == 0) {
      scene.reset();  // two would need twice the memory
      scene.emplace(source, workers);
    }
    const auto gaze = static_cast<int>(i % halves_of_scene / halves);
    Progress progress("reference of " + source.name);
    (void)reference_half(
        scene->subject, run.plan, direction_from(gaze_of(scene->loaded, gaze, run.gazes)),
        static_cast<std::uint32_t>(i % halves), workers, reference_cache(),
        [&](double fraction) { progress.update(fraction); }, stop);
  }
  return part.size();
}

}  // namespace foveola::analysis
