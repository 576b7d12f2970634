#include "analysis/commands/power_command.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analysis/commands/study_power_tables.h"
#include "analysis/monte_carlo/model_coverage.h"
#include "analysis/r_models/fit_models.h"
#include "analysis/statistics/power.h"
#include "renderer/base/error.h"
#include "renderer/base/text/print.h"
#include "renderer/base/work/parallel.h"
#include "renderer/base/work/work_scope.h"
#include "study/record/read/study_records.h"

namespace foveola::analysis {
namespace {

ExpectedEffect effect_of(const PowerSettings& settings) {
  if (!(settings.ratio_percent > 0.0) || settings.ratio_percent == 100.0) {
    throw Error("--ratio", fmt::format("{:g} % is not an effect to detect", settings.ratio_percent),
                "give the expected time in per cent of the baseline's, above 0 and not 100");
  }
  if (!(settings.spread > 1.0)) {
    throw Error("--spread", fmt::format("{:g} is not a factor above 1", settings.spread),
                "give the geometric standard deviation of participants' ratios, above 1");
  }
  return effect_of_ratio(settings.ratio_percent, settings.spread);
}

constexpr std::size_t default_studies = 2000;
constexpr std::size_t default_studies_by_r = 200;

/// Refuses options of a protocol's study for a single comparison.
void refuse_expectations(const PowerArguments& arguments) {
  const Expectations& expectations = arguments.expectations;
  const std::pair<const char*, bool> given[] = {
      {"--effect", !arguments.effects.empty()},
      {"--seconds", expectations.baseline_s.has_value()},
      {"--scene-spread", expectations.scenes_factor.has_value()},
      {"--trial-spread", expectations.trials_factor.has_value()},
      {"--mark-variation", expectations.mark_variation.has_value()},
      {"--withdrawals", expectations.withdrawals.has_value()},
      {"--scenes", expectations.scenes.has_value()}};
  for (const auto& [option, is_given] : given) {
    if (is_given) {
      throw UsageError(option, "is an option of a protocol's study",
                       "add --protocol NAME, or a pilot's file");
    }
  }
}

void plan_one_comparison(const PowerArguments& arguments) {
  refuse_expectations(arguments);
  PowerSettings settings = arguments.one_comparison;
  settings.ratio_percent = arguments.expectations.ratio_percent;
  settings.spread = arguments.spread.value_or(settings.spread);
  settings.studies = arguments.studies.value_or(settings.studies);
  const PowerPlan plan = plan_power(settings);
  print_text("{}", arguments.json ? power_json(settings, plan) + "\n" : power_text(settings, plan));
}

std::optional<study::StudyRecords> pilot_of(const PowerArguments& arguments) {
  return arguments.pilot.empty() ? std::nullopt : std::optional(study::read_study(arguments.pilot));
}

StudyPowerReport report_of(const PowerArguments& arguments) {
  const std::optional<study::StudyRecords> pilot = pilot_of(arguments);
  const study::Protocol protocol =
      pilot ? pilot->protocol : study::load_protocol(study::find_protocol(arguments.protocol));
  Expectations expectations = arguments.expectations;
  expectations.participants_factor = arguments.spread;
  std::transform(arguments.effects.begin(), arguments.effects.end(),
                 std::back_inserter(expectations.measures), parse_expectation);
  return {
      .expected = expect(protocol, expectations, pilot ? &*pilot : nullptr),
      .target = arguments.one_comparison.power,
      .studies = arguments.studies.value_or(arguments.r ? default_studies_by_r : default_studies),
      .seed = arguments.one_comparison.seed,
      .from_pilot = pilot.has_value()};
}

/// Returns the single number of participants for R's models.
std::size_t participants_for_r(const PowerArguments& arguments, const StudyPowerReport& report) {
  const std::optional<int>& planned = report.expected.protocol.analysis.participants;
  if (!arguments.one_comparison.participants && !planned) {
    throw UsageError("--r", "fits models for one number of participants, since R is slow",
                     "add --participants");
  }
  return arguments.one_comparison.participants.value_or(
      static_cast<std::size_t>(planned.value_or(0)));
}

double seconds_by_r(const StudyPowerReport& report, std::size_t participants, std::size_t studies) {
  std::vector<study::StudyRecords> drawn;
  for (std::size_t i = 0; i < studies; ++i) {
    drawn.push_back(draw_study(report.expected, participants, i));
  }
  const auto start = std::chrono::steady_clock::now();
  const std::vector<FittedModels> models = fit_studies(drawn);
  for (const FittedModels& one : models) {
    if (const std::string why = missing_for(one); !why.empty()) {
      throw Error("--r", why, "install what is missing, or remove --r");
    }
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Estimates R's time from those of one study and of nine.
double expected_seconds(const StudyPowerReport& report, std::size_t participants) {
  const double of_one = seconds_by_r(report, participants, 1);
  const double each = std::max(0.0, (seconds_by_r(report, participants, 9) - of_one) / 8.0);
  const double starting = std::max(0.0, of_one - each);
  const auto studies = static_cast<double>(report.studies);
  const auto starts = std::ceil(studies / static_cast<double>(studies_drawn_together));
  return (studies * each + starts * starting) / Workers().threads();
}

std::vector<StudyPower> fit_by_r(const PowerArguments& arguments, const StudyPowerReport& report,
                                 PowerSimulation simulation, const std::stop_token& stop) {
  const std::size_t participants = participants_for_r(arguments, report);
  print_text(stderr, "R fits the models of {} studies of {} participants: about {}\n",
             report.studies, participants, human_duration(expected_seconds(report, participants)));
  simulation.fit_models = fit_studies;
  const auto power = simulate_study_power(report.expected, participants, simulation, stop);
  return power ? std::vector{*power} : std::vector<StudyPower>();
}

std::vector<StudyPower> simulate(const PowerArguments& arguments, const StudyPowerReport& report,
                                 const std::stop_token& stop) {
  const PowerSimulation simulation{.studies = report.studies, .seed = report.seed};
  if (arguments.r) {
    return fit_by_r(arguments, report, simulation, stop);
  }
  if (const auto& participants = arguments.one_comparison.participants) {
    const auto power = simulate_study_power(report.expected, *participants, simulation, stop);
    return power ? std::vector{*power} : std::vector<StudyPower>();
  }
  const std::optional<int>& planned = report.expected.protocol.analysis.participants;
  return power_curve(
      report.expected,
      {.power = report.target,
       .planned = planned ? std::optional<std::size_t>(*planned) : std::nullopt,
       .most = arguments.most_participants},
      simulation,
      [](std::size_t participants) { print_text(stderr, "{} participants\n", participants); },
      stop);
}

void plan_study(const PowerArguments& arguments, const std::stop_token& stop) {
  StudyPowerReport report = report_of(arguments);
  if (!arguments.json) {
    print_text("{}", expectations_text(report));
    std::fflush(stdout);
  }
  report.curve = simulate(arguments, report, stop);
  if (!report.curve.empty()) {
    print_text("{}", arguments.json ? study_power_json(report) + "\n" : study_power_text(report));
  }
}

}  // namespace

void add_power_options(CLI::App& command, PowerArguments& arguments) {
  PowerSettings& one = arguments.one_comparison;
  Expectations& expectations = arguments.expectations;
  command.add_flag(
      "--power", arguments.asked,
      "Plan a study instead of analysing one: the power by numbers of participants. "
      "With --protocol, or a pilot as STUDY, by simulation of the protocol, its "
      "design, time-outs and planned analysis; otherwise of one comparison of times by "
      "the paired t test");
  const ExpectedSpread usual = ExpectedStudy().times_spread;
  const auto add = [&](const char* name, auto& value, const std::string& help) {
    return command.add_option(name, value, help)->needs("--power");
  };
  CLI::Option* alpha =
      add("--alpha", one.alpha, "Significance level of the two-sided test without a protocol")
          ->check(CLI::Range(1e-6, 0.5));
  add("--protocol", arguments.protocol, "The protocol of the planned study")->excludes(alpha);
  add("--ratio", expectations.ratio_percent,
      "Expected time with every other method, in per cent of that with the baseline");
  add("--effect", arguments.effects,
      "The expectation of one measure, MEASURE:METHOD:VALUE; may be repeated: for a mark "
      "per cent of the baseline's time (material:fv:25), for a rating points above the baseline's "
      "(comfort:fv:1)");
  add("--seconds", expectations.baseline_s,
      "Expected times with the baseline, by mark: 10,30; each missing time is twice "
      "the previous one (default 10)")
      ->delimiter(',');
  add("--spread", arguments.spread,
      fmt::format(
          "Geometric standard deviation of participants' ratios, from 1: two thirds lie within it "
          "(default {:.3g}; without a protocol {:g}, including variation between trials)",
          std::exp(usual.participants_gain), one.spread));
  add("--scene-spread", expectations.scenes_factor,
      fmt::format("Geometric standard deviation of scenes' ratios (default {:.3g})",
                  std::exp(usual.scenes_gain)));
  add("--trial-spread", expectations.trials_factor,
      fmt::format("Geometric standard deviation of single times (default {:.3g})",
                  std::exp(usual.trials)));
  add("--mark-variation", expectations.mark_variation,
      fmt::format(
          "Coefficient of variation of the logarithm of a mark's time over that of the previous "
          "mark: the larger, the less the marks of a trial depend on each other "
          "(default {:g})",
          ExpectedStudy().later_marks_variation))
      ->check(CLI::Range(0.0, 10.0));
  add("--withdrawals", expectations.withdrawals,
      "Probability that a participant withdraws (default 0)")
      ->check(CLI::Range(0.0, 0.95));
  add("--scenes", expectations.scenes, "Number of scenes, if not the protocol's")
      ->check(CLI::Range(1, 1000));
  add("--target", one.power, "Target power")->check(CLI::Range(0.06, 0.9999));
  add("--participants", one.participants,
      "Report the power with this many participants, instead of the required number")
      ->check(CLI::Range(2, 1'000'000));
  add("--most-participants", arguments.most_participants,
      "Maximum number of participants to try with a protocol")
      ->check(CLI::Range(4, 4096));
  add("--studies", arguments.studies,
      "Studies to simulate (default 10000; with a protocol 2000 per number of participants)")
      ->check(CLI::Range(1, 10'000'000));
  add("--seed", one.seed, "Seed of the simulation");
}

void run_power(const PowerArguments& arguments, const std::stop_token& stop) {
  if (!arguments.pilot.empty() && !arguments.protocol.empty()) {
    throw UsageError("--protocol", "cannot be combined with a pilot, which has its own protocol",
                     "remove one of them");
  }
  if (arguments.pilot.empty() && arguments.protocol.empty()) {
    plan_one_comparison(arguments);
  } else {
    plan_study(arguments, stop);
  }
}

PowerPlan plan_power(const PowerSettings& settings) {
  const ExpectedEffect effect = effect_of(settings);
  const std::optional<std::size_t> participants =
      settings.participants ? settings.participants
                            : participants_for_power(settings.power, effect, settings.alpha);
  if (!participants) {
    throw Error("--power", "a million participants are too few for this effect",
                "choose a --ratio further from 100, or lower --spread");
  }
  const SimulatedPower simulated =
      simulate_power(*participants, effect, settings.alpha, settings.studies, settings.seed);
  return {*participants, paired_t_power(*participants, effect, settings.alpha), simulated.power,
          simulated.interval.low, simulated.interval.high};
}

std::string power_text(const PowerSettings& settings, const PowerPlan& plan) {
  return fmt::format(
      "Times of {:g} % of the baseline's, participants' own ratios spread by a factor of {:g},\n"
      "paired t test on logarithms at a level of {:g}, two-sided:\n"
      "  participants             {}\n"
      "  power, by formula        {:.4f}\n"
      "  power, by simulation     {:.4f} [{:.4f}, {:.4f}] of {} studies\n",
      settings.ratio_percent, settings.spread, settings.alpha, plan.participants, plan.power,
      plan.simulated_power, plan.simulated_low, plan.simulated_high, settings.studies);
}

std::string power_json(const PowerSettings& settings, const PowerPlan& plan) {
  const nlohmann::ordered_json json = {
      {"ratio_percent", settings.ratio_percent},
      {"spread", settings.spread},
      {"alpha", settings.alpha},
      {"participants", plan.participants},
      {"power", plan.power},
      {"simulated_power", plan.simulated_power},
      {"simulated_ci95", {plan.simulated_low, plan.simulated_high}},
      {"simulated_studies", settings.studies},
      {"seed", settings.seed}};
  return json.dump(2);
}

}  // namespace foveola::analysis
