// Plans a measurement of convergence: its configurations, options and effort.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/base/angles.h"
#include "renderer/film/viewport_resampler.h"
#include "renderer/progressive/loaded_scene.h"
#include "renderer/progressive/progressive_render.h"
#include "renderer/trace/paths/path_tracer.h"

namespace foveola::analysis {

/// A compared configuration: a method as shipped, or with one option changed.
struct Configuration {
  std::string name;    ///< for tables: "fv", or "od, independent numbers"
  std::string method;  ///< as make_view_sampler reads it
  /// Film size, depth and seed are the plan's. largest_radiance means less noise, and a bias that
  /// counts as error; largest_light_sample is in units of display white. Adaptive sampling is with
  /// low-discrepancy numbers only; samples of finished pixels go to others nearby, or are left out
  /// but counted.
  ProgressiveSettings render;
  LightSampling light_sampling;
};

/// A quality-speed option: its name, and its change to a configuration.
struct OptionRow {
  std::string name;    ///< name on the command line
  std::string suffix;  ///< suffix of the method's name in tables
  void (*apply)(Configuration& configuration);
};

/// All options that can be measured.
const std::vector<OptionRow>& option_rows();

/// Splits "od,vp,fv:acuity=guenter,cutoff=60" into methods. A comma begins another method unless
/// KEY=VALUE of the previous one follows, or it is within double quotes.
std::vector<std::string> split_methods(std::string_view text);

/// Returns the methods as shipped, the first of which is the baseline, then the baseline with each
/// of the options. Throws Error for an unknown option, and for an invalid or repeated method.
std::vector<Configuration> make_configurations(const std::vector<std::string>& methods,
                                               const std::vector<std::string>& options);

/// Maximum number of repetitions of a plan. Plans with different seeds share no repetition.
inline constexpr std::uint32_t max_repetitions = 1000;
inline constexpr std::uint32_t max_seed = 1'000'000;

struct ConvergencePlan {
  std::vector<Configuration> configurations;
  IVec2 size{1024, 512};       ///< film size in pixels
  int samples_per_pixel = 32;  ///< samples of every render, on average over the film; at least 16
  int least_repetitions =
      4;  ///< minimum number of renders of each configuration, each with another seed
  int most_repetitions = 4;
  std::uint32_t seed = 0;  ///< source of the repetitions' seeds
  /// The viewport's field of view, both ways; the head points at the gaze.
  double fov_deg = FieldOfView{}.horizontal_deg;
  int view_size = default_view_size.x;  ///< pixels of the display along each side
  int max_depth = TraceSettings{}.max_depth;
  int reference_samples_per_pixel = 64;  ///< uniform samples of each of the two halves
  int reference_foveated_per_pixel =
      8;  ///< additional foveated samples around the gaze, per pixel of the film
  double crop_seconds = 1.0;  ///< rendering time of the crops
  double crop_fov_deg = 30.0;
  int crop_size = 320;  ///< side of a crop in pixels
};

/// Returns the sample counts at which errors are measured, each twice the previous one.
std::vector<std::uint64_t> checkpoints(const ConvergencePlan& plan);

/// A scene to be measured.
struct Subject {
  /// A tracer with another light sampling than the loaded scene's.
  struct OtherTracer {
    LightSampling light_sampling;
    PathTracer tracer;
  };

  const LoadedScene& loaded;
  std::string key;  ///< reference_image()'s scene_key: everything that the radiance depends on
  std::vector<OtherTracer> other_tracers = {};

  /// Builds the tracers for these configurations that are missing.
  void add_tracers_for(const std::vector<Configuration>& configurations, const Workers& workers);
  /// Returns null if there is none.
  const PathTracer* tracer_for(const LightSampling& light_sampling) const;
};

/// Returns "azimuth,elevation" in degrees: the gaze's name in tables.
std::string gaze_name(const AzimuthElevation& gaze);

}  // namespace foveola::analysis
