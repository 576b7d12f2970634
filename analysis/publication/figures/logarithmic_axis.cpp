#include "analysis/publication/figures/logarithmic_axis.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/publication/figures/figure_drawing.h"

namespace foveola::analysis {
namespace {

constexpr double no_change = 100.0;  // In per cent of the baseline.

/// Returns the given multiples of every power of ten within the range.
std::vector<double> multiples_of_powers(const Interval& range,
                                        const std::vector<double>& multiples) {
  std::vector<double> ticks;
  const auto last = static_cast<int>(std::floor(std::log10(range.high)));
  for (auto power = static_cast<int>(std::floor(std::log10(range.low))); power <= last; ++power) {
    for (const double multiple : multiples) {
      // Divides whole numbers if the power is below one: exactly 0.2, without a rounding error.
      const double tick =
          power < 0 ? multiple / std::pow(10.0, -power) : multiple * std::pow(10.0, power);
      if (tick >= range.low && tick <= range.high) {
        ticks.push_back(tick);
      }
    }
  }
  return ticks;
}

/// Returns about five multiples of 1, 2 or 5 times a power of ten.
std::vector<double> equal_steps(const Interval& range) {
  constexpr double steps = 5.0;
  const double least = (range.high - range.low) / steps;
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  double step = 10.0 * power;
  for (const double multiple : {5.0, 2.0, 1.0}) {
    step = multiple * power >= least ? multiple * power : step;
  }
  std::vector<double> ticks;
  const auto last = static_cast<long>(std::floor(range.high / step));
  for (auto count = static_cast<long>(std::ceil(range.low / step)); count <= last; ++count) {
    ticks.push_back(static_cast<double>(count) * step);
  }
  return ticks;
}

}  // namespace

std::optional<Interval> reach_of(const std::vector<double>& values,
                                 const std::vector<Interval>& intervals) {
  constexpr double farthest = 2.5;
  constexpr double margin = 1.15;
  if (values.empty()) {
    return std::nullopt;
  }
  const auto [low, high] = std::ranges::minmax_element(values);
  Interval reach{*low, *high};
  for (const Interval& interval : intervals) {
    reach.low = std::min(reach.low, std::max(interval.low, *low / farthest));
    reach.high = std::max(reach.high, std::min(interval.high, *high * farthest));
  }
  return Interval{reach.low / margin, reach.high * margin};
}

std::vector<double> logarithmic_ticks(const Interval& range) {
  constexpr std::size_t enough = 5;
  constexpr std::size_t fewest = 4;
  constexpr std::size_t most = 13;
  std::vector<double> ticks = multiples_of_powers(range, {1.0, 2.0, 5.0});
  if (ticks.size() > most) {
    return multiples_of_powers(range, {1.0});
  }
  if (ticks.size() < enough) {
    ticks = multiples_of_powers(range, {1.0, 1.5, 2.0, 3.0, 5.0, 7.0});
  }
  if (ticks.size() < enough) {
    ticks = multiples_of_powers(range, {1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0});
  }
  return ticks.size() < fewest ? equal_steps(range) : ticks;
}

std::string plain_number(double value) {
  constexpr int digits = 10;
  const int decimals =
      value > 0.0 ? std::max(0, digits - static_cast<int>(std::floor(std::log10(value)))) : 0;
  std::string number = fmt::format("{:.{}f}", value, decimals);
  if (number.find('.') != std::string::npos) {
    number.erase(number.find_last_not_of('0') + 1);
    number.erase(number.back() == '.' ? number.size() - 1 : number.size());
  }
  return number;
}

std::string logarithmic_axis(const Interval& range) {
  std::vector<std::string> ticks;
  for (const double tick : logarithmic_ticks(range)) {
    ticks.push_back(fmt::format("'{0}' {0}", plain_number(tick)));
  }
  return fmt::format(
      "set logscale x\nset xrange [{}:{}]\nset xtics ({})\n"
      "set grid xtics linetype 1 linewidth 1 linecolor rgb '{}'\n",
      range.low, range.high, fmt::join(ticks, ", "), palette::grid.rgb);
}

Interval with_no_change(const Interval& percent) {
  constexpr double margin = 1.05;
  return {std::min(percent.low, no_change / margin), std::max(percent.high, no_change * margin)};
}

std::string relative_axes(const Interval& percent, const std::string& reference) {
  std::vector<std::string> factors;
  for (const double factor :
       logarithmic_ticks({no_change / percent.high, no_change / percent.low})) {
    factors.push_back(fmt::format("'{}×' {}", plain_number(factor), no_change / factor));
  }
  return logarithmic_axis(percent) +
         fmt::format(
             "set logscale x2\nset x2range [{}:{}]\n"
             "set x2tics out nomirror ({}) textcolor rgb '{}'\n",
             percent.low, percent.high, fmt::join(factors, ", "), palette::ink.rgb) +
         fmt::format(
             "set border 5\nset xlabel {}\nset x2label {} textcolor rgb '{}'\n"
             "set arrow from {}, graph 0 to {}, graph 1 nohead linewidth 1 linecolor rgb '{}'\n",
             gnuplot_quoted("Time, per cent of " + reference + "’s (logarithmic)"),
             gnuplot_quoted("Speed-up over " + reference), palette::ink.rgb, no_change, no_change,
             palette::ink.rgb);
}

}  // namespace foveola::analysis
