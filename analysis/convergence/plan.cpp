#include "analysis/convergence/plan.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/error.h"
#include "renderer/view/view_sampler.h"

namespace foveola::analysis {
namespace {

const OptionRow& find_option(const std::string& name) {
  const std::vector<OptionRow>& rows = option_rows();
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.name == name; });
  if (found == rows.end()) {
    std::vector<std::string> names;
    for (const OptionRow& row : rows) {
      names.push_back(row.name);
    }
    throw UsageError("--options", fmt::format("there is no option '{}'", name),
                     fmt::format("choose from: {}", fmt::join(names, ", ")));
  }
  return *found;
}

bool is_setting(std::string_view text) {
  const std::size_t mark = text.find_first_of("=:*\"");
  return mark != std::string_view::npos && text[mark] == '=';
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
  static const std::vector<OptionRow> rows = {
      {.name = "independent",
       .suffix = ", independent numbers",
       .apply = [](Contender& contender) { contender.numbers = RandomNumbers::independent; }},
      {.name = "clamp",
       .suffix = ", samples cut at 10",
       .apply = [](Contender& contender) { contender.largest_radiance = 10.0F; }},
      {.name = "spare-done",
       .suffix = ", done pixels spared",
       .apply = [](Contender& contender) { contender.spare_done_contrast = 0.01; }},
      {.name = "no-skip",
       .suffix = ", nothing skipped",
       .apply = [](Contender& contender) { contender.is_general = true; }},
      {.name = "no-hierarchy",
       .suffix = ", lights by power alone",
       .apply = [](Contender& contender) {
         contender.light_selection = LightSelection::by_power_alone;
       }}};
  return rows;
}

std::vector<Contender> make_contenders(const std::vector<std::string>& methods,
                                       const std::vector<std::string>& options) {
  std::vector<Contender> contenders;
  for (const std::string& method : methods) {
    (void)make_view_sampler(method);
    contenders.push_back({.name = method, .method = method});
  }
  if (contenders.empty()) {
    throw UsageError("--methods", "is empty", "name at least the baseline, for instance od");
  }
  for (const std::string& option : options) {
    const OptionRow& row = find_option(option);
    Contender changed = contenders.front();
    row.apply(changed);
    changed.name += row.suffix;
    contenders.push_back(changed);
  }
  for (auto one = contenders.begin(); one != contenders.end(); ++one) {
    if (std::any_of(contenders.begin(), one, [&](const auto& o) { return o.name == one->name; })) {
      throw UsageError("--methods", fmt::format("'{}' comes twice", one->name), "name each once");
    }
  }
  return contenders;
}

std::vector<std::uint64_t> checkpoints(const ConvergencePlan& plan) {
  // With 59 times the baseline's density, FV needs a 237th of all samples for what the baseline has
  // with a quarter. More halvings would make renders of batches that are too small to be efficient.
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

std::string gaze_name(const AzimuthElevation& gaze) {
  const auto rounded = [](double angle_rad) {
    constexpr double per_degree = 1e3;
    // Adding zero makes nought of a negative one.
    return std::round(per_degree * degrees(angle_rad)) / per_degree + 0.0;
  };
  return fmt::format("{},{}", rounded(gaze.azimuth_rad), rounded(gaze.elevation_rad));
}

}  // namespace foveola::analysis
