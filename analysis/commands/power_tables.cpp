#include "analysis/commands/power_tables.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analysis/statistics/power.h"
#include "renderer/base/error.h"

namespace foveola::analysis {
namespace {

ExpectedEffect effect_of(const PowerSettings& settings) {
  if (!(settings.ratio_percent > 0.0) || settings.ratio_percent == 100.0) {
    throw Error("--ratio", fmt::format("{:g} % is not an effect to detect", settings.ratio_percent),
                "give the expected time in per cent of the baseline's, above 0 and not 100");
  }
  if (!(settings.spread > 1.0)) {
    throw Error("--spread", fmt::format("{:g} is not a factor above 1", settings.spread),
                "give the factor by which participants' own ratios differ, above 1");
  }
  return effect_of_ratio(settings.ratio_percent, settings.spread);
}

}  // namespace

PowerPlan plan_power(const PowerSettings& settings) {
  const ExpectedEffect effect = effect_of(settings);
  const std::optional<std::size_t> participants =
      settings.participants ? settings.participants
                            : participants_for_power(settings.power, effect, settings.alpha);
  if (!participants) {
    throw Error("--power", "a million participants are too few for this effect",
                "expect a larger effect or a smaller spread");
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
