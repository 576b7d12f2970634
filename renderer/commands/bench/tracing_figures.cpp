#include "renderer/commands/bench/tracing_figures.h"

#include <fmt/format.h>

#include "renderer/base/text/print.h"

namespace foveola {

nlohmann::ordered_json json_of(const TracingFigures& figures, std::uint64_t paths) {
  nlohmann::ordered_json rays;
  nlohmann::ordered_json rays_per_second;
  for (const RayKind& kind : ray_kinds) {
    rays[kind.name] = figures.rays.*kind.count;
    rays_per_second[kind.name] =
        json_of(static_cast<double>(figures.rays.*kind.count) / figures.seconds);
  }
  nlohmann::ordered_json embree;
  for (const EmbreeFigure& figure : figures.embree) {
    nlohmann::ordered_json all;
    for (const auto& [entry_point, time_s] : figure.all) {
      all[entry_point] = json_of(time_s);
    }
    embree[figure.kind] = {{"fastest", figure.entry_point}, {"seconds", all}};
  }
  nlohmann::ordered_json general;
  if (figures.general) {
    general = {{"seconds", json_of(figures.general->seconds)},
               {"gain", json_of(figures.general->gain)}};
  }
  return {{"threads", figures.threads},
          {"seconds", json_of(figures.seconds)},
          {"general_path", general},
          {"paths_per_second", json_of(static_cast<double>(paths) / figures.seconds)},
          {"rays", rays},
          {"rays_per_second", rays_per_second},
          {"embree_seconds", json_of(figures.embree_seconds)},
          {"ratio_to_embree", json_of(figures.ratio_to_embree)},
          {"embree", embree}};
}

namespace {

/// " (2.41 to 2.47)", or empty without an interval.
std::string interval_text(const Median& median) {
  return median.interval
             ? fmt::format(" ({:.2f} to {:.2f})", median.interval->first, median.interval->second)
             : "";
}

}  // namespace

void print_table(const std::vector<TracingFigures>& runs, std::uint64_t paths) {
  constexpr double per_mega = 1e-6;
  for (const TracingFigures& figures : runs) {
    const double time_s = figures.seconds.value;
    print_text(
        "{} thread{}: {:.0f} paths per second, {:.2f}{} times Embree alone, {:.2f} times as fast "
        "as the first\n",
        figures.threads, figures.threads == 1 ? "" : "s", static_cast<double>(paths) / time_s,
        figures.ratio_to_embree.value, interval_text(figures.ratio_to_embree),
        runs.front().seconds.value / time_s);
    if (figures.general) {
      print_text("  the general path takes {:.2f}{} times as long\n", figures.general->gain.value,
                 interval_text(figures.general->gain));
    }
    for (std::size_t i = 0; i < ray_kinds.size(); ++i) {
      const auto rays = static_cast<double>(figures.rays.*ray_kinds[i].count);
      if (rays > 0.0) {
        print_text(
            "  {:<8} {:6.2f} rays per path, {:6.2f} M rays per second; Embree alone {:6.2f} by "
            "{}\n",
            ray_kinds[i].name, rays / static_cast<double>(paths), per_mega * rays / time_s,
            per_mega * rays / figures.embree[i].seconds, figures.embree[i].entry_point);
      }
    }
  }
}

}  // namespace foveola
