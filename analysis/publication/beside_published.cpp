#include "analysis/publication/beside_published.h"

#include <algorithm>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/koskela2018/profile.h"

namespace foveola::analysis {
namespace {

std::string name_of_row(const PublishedScene& original, const std::string& scene) {
  return original.is_counterpart
             ? fmt::format("published: {} (counterpart: {})", original.name, scene)
             : fmt::format("published: {}", original.name);
}

std::string mean_and_deviation(const PublishedTime* time) {
  Description shown;
  if (time != nullptr) {
    shown.mean = time->mean;
    shown.standard_deviation = time->standard_deviation;
  }
  return mean_and_deviation(shown, 1);
}

}  // namespace

std::optional<std::vector<std::string>> published_row(
    const StudyTables& tables, std::size_t mark, std::size_t scene,
    const std::vector<std::string>& methods, const std::optional<PublishedStudy>& published) {
  const std::string& own = tables.set.scenes[scene];
  const auto original = published && is_relative_to_od(tables.set)
                            ? published_scene_of(*published, own)
                            : std::nullopt;
  if (!original) {
    return std::nullopt;
  }
  std::vector<std::string> row = {name_of_row(*original, own)};
  for (const std::string& method : methods) {
    row.push_back(mean_and_deviation(
        published_time(*published, original->name, tables.set.measures[mark].id(), method)));
  }
  return row;
}

std::string published_rows_explained(const StudyTables& tables,
                                     const std::optional<PublishedStudy>& published) {
  const bool has_any =
      published && is_relative_to_od(tables.set) &&
      std::any_of(tables.set.scenes.begin(), tables.set.scenes.end(),
                  [&](const auto& scene) { return published_scene_of(*published, scene); });
  return has_any ? " Published: Table 2 of Koskela et al. 2018, section 5.2. A counterpart is "
                   "Foveola’s own scene in a published one’s place."
                 : "";
}

std::vector<std::string> published_mean_and_difference(const MethodTimes& times,
                                                       const PublishedStudy& published) {
  const auto mean = geometric_mean_of_table_2(published, times.mark, times.method);
  if (!mean) {
    return {"–", "–"};
  }
  const bool is_of_seconds = times.method == "od";
  const auto& own = is_of_seconds ? times.seconds : times.percent_of_baseline;
  return {fixed(mean, 1) + (is_of_seconds ? " s" : " %"),
          own ? with_sign(own->value - *mean, 1) + (is_of_seconds ? " s" : " points") : "–"};
}

}  // namespace foveola::analysis
