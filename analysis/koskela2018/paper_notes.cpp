#include "analysis/koskela2018/paper_notes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"

namespace foveola::analysis {
namespace {

std::map<std::string, double> mean_artifacts(const StudyTables& tables) {
  std::map<std::string, double> means;
  for (const MethodRatings& row : tables.ratings) {
    if (row.rating == "artifacts" && row.description.mean) {
      means[row.method] = *row.description.mean;
    }
  }
  return means;
}

std::string with_order(const std::string& sentence, const StudyTables& tables) {
  const std::string order = artifacts_in_order(tables);
  return order.empty() ? sentence : sentence + " " + order;
}

}  // namespace

std::string artifacts_in_order(const StudyTables& tables) {
  const std::map<std::string, double> means = mean_artifacts(tables);
  std::vector<std::pair<double, std::string>> order;
  for (const char* method : {"od", "vp", "fv"}) {
    if (!means.contains(method)) {
      return "";
    }
    order.emplace_back(means.at(method), method);
  }
  std::ranges::stable_sort(order, [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> words;
  for (const auto& [mean, method] : order) {
    words.push_back(fmt::format("{} {:.2f}", method_label(method), mean));
  }
  const double od = means.at("od");
  const double vp = means.at("vp");
  const double fv = means.at("fv");
  return fmt::format(
      "Section 5.3 says in words only that FV is perceived to have almost the same quality as OD, "
      "and that VP clearly has the most artifacts. Here the mean ratings, from the fewest "
      "artifacts to the most, are {}: VP {} the most, and FV {} nearer to OD than to VP.",
      comma_list(words), vp > std::max(od, fv) ? "has" : "does not have",
      std::abs(fv - od) < std::abs(fv - vp) ? "is" : "is not");
}

PaperNotes paper_notes(const StudyTables& tables, const std::optional<PublishedStudy>& published) {
  if (!published) {
    return {};
  }
  const auto figure = [&](const char* id) { return published_number(*published, id).value; };
  return {
      .times_by_scene = "Table 2 of the paper (section 5.2).",
      .percentages =
          "The paper does not say how its percentages and percentage points were formed. Both "
          "readings are here: each participant’s own ratio, then the ratio of means.",
      .times_by_method = fmt::format(
          "The paper shows geometric means over its five scenes in Fig. 5, in seconds and without "
          "numbers. Section 5.2 states that FV took around {:g} % of OD’s time, which is {:g} "
          "times faster, VP {:g} times faster than OD, and FV {:g} times faster than VP.",
          figure("fv_percent_of_od"), figure("speedup_fv_over_od"), figure("speedup_vp_over_od"),
          figure("speedup_fv_over_vp")),
      .ratings = with_order("The rating artifacts is that of the paper’s Fig. 6: how prevalent "
                            "disturbing artifacts were in the other areas of the image, looked at "
                            "once a method’s times were measured (section 4.2).",
                            tables),
      .means_of_ratings = "The paper’s Fig. 6 shows arithmetic means and standard deviations, too.",
      .latency = fmt::format("The paper’s is in Fig. 7: at best approximately {:g} ms (section "
                             "5.6).",
                             figure("best_latency_ms")),
      .background = fmt::format(
          "Section 5.1 took the questions 3 and 4 of Table 1, here graphics_3d and "
          "offline_rendering, against the difference between OD and FV, and found P = {:g}. It "
          "says neither of which mark, nor how times were averaged, nor which correlation that "
          "is of.",
          figure("background_p"))};
}

}  // namespace foveola::analysis
