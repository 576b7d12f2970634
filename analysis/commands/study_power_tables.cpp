#include "analysis/commands/study_power_tables.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "analysis/dataset/primary_analysis.h"
#include "renderer/base/transformed.h"

namespace foveola::analysis {
namespace {

std::string name_of(const study::PlannedComparison& planned) {
  return fmt::format("{}, {}/{}", planned.measure, planned.method, planned.baseline);
}

/// Returns "10 s with od; vp 50 %, fv 25 % of that".
std::string times_in_words(const ExpectedStudy& expected, std::size_t mark) {
  const ExpectedTimes& times = expected.times[mark];
  const std::vector<std::string>& methods = expected.protocol.methods;
  std::vector<std::string> others;
  for (std::size_t method = 1; method < methods.size(); ++method) {
    others.push_back(fmt::format("{} {:.3g} %", methods[method], 100.0 * times.ratios[method]));
  }
  return fmt::format("{:.3g} s with {}; {} of that", times.baseline_s, methods.front(),
                     fmt::join(others, ", "));
}

std::string shifts_in_words(const ExpectedStudy& expected, std::size_t rating) {
  std::vector<std::string> others;
  for (std::size_t method = 1; method < expected.protocol.methods.size(); ++method) {
    others.push_back(fmt::format("{} {:+.3g}", expected.protocol.methods[method],
                                 expected.shifts[rating][method]));
  }
  return fmt::format("{} points", fmt::join(others, ", "));
}

std::string spread_in_words(const ExpectedSpread& spread) {
  return fmt::format(
      "participants' own ratios vary by a factor of {:.3g}, scenes' by {:.3g}, single times by "
      "{:.3g}",
      std::exp(spread.participants_gain), std::exp(spread.scenes_gain), std::exp(spread.trials));
}

/// Describes how the marks of a trial depend on each other.
std::string dependence_in_words(const ExpectedStudy& expected) {
  std::vector<std::string> pairs;
  const auto& marks = expected.protocol.marks;
  for (std::size_t mark = 1; mark < marks.size(); ++mark) {
    pairs.push_back(fmt::format("{} with {} by {:.2f}", marks[mark].id, marks[mark - 1].id,
                                correlation_with_mark_before(expected, mark, 0)));
  }
  return fmt::format(
      "the log of a mark's time over the one before varies by {:.3g} of its mean "
      "(--mark-variation), "
      "so that single times with {} correlate: {}; ratings depend on no time",
      expected.later_marks_variation, expected.protocol.methods.front(), fmt::join(pairs, ", "));
}

bool has_planned_rating(const ExpectedStudy& expected) {
  const auto& planned = expected.protocol.analysis.primary;
  return std::ranges::any_of(planned, [&](const study::PlannedComparison& row) {
    const auto& marks = expected.protocol.marks;
    return std::ranges::none_of(
        marks, [&](const study::MarkEntry& mark) { return mark.id == row.measure; });
  });
}

std::string ratings_spread_in_words(const ExpectedSpread& spread) {
  return fmt::format(
      "participants' own differences by {:.2g} of the scale, scenes' by {:.2g}, single answers by "
      "{:.2g}",
      spread.participants_gain, spread.scenes_gain, spread.trials);
}

std::string line(const std::string& name, const std::string& text) {
  return fmt::format("  {:<14}{}\n", name, text);
}

std::string share_text(std::size_t hits, const StudyPower& power) {
  const PowerShare share = share_of(hits, power);
  return fmt::format("{:5.1f} [{:4.1f}, {:5.1f}]", 100.0 * share.value, 100.0 * share.interval.low,
                     100.0 * share.interval.high);
}

/// Leaves out sizes that were tried only to find the minimum number of participants.
bool is_shown(const StudyPower& point, const StudyPowerReport& report) {
  constexpr std::size_t step = 4;
  const study::AnalysisPlan& plan = report.expected.protocol.analysis;
  const auto is_fewest = [&](std::optional<std::size_t> comparison) {
    return fewest_participants(report.curve, comparison, report.target) == point.participants;
  };
  bool is_any_fewest = is_fewest(std::nullopt);
  for (std::size_t i = 0; i < plan.primary.size(); ++i) {
    is_any_fewest = is_any_fewest || is_fewest(i);
  }
  return is_any_fewest || point.participants % step == 0 || report.curve.size() == 1 ||
         (plan.participants && static_cast<std::size_t>(*plan.participants) == point.participants);
}

std::string curve_text(const StudyPowerReport& report) {
  const auto& planned = report.expected.protocol.analysis.primary;
  constexpr std::size_t narrowest = 19;
  std::string text = "participants  analysed";
  std::vector<std::size_t> widths;
  std::vector<std::string> names = transformed(
      planned, [&](const study::PlannedComparison& comparison) { return name_of(comparison); });
  names.emplace_back("all together");
  for (const std::string& name : names) {
    widths.push_back(std::max(narrowest, name.size()));
    text += fmt::format("  {:>{}}", name, widths.back());
  }
  text += "\n";
  for (const StudyPower& point : report.curve) {
    if (!is_shown(point, report)) {
      continue;
    }
    text += fmt::format("{:>12}  {:>8.1f}", point.participants, point.analysed);
    for (std::size_t i = 0; i < planned.size(); ++i) {
      text += fmt::format("  {:>{}}", share_text(hits_of(point, i), point), widths[i]);
    }
    text += fmt::format("  {:>{}}\n", share_text(point.all_significant, point), widths.back());
  }
  return text;
}

std::string min_text(const StudyPowerReport& report, std::optional<std::size_t> comparison,
                     const std::string& name) {
  const auto fewest = fewest_participants(report.curve, comparison, report.target);
  const std::size_t most = report.curve.back().participants;
  return line("", fewest ? fmt::format("{}: {}", name, *fewest)
                         : fmt::format("{}: more than {}, or out of reach", name, most));
}

std::string all_fewest_text(const StudyPowerReport& report) {
  const auto& planned = report.expected.protocol.analysis.primary;
  std::string text =
      fmt::format("Minimum number of participants for a power of {:g} %\n", 100.0 * report.target);
  for (std::size_t i = 0; i < planned.size(); ++i) {
    text += min_text(report, i, name_of(planned[i]));
  }
  return text + min_text(report, std::nullopt, "all together");
}

/// Returns the result of the maximum number of participants.
const StudyPower& largest(const StudyPowerReport& report) { return report.curve.back(); }

std::string censoring_text(const StudyPowerReport& report) {
  std::vector<std::string> parts;
  const study::Protocol& protocol = report.expected.protocol;
  for (std::size_t mark = 0; mark < protocol.marks.size(); ++mark) {
    for (std::size_t method = 0; method < protocol.methods.size(); ++method) {
      const double percent = 100.0 * largest(report).censored[mark][method];
      if (percent >= 0.05) {
        parts.push_back(fmt::format("{}, {} {:.1f} %", protocol.marks[mark].id,
                                    protocol.methods[method], percent));
      }
    }
  }
  return parts.empty() ? "" : line("timed out", fmt::format("{}", fmt::join(parts, "; ")));
}

/// Describes the analyses of the P-values.
std::string analyses_text(const StudyPowerReport& report) {
  std::string text;
  const auto& planned = report.expected.protocol.analysis.primary;
  for (std::size_t i = 0; i < planned.size(); ++i) {
    std::vector<std::string> kinds;
    const ComparisonPower& power = largest(report).comparisons[i];
    for (const auto& [kind, count] : power.analyses) {
      kinds.push_back(fmt::format("{} {:.1f} %", name_of(kind),
                                  100.0 * share_of(count, largest(report)).value));
    }
    const std::string stand_in =
        power.stand_ins == 0
            ? ""
            : fmt::format(" (in {:.1f} % in place of the planned one, which R fits: --r)",
                          100.0 * share_of(power.stand_ins, largest(report)).value);
    text += line(i == 0 ? "analyses" : "",
                 fmt::format("{}: {}{}", name_of(planned[i]), fmt::join(kinds, ", "), stand_in));
  }
  return text;
}

/// Notes that more participants hardly help, if so.
std::string scenes_text(const StudyPowerReport& report) {
  const study::AnalysisPlan& plan = report.expected.protocol.analysis;
  if (plan.scenes == study::SceneEffects::fixed ||
      fewest_participants(report.curve, std::nullopt, report.target)) {
    return "";
  }
  return "With random scenes their number limits the power, whatever the number of participants: "
         "try more with "
         "--scenes.\n";
}

nlohmann::ordered_json share_json(std::size_t hits, const StudyPower& power) {
  const PowerShare share = share_of(hits, power);
  return {{"power", share.value}, {"ci95", {share.interval.low, share.interval.high}}};
}

nlohmann::ordered_json point_json(const StudyPower& point, const study::Protocol& protocol) {
  nlohmann::ordered_json comparisons = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < point.comparisons.size(); ++i) {
    const study::PlannedComparison& planned = protocol.analysis.primary[i];
    nlohmann::ordered_json row = {
        {"measure", planned.measure}, {"method", planned.method}, {"reference", planned.baseline}};
    row.update(share_json(hits_of(point, i), point));
    for (const auto& [kind, count] : point.comparisons[i].analyses) {
      row["analyses"][name_of(kind)] = count;
    }
    row["stand_ins"] = point.comparisons[i].stand_ins;
    comparisons.push_back(std::move(row));
  }
  nlohmann::ordered_json censored = nlohmann::ordered_json::object();
  for (std::size_t mark = 0; mark < protocol.marks.size(); ++mark) {
    for (std::size_t method = 0; method < protocol.methods.size(); ++method) {
      censored[protocol.marks[mark].id][protocol.methods[method]] = point.censored[mark][method];
    }
  }
  return {{"participants", point.participants},
          {"mean_analysed", point.analysed},
          {"comparisons", comparisons},
          {"all_together", share_json(point.all_significant, point)},
          {"censored_part", censored}};
}

nlohmann::ordered_json spread_json(const ExpectedSpread& spread) {
  return {{"participants", spread.participants},
          {"scenes", spread.scenes},
          {"participants_gain", spread.participants_gain},
          {"scenes_gain", spread.scenes_gain},
          {"trials", spread.trials}};
}

nlohmann::ordered_json expected_json(const ExpectedStudy& expected) {
  const study::Protocol& protocol = expected.protocol;
  nlohmann::ordered_json marks = nlohmann::ordered_json::object();
  for (std::size_t mark = 0; mark < protocol.marks.size(); ++mark) {
    nlohmann::ordered_json& row = marks[protocol.marks[mark].id];
    row["baseline_s"] = expected.times[mark].baseline_s;
    for (std::size_t method = 0; method < protocol.methods.size(); ++method) {
      row["ratios"][protocol.methods[method]] = expected.times[mark].ratios[method];
    }
  }
  nlohmann::ordered_json ratings = nlohmann::ordered_json::object();
  for (std::size_t rating = 0; rating < protocol.ratings.size(); ++rating) {
    for (std::size_t method = 0; method < protocol.methods.size(); ++method) {
      ratings[protocol.ratings[rating].id]["shift_points"][protocol.methods[method]] =
          expected.shifts[rating][method];
    }
  }
  return {{"scenes", protocol.scenes.size()},
          {"marks", marks},
          {"ratings", ratings},
          {"log_time_sd", spread_json(expected.times_spread)},
          {"later_marks_variation", expected.later_marks_variation},
          {"rating_sd_part_of_scale", spread_json(expected.ratings_spread)},
          {"withdrawals", expected.withdrawals}};
}

}  // namespace

