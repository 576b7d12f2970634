#include "analysis/convergence/convergence_plan.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/error.h"
#include "renderer/base/transformed.h"
#include "renderer/view/view_sampler.h"

namespace foveola::analysis {
namespace {

const OptionRow& find_option(const std::string& name) {
  const std::vector<OptionRow>& rows = option_rows();
  const auto found = std::ranges::find(rows, name, &OptionRow::name);
  if (found == rows.end()) {
    const std::vector<std::string> names = transformed(rows, &OptionRow::name);
    throw UsageError("--options", fmt::format("'{}' is not an option", name),
                     fmt::format("choose from: {}", fmt::join(names, ", ")));
  }
  return *found;
}

bool is_setting(std::string_view text) {
  const std::size_t mark = text.find_first_of("=:*\"");
  return mark != std::string_view::npos && text[mark] == '=';
}

/// Changes a configuration to a plain path tracer of 2017, with multiple importance sampling.
void make_plain_with_mis(Configuration& configuration) {
  configuration.render.numbers = RandomNumbers::independent;
  configuration.light_sampling = {.selection = LightSelection::uniform,
                                  .triangles_by_area = true,
                                  .environment_by_cosine = true};
  configuration.render.trace.vertices_before_roulette = no_roulette;
}

/// Changes a configuration to a plain path tracer of 2017, without multiple importance sampling.
void make_plain(Configuration& configuration) {
  make_plain_with_mis(configuration);
  configuration.render.trace.light_samples_alone = true;
}

}  // namespace

std::vector<std::string> split_methods(std::string_view text) {
  std::vector<std::string> methods;
  bool is_quoted = false;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    const bool ends = i == text.size() || (text[i] == ',' && !is_quoted);
    if (!ends) {
      is_quoted ^= text[i] == '"';
      continue;
    }
    const std::string_view piece = text.substr(begin, i - begin);
    if (!methods.empty() && is_setting(piece)) {
      methods.back() += fmt::format(",{}", piece);
    } else {
      methods.emplace_back(piece);
    }
    begin = i + 1;
  }
  return methods;
}

const std::vector<OptionRow>& option_rows() {
  using C = Configuration&;
  static const std::vector<OptionRow> rows = {
      {"independent", ", independent numbers",
       [](C c) { c.render.numbers = RandomNumbers::independent; }},
      {"clamp", ", samples cut at 10", [](C c) { c.render.trace.largest_radiance = 10.0F; }},
      {"adaptive", ", adaptive", [](C c) { c.render.adaptive = VisibleNoise{.contrast = 0.01}; }},
      {"no-fast-path", ", general path", [](C c) { c.render.trace.uses_general_path = true; }},
      {"no-hierarchy", ", lights by power alone",
       [](C c) { c.light_sampling.selection = LightSelection::by_power_alone; }},
      {"no-learning", ", nothing learned", [](C c) { c.light_sampling.learns = false; }},
      {"uniform-lights", ", lights uniformly",
       [](C c) { c.light_sampling.selection = LightSelection::uniform; }},
      {"area-lights", ", triangles by area",
       [](C c) { c.light_sampling.triangles_by_area = true; }},
      {"cosine-sky", ", sky by cosine", [](C c) { c.light_sampling.environment_by_cosine = true; }},
      {"no-mis", ", light samples alone", [](C c) { c.render.trace.light_samples_alone = true; }},
      {"no-roulette", ", no roulette",
       [](C c) { c.render.trace.vertices_before_roulette = no_roulette; }},
      {"plain-paths", ", plain paths", make_plain},
      {"plain-paths-mis", ", plain paths with MIS", make_plain_with_mis},
      {"plain-paths-mis-clamp", ", plain paths with MIS, light samples cut at 3", [](C c) {
         make_plain_with_mis(c);
         c.render.trace.largest_light_sample = 3.0F;
       }}};
  return rows;
}

std::vector<Configuration> make_configurations(const std::vector<std::string>& methods,
                                               const std::vector<std::string>& options) {
  std::vector<Configuration> configurations;
  for (const std::string& method : methods) {
    (void)make_view_sampler(method);
    configurations.push_back({.name = method, .method = method});
  }
  if (configurations.empty()) {
    throw UsageError("--methods", "is empty", "name at least the baseline, for example od");
  }
  for (const std::string& option : options) {
    const OptionRow& row = find_option(option);
    Configuration changed = configurations.front();
    row.apply(changed);
    changed.name += row.suffix;
    configurations.push_back(changed);
  }
  for (auto one = configurations.begin(); one != configurations.end(); ++one) {
    if (std::any_of(configurations.begin(), one,
                    [&](const auto& o) { return o.name == one->name; })) {
      throw UsageError("--methods", fmt::format("'{}' is repeated", one->name),
                       "name each method once");
    }
  }
  return configurations;
}

std::vector<std::uint64_t> checkpoints(const ConvergencePlan& plan) {
  // With 59 times the baseline's density, FV needs a 237th of all samples for the error of the
  // baseline with a quarter. More halvings would give inefficiently small batches.
  constexpr int halvings = 8;
  const std::uint64_t last = static_cast<std::uint64_t>(plan.samples_per_pixel) *
                             static_cast<std::uint64_t>(plan.size.x) *
                             static_cast<std::uint64_t>(plan.size.y);
  std::vector<std::uint64_t> counts;
  for (int halving = halvings; halving >= 0; --halving) {
    if (const std::uint64_t count = last >> halving; count > 0) {
      counts.push_back(count);
    }
  }
  return counts;
}

void Subject::add_tracers_for(const std::vector<Configuration>& configurations,
                              const Workers& workers) {
  for (const Configuration& configuration : configurations) {
    if (tracer_for(configuration.light_sampling) == nullptr) {
      other_tracers.push_back(
          {.light_sampling = configuration.light_sampling,
           .tracer = PathTracer(loaded.scene, workers, configuration.light_sampling)});
      other_tracers.back().tracer.learn_lights(loaded.camera.position, workers);
    }
  }
}

const PathTracer* Subject::tracer_for(const LightSampling& light_sampling) const {
  if (light_sampling == LightSampling{}) {
    return &loaded.tracer;
  }
  const auto found = std::ranges::find(other_tracers, light_sampling, &OtherTracer::light_sampling);
  return found != other_tracers.end() ? &found->tracer : nullptr;
}

std::string gaze_name(const AzimuthElevation& gaze) {
  const auto rounded = [](double angle_rad) {
    constexpr double per_degree = 1e3;
    // Adding zero turns -0 into 0.
    return std::round(per_degree * degrees(angle_rad)) / per_degree + 0.0;
  };
  return fmt::format("{},{}", rounded(gaze.azimuth_rad), rounded(gaze.elevation_rad));
}

}  // namespace foveola::analysis
