#include "analysis/commands/coverage_report.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/print.h"
#include "renderer/commands/bench_facts.h"

namespace foveola::analysis {

void print_figure(const CoverageFigure& figure, std::size_t width) {
  const std::string required =
      figure.required
          ? fmt::format("required: {} to {} %", figure.required->low, figure.required->high)
          : "reported only";
  const std::string mean =
      figure.mean_ratio ? fmt::format("; mean {:.1f} %", 100.0 * *figure.mean_ratio) : "";
  print_text("{:<{}}  {:<27} {:6.2f} % [{:.2f}, {:.2f}] of {}; {}{}\n", figure.name, width,
             figure.claim, figure.percent, figure.interval.low, figure.interval.high,
             figure.studies, required, mean);
}

void print_table(const CoverageSettings& settings, const std::vector<CoverageFigure>& figures) {
  print_text(
      "Studies of {} simulated participants whose times are drawn from a model; in brackets, "
      "95 % intervals of the shares\n",
      settings.participants);
  std::size_t width = 0;
  for (const CoverageFigure& figure : figures) {
    width = std::max(width, figure.name.size());
  }
  for (const CoverageFigure& figure : figures) {
    print_figure(figure, width);
  }
}

void print_json(const nlohmann::ordered_json& about, const std::vector<CoverageFigure>& figures) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const CoverageFigure& figure : figures) {
    nlohmann::ordered_json row = {{"name", figure.name},          {"claim", figure.claim},
                                  {"percent", figure.percent},    {"low", figure.interval.low},
                                  {"high", figure.interval.high}, {"studies", figure.studies},
                                  {"hits", figure.hits},          {"asked", nullptr},
                                  {"met", figure.is_met()}};
    if (figure.mean_ratio) {
      row["mean_ratio"] = *figure.mean_ratio;
    }
    if (figure.required) {
      row["asked"] = {figure.required->low, figure.required->high};
    }
    rows.push_back(std::move(row));
  }
  nlohmann::ordered_json json = bench_facts();
  json.update(about);
  json["participant_kind"] = "simulated";
  json["figures"] = std::move(rows);
  print_text("{}\n", json.dump(2));
}

void require_all(const std::vector<CoverageFigure>& figures) {
  for (const CoverageFigure& figure : figures) {
    if (!figure.is_met()) {
      throw Error(
          figure.name,
          fmt::format("{} in {:.2f} % of studies, not in {} to {} %", figure.claim, figure.percent,
                      figure.required->low, figure.required->high),
          "with fewer than 4000 studies this may be chance; otherwise the analysis is wrong");
    }
  }
}

}  // namespace foveola::analysis