std::string expectations_text(const StudyPowerReport& report) {
  const ExpectedStudy& expected = report.expected;
  const study::Protocol& protocol = expected.protocol;
  std::string text =
      fmt::format("Power of {} by simulation, {} studies per number of participants\n",
                  protocol.name, report.studies);
  text += line("design", fmt::format("{} scenes ({}), {} methods", protocol.scenes.size(),
                                     name_of(protocol.analysis.scenes), protocol.methods.size()));
  text += line("family", fmt::format("{} planned comparisons at {:g} together (Holm)",
                                     protocol.analysis.primary.size(), protocol.analysis.alpha));
  for (std::size_t mark = 0; mark < protocol.marks.size(); ++mark) {
    text += line(protocol.marks[mark].id, times_in_words(expected, mark));
  }
  text += line("differences", spread_in_words(expected.times_spread));
  if (protocol.marks.size() > 1) {
    text += line("dependence", dependence_in_words(expected));
  }
  if (has_planned_rating(expected)) {
    for (std::size_t rating = 0; rating < protocol.ratings.size(); ++rating) {
      text += line(protocol.ratings[rating].id, shifts_in_words(expected, rating));
    }
    text += line("of answers", ratings_spread_in_words(expected.ratings_spread));
  }
  text += line("withdrawals", fmt::format("{:.3g} %", 100.0 * expected.withdrawals));
  return text + (report.from_pilot
                     ? "Unstated expectations are estimates from the pilot, except effects.\n"
                     : "");
}

