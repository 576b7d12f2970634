#include "analysis/commands/comparisons_json.h"

#include <cmath>

#include <nlohmann/json.hpp>

namespace foveola::analysis {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson optional_json(const std::optional<double>& value) {
  return value ? OrderedJson(*value) : OrderedJson(nullptr);
}

OrderedJson interval_json(const std::optional<Interval>& interval) {
  return interval ? OrderedJson::array({interval->low, interval->high}) : OrderedJson(nullptr);
}

OrderedJson ratio_json(const MethodComparison& row) {
  if (!row.ratio) {
    return nullptr;
  }
  const RatioTest& test = *row.ratio;
  return {{"ratio", test.ratio},
          {"ci95", {test.interval.low, test.interval.high}},
          {"bca95", interval_json(row.ratio_bca)},
          {"t", test.logs.t},
          {"df", test.logs.degrees_of_freedom},
          {"p", test.logs.p},
          {"d_z", test.logs.d_z}};
}

OrderedJson pseudo_median_json(const MethodComparison& row) {
  if (!row.pseudo_median) {
    return nullptr;
  }
  const std::optional<Interval>& interval = row.pseudo_median->interval;
  return {{"value", row.in_unit(row.pseudo_median->value)},
          {"ci95", interval ? interval_json(row.in_unit(*interval)) : OrderedJson(nullptr)}};
}

OrderedJson equivalence_json(const MethodComparison& row) {
  if (!row.equivalent) {
    return nullptr;
  }
  const EquivalenceTest& test = *row.equivalent;
  return {{"margin", optional_json(row.margin)},
          {"interval", interval_json(row.in_unit(test.interval))},
          {"p_above_low", test.p_above_low},
          {"p_below_high", test.p_below_high},
          {"p", test.p}};
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
    rows.push_back({{"measure", row.measure},
                    {"method", row.method},
                    {"reference", row.reference},
                    {"status", row.primary ? "primary" : "exploratory"},
                    {"n", row.n},
                    {"times", ratio_json(row)},
                    {"ratings", points_json(row)},
                    {"wilcoxon", ranks_json(row)},
                    {"pseudo_median", pseudo_median_json(row)},
                    {"p_holm", optional_json(row.p_holm)},
                    {"equivalence", equivalence_json(row)},
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
      entry["anova"] = {{"n", row.variance->participants},
                        {"f", row.variance->f},
                        {"df", row.variance->degrees_of_freedom},
                        {"residual_df", row.variance->residual_degrees_of_freedom},
                        {"p_sphericity", row.variance->p},
                        {"epsilon_greenhouse_geisser", row.variance->greenhouse_geisser},
                        {"p_greenhouse_geisser", row.variance->p_greenhouse_geisser},
                        {"epsilon_huynh_feldt", row.variance->huynh_feldt},
                        {"p_huynh_feldt", row.variance->p_huynh_feldt},
                        {"partial_eta_squared", row.variance->partial_eta_squared}};
    }
    if (row.ranks) {
      entry["friedman"] = {{"n", row.ranks->participants},
                           {"chi_squared", row.ranks->chi_squared},
                           {"df", row.ranks->degrees_of_freedom},
                           {"p", row.ranks->p},
                           {"kendalls_w", row.ranks->kendalls_w}};
    }
    rows.push_back(std::move(entry));
  }
  return rows;
}

OrderedJson order_json(const Comparisons& comparisons, const std::string& kind) {
  OrderedJson rows = OrderedJson::array();
  for (const OrderTest& row : comparisons.order) {
    OrderedJson entry = {{"mark", name_of(row.mark)},
                         {"per", row.of},
                         {"change_percent", nullptr},
                         {"participant_kind", kind}};
    if (row.change_per_step) {
      const TTest& test = *row.change_per_step;
      const auto percent = [](double change) { return 100.0 * std::expm1(change); };
      entry["change_percent"] = {
          {"n", test.n},
          {"value", percent(test.mean)},
          {"ci95", {percent(test.interval.low), percent(test.interval.high)}},
          {"t", test.t},
          {"df", test.degrees_of_freedom},
          {"p", test.p},
          {"d_z", test.d_z}};
    }
    rows.push_back(std::move(entry));
  }
  return rows;
}

}  // namespace foveola::analysis
