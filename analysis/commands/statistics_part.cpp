#include "analysis/commands/statistics_part.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace foveola::analysis {
namespace {

constexpr std::uint64_t most_studies = 1'000'000;
/// Doubles that do not overlap, of all that there are.
constexpr std::size_t most_summands = 64;
/// The sum of logarithms of ratios over all studies is far below.
constexpr double largest_sum = 1e12;

int number_in(const nlohmann::json& json, const char* name) {
  return static_cast<int>(whole_number(json.at(name), most_studies));
}

std::uint64_t seed_in(const nlohmann::json& json) {
  return whole_number(json.at("seed"), std::numeric_limits<std::uint64_t>::max());
}

StudyCount count_in(const nlohmann::json& json) {
  StudyCount count;
  count.studies = whole_number(json.at("studies"), most_studies);
  count.hits = whole_number(json.at("hits"), count.studies);
  const nlohmann::json& summands = json.at("estimates");
  if (!summands.is_array() || summands.size() > most_summands) {
    throw std::invalid_argument("no sum");
  }
  for (const nlohmann::json& summand : summands) {
    const auto value = summand.get<double>();
    if (!(std::abs(value) <= largest_sum)) {
      throw std::out_of_range("no such sum");
    }
    count.estimates.add(value);
  }
  return count;
}

StudyCounts counts_in(const nlohmann::json& json, std::size_t figures) {
  if (!json.is_array() || json.size() != figures) {
    throw std::invalid_argument("of other figures");
  }
  StudyCounts counts;
  for (const nlohmann::json& count : json) {
    counts.push_back(count_in(count));
  }
  return counts;
}

}  // namespace

nlohmann::json settings_json(const CoverageSettings& settings) {
  return {{"by_r", false},
          {"studies", settings.studies},
          {"participants", settings.participants},
          {"seed", settings.seed},
          {"resamples", settings.resamples}};
}

nlohmann::json settings_json(const ModelBench& bench) {
  return {{"by_r", true},
          {"studies", bench.settings.studies},
          {"seed", bench.settings.seed},
          {"only", bench.only},
          {"fitted_by", bench.fitted_by}};
}

bool is_of_models(const BenchPart& part) {
  return read_part(
      part, [](const BenchPart& read) { return read.settings.at("by_r").template get<bool>(); });
}

CoverageSettings coverage_settings_of(const BenchPart& part) {
  return read_part(part, [](const BenchPart& read) {
    const nlohmann::json& json = read.settings;
    return CoverageSettings{.studies = number_in(json, "studies"),
                            .participants = number_in(json, "participants"),
                            .seed = seed_in(json),
                            .resamples = number_in(json, "resamples")};
  });
}

ModelBench model_bench_of(const BenchPart& part) {
  return read_part(part, [](const BenchPart& read) {
    const nlohmann::json& json = read.settings;
    ModelBench bench{.settings = {.seed = seed_in(json)},
                     .only = json.at("only").get<std::string>(),
                     .fitted_by = json.at("fitted_by").get<std::string>()};
    bench.settings.studies = whole_number(json.at("studies"), most_studies);
    return bench;
  });
}

nlohmann::json counts_json(const StudyCounts& counts) {
  nlohmann::json json = nlohmann::json::array();
  for (const StudyCount& count : counts) {
    json.push_back(
        {{"studies", count.studies}, {"hits", count.hits}, {"estimates", count.estimates.parts()}});
  }
  return json;
}

StudyCounts merged_counts(const std::vector<BenchPart>& parts, std::size_t figures) {
  StudyCounts sums(figures);
  for (const BenchPart& part : parts) {
    add(read_part(part, [&](const BenchPart& read) { return counts_in(read.results, figures); }),
        sums);
  }
  return sums;
}

}  // namespace foveola::analysis