std::string study_power_text(const StudyPowerReport& report) {
  const std::string text =
      "\nPower in per cent, with the 95 % confidence interval of the simulation\n" +
      curve_text(report) + censoring_text(report) + analyses_text(report);
  return report.curve.size() > 1 ? text + all_fewest_text(report) + scenes_text(report) : text;
}

std::string study_power_json(const StudyPowerReport& report) {
  const study::Protocol& protocol = report.expected.protocol;
  const auto number_or_null = [](std::optional<std::size_t> number) {
    return number ? nlohmann::ordered_json(*number) : nlohmann::ordered_json(nullptr);
  };
  const nlohmann::ordered_json curve(transformed(
      report.curve, [&](const StudyPower& point) { return point_json(point, protocol); }));
  nlohmann::ordered_json fewest = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < protocol.analysis.primary.size(); ++i) {
    fewest.push_back(number_or_null(fewest_participants(report.curve, i, report.target)));
  }
  const nlohmann::ordered_json json = {
      {"protocol", protocol.name},
      {"participant_kind", "simulated"},
      {"from_pilot", report.from_pilot},
      {"expected", expected_json(report.expected)},
      {"alpha", protocol.analysis.alpha},
      {"target", report.target},
      {"simulated_studies", report.studies},
      {"seed", report.seed},
      {"fewest_participants", fewest},
      {"fewest_participants_all",
       number_or_null(fewest_participants(report.curve, std::nullopt, report.target))},
      {"curve", curve}};
  return json.dump(2);
}

}  // namespace foveola::analysis
