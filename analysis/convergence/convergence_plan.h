// What a measurement of convergence compares, and how long it takes.
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

/// Something that is compared: a method as shipped, or with one option changed.
struct Configuration {
  std::string name;    ///< for tables: "fv", or "od, independent numbers"
  std::string method;  ///< as make_view_sampler reads it
  /// Film size, depth and seed are the plan's. largest_radiance is less noise, and a bias that
  /// counts as error; largest_light_sample is as the display shows it: white is 1. Adaptive
  /// sampling is with low-discrepancy numbers only: samples of pixels that are done go to others
  /// nearby, or are left out though they count as taken.
  ProgressiveSettings render;
  LightSampling light_sampling;
};

/// A row of the quality-speed options: what it is called and what it changes of a configuration.
struct OptionRow {
  std::string name;    ///< what it is called on the command line
  std::string suffix;  ///< behind the method's name in tables
  void (*apply)(Configuration& configuration);
};

/// All options that can be measured.
const std::vector<OptionRow>& option_rows();

/// The methods of "od,vp,fv:acuity=guenter,cutoff=60": a comma begins another method unless what
/// follows it is a KEY=VALUE of the one before, or it stands in double quotes.
std::vector<std::string> split_methods(std::string_view text);

/// The methods as shipped, the first of which is the baseline, and then the baseline with each of
/// the options. Throws Error for an option that does not exist, a method that makes no sense or
/// that comes twice.
std::vector<Configuration> make_configurations(const std::vector<std::string>& methods,
                                               const std::vector<std::string>& options);

/// Of a plan. Plans with different seeds have no repetition in common.
inline constexpr std::uint32_t max_repetitions = 1000;
inline constexpr std::uint32_t max_seed = 1'000'000;

struct ConvergencePlan {
  std::vector<Configuration> configurations;
  IVec2 size{1024, 512};       ///< film size in pixels
  int samples_per_pixel = 32;  ///< samples of every render, on average over the film; at least 16
  int least_repetitions = 4;   ///< renders of each configuration, each with another seed
  int most_repetitions = 4;
  std::uint32_t seed = 0;  ///< what the repetitions' seeds are made from
  /// The viewport's field of view, both ways; the head points at the gaze.
  double fov_deg = FieldOfView{}.horizontal_deg;
  int view_size = default_view_size.x;  ///< pixels of the display along each side
  int max_depth = TraceSettings{}.max_depth;
  int reference_samples_per_pixel = 64;  ///< uniform samples of each of the two halves
  int reference_foveated_per_pixel =
      8;  ///< further samples, foveated around the gaze, for each pixel of the film
  double crop_seconds = 1.0;  ///< rendering time of the crops that stand side by side
  double crop_fov_deg = 30.0;
  int crop_size = 320;  ///< pixels of a crop along each side
};

/// The numbers of samples after which errors are measured, each twice the one before.
std::vector<std::uint64_t> checkpoints(const ConvergencePlan& plan);

/// A scene that is measured.
struct Subject {
  /// A tracer of the scene that draws lights in another way than the loaded scene's.
  struct OtherTracer {
    LightSampling light_sampling;
    PathTracer tracer;
  };

  const LoadedScene& loaded;
  std::string key;  ///< reference_image()'s scene_key: all that the radiance depends on
  std::vector<OtherTracer> other_tracers = {};

  /// Builds what tracer_for() lacks for these configurations.
  void add_tracers_for(const std::vector<Configuration>& configurations, const Workers& workers);
  /// Null if there is none.
  const PathTracer* tracer_for(const LightSampling& light_sampling) const;
};

/// "azimuth,elevation" in degrees: how a gaze is called in tables.
std::string gaze_name(const AzimuthElevation& gaze);

}  // namespace foveola::analysis
