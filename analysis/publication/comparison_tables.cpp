#include "analysis/publication/comparison_tables.h"

#include <cmath>
#include <vector>

#include "renderer/base/csv.h"

namespace foveola::analysis {
namespace {

/// Column by column: its name and its text in this row.
class RowBuilder {
 public:
  void add(const std::string& column, std::string text) {
    columns_.push_back(column);
    fields_.push_back(std::move(text));
  }
  void add(const std::string& column, std::optional<double> value) {
    add(column, csv_number(value));
  }
  void add(const std::string& column, std::size_t count) { add(column, std::to_string(count)); }

  const CsvRow& columns() const { return columns_; }
  const CsvRow& fields() const { return fields_; }

 private:
  CsvRow columns_;
  CsvRow fields_;
};

/// A number of a result that may not exist.
template <typename Result, typename Value>
std::optional<double> number_in(const std::optional<Result>& result, const Value& value) {
  return result ? std::optional<double>(value(*result)) : std::nullopt;
}

std::string csv_of(const std::vector<RowBuilder>& built) {
  std::vector<CsvRow> rows;
  for (const RowBuilder& row : built) {
    if (rows.empty()) {
      rows.push_back(row.columns());
    }
    rows.push_back(row.fields());
  }
  return format_csv(rows);
}

void add_ratio(const MethodComparison& row, RowBuilder& out) {
  const auto of = [&](const auto& value) { return number_in(row.ratio, value); };
  out.add("ratio_percent", of([](const RatioTest& test) { return 100.0 * test.ratio; }));
  out.add("ci95_low_percent", of([](const RatioTest& test) { return 100.0 * test.interval.low; }));
  out.add("ci95_high_percent",
          of([](const RatioTest& test) { return 100.0 * test.interval.high; }));
  out.add("bca95_low_percent",
          number_in(row.ratio_bca, [](const Interval& bca) { return 100.0 * bca.low; }));
  out.add("bca95_high_percent",
          number_in(row.ratio_bca, [](const Interval& bca) { return 100.0 * bca.high; }));
}

void add_points(const MethodComparison& row, RowBuilder& out) {
  const auto of = [&](const auto& value) { return number_in(row.points, value); };
  out.add("difference_points", of([](const TTest& test) { return test.mean; }));
  out.add("ci95_low_points", of([](const TTest& test) { return test.interval.low; }));
  out.add("ci95_high_points", of([](const TTest& test) { return test.interval.high; }));
}

void add_t(const MethodComparison& row, RowBuilder& out) {
  const std::optional<TTest> test = row.ratio ? std::optional(row.ratio->logs) : row.points;
  const auto of = [&](const auto& value) { return number_in(test, value); };
  out.add("t", of([](const TTest& t) { return t.t; }));
  out.add("df", of([](const TTest& t) { return t.degrees_of_freedom; }));
  out.add("p_t", of([](const TTest& t) { return t.p; }));
  out.add("d_z", of([](const TTest& t) { return t.d_z; }));
}

void add_ranks(const MethodComparison& row, RowBuilder& out) {
  const auto of = [&](const auto& value) { return number_in(row.ranks, value); };
  out.add("w_plus", of([](const SignedRankTest& test) { return test.w_plus; }));
  out.add("w_minus", of([](const SignedRankTest& test) { return test.w_minus; }));
  out.add("zeros", of([](const SignedRankTest& test) { return static_cast<double>(test.zeros); }));
  out.add("p_wilcoxon", of([](const SignedRankTest& test) { return test.p; }));
  out.add("wilcoxon_exact", of([](const SignedRankTest& test) { return test.exact ? 1.0 : 0.0; }));
  out.add("rank_biserial", of([](const SignedRankTest& test) { return test.rank_biserial; }));
}

/// Adds columns of ratios in per cent and of differences in points; one of the two are empty.
void add_pseudo_median(const MethodComparison& row, RowBuilder& out) {
  const auto add = [&](const std::string& unit, bool is_of_it, double scale) {
    const auto scaled = [&](double tested) { return scale * row.in_unit(tested); };
    const auto of = [&](const auto& value) {
      return is_of_it ? number_in(row.pseudo_median, value) : std::nullopt;
    };
    const auto bound = [&](const auto& end) {
      return is_of_it && row.pseudo_median && row.pseudo_median->interval
                 ? std::optional<double>(scaled(end(*row.pseudo_median->interval)))
                 : std::nullopt;
    };
    out.add("pseudo_median_" + unit,
            of([&](const PseudoMedian& found) { return scaled(found.value); }));
    out.add("pseudo_median_low_" + unit, bound([](const Interval& ends) { return ends.low; }));
    out.add("pseudo_median_high_" + unit, bound([](const Interval& ends) { return ends.high; }));
  };
  add("ratio_percent", !row.is_of_ratings(), 100.0);
  add("points", row.is_of_ratings(), 1.0);
}

/// Adds the equivalence test, whose interval is in the margin's unit: a factor of times, or points.
void add_equivalence(const MethodComparison& row, RowBuilder& out) {
  const auto of = [&](const auto& value) { return number_in(row.equivalent, value); };
  out.add("equivalence_margin", row.margin);
  out.add("equivalence_interval_low",
          of([&](const EquivalenceTest& test) { return row.in_unit(test.interval.low); }));
  out.add("equivalence_interval_high",
          of([&](const EquivalenceTest& test) { return row.in_unit(test.interval.high); }));
  out.add("p_above_low_margin", of([](const EquivalenceTest& test) { return test.p_above_low; }));
  out.add("p_below_high_margin", of([](const EquivalenceTest& test) { return test.p_below_high; }));
  out.add("p_equivalence", of([](const EquivalenceTest& test) { return test.p; }));
}

}  // namespace

std::string comparisons_csv(const Comparisons& comparisons, const std::string& kind) {
  std::vector<RowBuilder> rows;
  for (const MethodComparison& row : comparisons.methods) {
    RowBuilder& out = rows.emplace_back();
    out.add("measure", row.measure);
    out.add("method", row.method);
    out.add("reference", row.reference);
    out.add("status", row.primary ? "primary" : "exploratory");
    out.add("n", row.n);
    add_ratio(row, out);
    add_points(row, out);
    add_t(row, out);
    add_ranks(row, out);
    add_pseudo_median(row, out);
    out.add("p_holm", row.p_holm);
    add_equivalence(row, out);
    out.add("participant_kind", kind);
  }
  return csv_of(rows);
}

std::string omnibus_csv(const Comparisons& comparisons, const std::string& kind) {
  std::vector<RowBuilder> rows;
  for (const OmnibusTest& row : comparisons.omnibus) {
    RowBuilder& out = rows.emplace_back();
    const auto variance = [&](const auto& value) { return number_in(row.variance, value); };
    const auto ranks = [&](const auto& value) { return number_in(row.ranks, value); };
    out.add("measure", row.measure);
    out.add("n", ranks([](const auto& test) { return static_cast<double>(test.participants); }));
    out.add("participants_left_out", row.left_out);
    out.add("f", variance([](const auto& test) { return test.f; }));
    out.add("df", variance([](const auto& test) { return test.degrees_of_freedom; }));
    out.add("residual_df",
            variance([](const auto& test) { return test.residual_degrees_of_freedom; }));
    out.add("p_sphericity", variance([](const auto& test) { return test.p; }));
    out.add("epsilon_greenhouse_geisser",
            variance([](const auto& test) { return test.greenhouse_geisser; }));
    out.add("p_greenhouse_geisser",
            variance([](const auto& test) { return test.p_greenhouse_geisser; }));
    out.add("epsilon_huynh_feldt", variance([](const auto& test) { return test.huynh_feldt; }));
    out.add("p_huynh_feldt", variance([](const auto& test) { return test.p_huynh_feldt; }));
    out.add("partial_eta_squared",
            variance([](const auto& test) { return test.partial_eta_squared; }));
    out.add("friedman_chi_squared", ranks([](const auto& test) { return test.chi_squared; }));
    out.add("friedman_df", ranks([](const auto& test) { return test.degrees_of_freedom; }));
    out.add("p_friedman", ranks([](const auto& test) { return test.p; }));
    out.add("kendalls_w", ranks([](const auto& test) { return test.kendalls_w; }));
    out.add("participant_kind", kind);
  }
  return csv_of(rows);
}

std::string order_csv(const Comparisons& comparisons, const std::string& kind) {
  std::vector<RowBuilder> rows;
  for (const OrderTest& row : comparisons.order) {
    RowBuilder& out = rows.emplace_back();
    const auto of = [&](const auto& value) { return number_in(row.change_per_step, value); };
    const auto percent = [](double change) { return 100.0 * std::expm1(change); };
    out.add("mark", std::string(name_of(row.mark)));
    out.add("per", row.of);
    out.add("n", of([](const TTest& test) { return static_cast<double>(test.n); }));
    out.add("change_percent", of([&](const TTest& test) { return percent(test.mean); }));
    out.add("ci95_low_percent", of([&](const TTest& test) { return percent(test.interval.low); }));
    out.add("ci95_high_percent",
            of([&](const TTest& test) { return percent(test.interval.high); }));
    out.add("t", of([](const TTest& test) { return test.t; }));
    out.add("df", of([](const TTest& test) { return test.degrees_of_freedom; }));
    out.add("p", of([](const TTest& test) { return test.p; }));
    out.add("d_z", of([](const TTest& test) { return test.d_z; }));
    out.add("participant_kind", kind);
  }
  return csv_of(rows);
}

}  // namespace foveola::analysis
