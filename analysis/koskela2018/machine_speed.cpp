#include "analysis/koskela2018/machine_speed.h"

#include <cmath>
#include <map>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/transformed.h"

namespace foveola::analysis {
namespace {

/// Rounds to five digits, so that a speed's study can be named and found again.
double rounded(double speed) {
  const double unit = std::pow(10.0, std::floor(std::log10(speed)) - 4.0);
  return std::round(speed / unit) * unit;
}

}  // namespace

std::vector<ComparedNumber> baseline_cells(const std::vector<ComparedNumber>& numbers,
                                           const std::string& mark) {
  std::vector<ComparedNumber> cells;
  for (const ComparedNumber& number : numbers) {
    if (number.source != "Table 2" || number.method != "od" ||
        (!mark.empty() && number.mark != mark)) {
      continue;
    }
    if (!number.study) {
      throw Error("calibration",
                  fmt::format("the study has no times with OD to the mark {} in {}", number.mark,
                              number.row),
                  "calibrate koskela2018 or koskela2018-original, with enough participants");
    }
    cells.push_back(number);
  }
  if (cells.empty()) {
    throw Error("calibration", fmt::format("Table 2 has no times with OD to the mark '{}'", mark),
                "calibrate with the mark outline or material");
  }
  return cells;
}

std::vector<double> log_ratios_of_scenes(const std::vector<ComparedNumber>& cells) {
  std::vector<std::string> scenes;
  std::map<std::string, std::vector<double>> ratios;
  for (const ComparedNumber& cell : cells) {
    if (ratios[cell.row].empty()) {
      scenes.push_back(cell.row);
    }
    ratios[cell.row].push_back(std::log(cell.study->value / cell.published.value));
  }
  return transformed(scenes, [&](const std::string& scene) { return *mean(ratios[scene]); });
}

MachineSpeed fit_machine_speed(const CompareAtSpeed& compare, double first,
                               const std::string& mark) {
  constexpr int max_steps = 12;
  constexpr double tolerance = 0.002;
  constexpr double faster = 1.1;
  const auto ratios_at = [&](double speed) {
    return log_ratios_of_scenes(baseline_cells(compare(speed), mark));
  };
  double speed = rounded(first);
  std::vector<double> ratios = ratios_at(speed);
  double slope = -1.0;  // if times depend on samples only
  for (int step = 0; std::abs(*mean(ratios)) > tolerance; ++step) {
    if (step == max_steps) {
      throw Error("calibration",
                  fmt::format("no speed was found in {} studies; at {:.0f} samples a second the "
                              "times are {:.3g} times the published ones",
                              max_steps + 1, speed, std::exp(*mean(ratios))),
                  "use more participants");
    }
    const double before = *mean(ratios);
    const double next = rounded(speed * std::exp(-before / slope));
    ratios = ratios_at(next);
    const double measured = (*mean(ratios) - before) / std::log(next / speed);
    slope = measured < 0.0 ? measured : slope;
    speed = next;
  }
  slope = (*mean(ratios_at(rounded(faster * speed))) - *mean(ratios)) /
          std::log(rounded(faster * speed) / speed);
  if (!(slope < 0.0)) {
    throw Error("calibration", "a faster machine does not make times shorter",
                "use more participants");
  }
  MachineSpeed fitted{.samples_per_second = speed, .interval = std::nullopt};
  if (const auto interval = mean_estimate(ratios)->interval) {
    fitted.interval = Interval{speed * std::exp(interval->low / -slope),
                               speed * std::exp(interval->high / -slope)};
  }
  return fitted;
}

}  // namespace foveola::analysis
