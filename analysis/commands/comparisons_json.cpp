#include "analysis/commands/comparisons_json.h"

#include <nlohmann/json.hpp>

namespace foveola::analysis {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson optional_json(const std::optional<double>& value) {
  return value ? OrderedJson(*value) : OrderedJson(nullptr);
}

OrderedJson ratio_json(const MethodComparison& row) {
  if (!row.ratio) {
    return nullptr;
  }
  const RatioTest& test = *row.ratio;
  OrderedJson result = {{"ratio", test.ratio},
                        {"ci95", {test.interval.low, test.interval.high}},
                        {"bca95", nullptr},
                        {"t", test.logs.t},
                        {"df", test.logs.degrees_of_freedom},
                        {"p", test.logs.p},
                        {"d_z", test.logs.d_z}};
  if (row.ratio_bca) {
    result["bca95"] = {row.ratio_bca->low, row.ratio_bca->high};
  }
  return result;
}

OrderedJson points_json(const MethodComparison& row) {
  if (!row.points) {
    return nullptr;
  }
  const TTest& test = *row.points;
  return {{"difference", test.mean},
          {"ci95", {test.interval.low, test.interval.high}},
          {"t", test.t},
          {"df", test.degrees_of_freedom},
          {"p", test.p},
          {"d_z", test.d_z}};
}

OrderedJson ranks_json(const MethodComparison& row) {
  if (!row.ranks) {
    return nullptr;
  }
  const SignedRankTest& test = *row.ranks;
  return {{"n", test.n},
          {"zeros", test.zeros},
          {"w_plus", test.w_plus},
          {"w_minus", test.w_minus},
          {"p", test.p},
          {"exact", test.exact},
          {"rank_biserial", test.rank_biserial}};
}

}  // namespace

OrderedJson comparisons_json(const Comparisons& comparisons, const std::string& kind) {
  OrderedJson rows = OrderedJson::array();
  for (const MethodComparison& row : comparisons.methods) {
    rows.push_back(
        {{"measure", row.measure},
         {"method", row.method},
         {"reference", row.reference},
         {"status", row.primary ? "primary" : "exploratory"},
         {"n", row.n},
         {"times", ratio_json(row)},
         {"ratings", points_json(row)},
         {"wilcoxon", ranks_json(row)},
         {"p_holm", optional_json(row.p_holm)},
         {"p_equivalence", row.equivalent ? OrderedJson(row.equivalent->p) : OrderedJson(nullptr)},
         {"participant_kind", kind}});
  }
  return rows;
}

OrderedJson omnibus_json(const Comparisons& comparisons, const std::string& kind) {
  OrderedJson rows = OrderedJson::array();
  for (const OmnibusTest& row : comparisons.omnibus) {
    OrderedJson entry = {{"measure", row.measure},
                         {"left_out", row.left_out},
                         {"anova", nullptr},
                         {"friedman", nullptr},
                         {"participant_kind", kind}};
    if (row.variance) {
      entry["anova"] = {{"f", row.variance->f},
                        {"df", row.variance->degrees_of_freedom},
                        {"residual_df", row.variance->residual_degrees_of_freedom},
                        {"epsilon", row.variance->greenhouse_geisser},
                        {"p", row.variance->p_greenhouse_geisser}};
    }
    if (row.ranks) {
      entry["friedman"] = {{"chi_squared", row.ranks->chi_squared},
                           {"df", row.ranks->degrees_of_freedom},
                           {"p", row.ranks->p},
                           {"kendalls_w", row.ranks->kendalls_w}};
    }
    rows.push_back(std::move(entry));
  }
  return rows;
}

}  // namespace foveola::analysis
