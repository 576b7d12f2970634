#include "analysis/replication/bench_ratios.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "analysis/statistics/distributions.h"
#include "renderer/base/error.h"

namespace foveola::analysis {
namespace {

using BenchJson = nlohmann::ordered_json;

constexpr std::array<std::string_view, 14> identities = {
    "name",  "kind", "scene",  "gaze",   "configuration", "region", "metric",
    "level", "unit", "method", "option", "threads",       "what",   "claim"};

bool is_identity(std::string_view key, const BenchJson& /*value*/) {
  return std::ranges::find(identities, key) != identities.end();
}

/// Returns "threads=2", or the position if no key distinguishes it.
std::string identity_of(const BenchJson& element, std::size_t position, IsIdentity is_identity) {
  std::string identity;
  if (element.is_object()) {
    for (const auto& [key, value] : element.items()) {
      if (is_identity(key, value)) {
        identity += fmt::format("{}{}={}", identity.empty() ? "" : ",", key,
                                value.is_string() ? value.get<std::string>() : value.dump());
      }
    }
  }
  return identity.empty() ? std::to_string(position) : identity;
}

/// Returns the value of {"value": 3, "low": 2, "high": 4}, or of "median" or "percent", which is
/// one figure; its ends may be null.
const BenchJson* estimated_value(const BenchJson& node) {
  if (node.is_object() && node.contains("low") && node.contains("high")) {
    for (const char* key : {"value", "median", "percent"}) {
      if (const auto found = node.find(key); found != node.end() && found->is_number()) {
        return &*found;
      }
    }
  }
  return nullptr;
}

BenchJson parse(const std::string& text, const std::string& name) {
  BenchJson json = BenchJson::parse(text, nullptr, false);
  if (!json.is_object()) {
    throw Error(name, "is not a JSON object",
                "name a file with the --json output of a foveola bench command");
  }
  return json;
}

bool is_of_figures(const BenchJson& value) {
  return value.is_array() || estimated_value(value) != nullptr;
}

std::vector<BenchFigure> figures_of(const BenchJson& json) {
  std::vector<BenchFigure> figures;
  for (const auto& [key, value] : json.items()) {
    if (is_of_figures(value)) {
      collect_figures(value, key, is_identity, figures);
    }
  }
  return figures;
}

/// Collects the settings, those in objects as "plan.width".
void collect_settings(const BenchJson& node, const std::string& place, BenchJson& settings) {
  for (const auto& [key, value] : node.items()) {
    if (is_of_figures(value) || (place.empty() && key == "date")) {
      continue;
    }
    if (value.is_object()) {
      collect_settings(value, place + key + ".", settings);
    } else {
      settings[place + key] = value;
    }
  }
}

std::vector<std::string> differing_settings(const BenchJson& before, const BenchJson& after) {
  BenchJson was = BenchJson::object();
  BenchJson is = BenchJson::object();
  collect_settings(before, "", was);
  collect_settings(after, "", is);
  std::vector<std::string> differing;
  for (const auto& [key, value] : was.items()) {
    if (!is.contains(key)) {
      differing.push_back(fmt::format("{}: {}, now absent", key, value.dump()));
    } else if (is.at(key) != value) {
      differing.push_back(fmt::format("{}: {}, now {}", key, value.dump(), is.at(key).dump()));
    }
  }
  for (const auto& [key, value] : is.items()) {
    if (!was.contains(key)) {
      differing.push_back(fmt::format("{}: absent, now {}", key, value.dump()));
    }
  }
  return differing;
}

/// Returns the figure's absolute value, with the ends of its interval exchanged if needed.
BenchFigure magnitude(BenchFigure figure) {
  if (figure.value < 0.0) {
    figure.value = -figure.value;
    if (figure.interval) {
      figure.interval = Interval{-figure.interval->high, -figure.interval->low};
    }
  }
  return figure;
}

/// Intervals of 95 % are widened by a factor.
std::optional<Interval> ratio_interval(const BenchFigure& before, const BenchFigure& after,
                                       double widening) {
  const BenchFigure a = magnitude(before);
  const BenchFigure b = magnitude(after);
  if (before.value * after.value <= 0.0 || !a.interval || !b.interval || a.interval->low <= 0.0 ||
      b.interval->low <= 0.0) {
    return std::nullopt;
  }
  const double ratio = b.value / a.value;
  const double down =
      std::hypot(std::log(b.value / b.interval->low), std::log(a.interval->high / a.value));
  const double up =
      std::hypot(std::log(b.interval->high / b.value), std::log(a.value / a.interval->low));
  return Interval{ratio * std::exp(-widening * down), ratio * std::exp(widening * up)};
}

/// Both must have an interval.
Interval difference_interval(const BenchFigure& a, const BenchFigure& b, double widening) {
  const double difference = b.value - a.value;
  const double down = std::hypot(b.value - b.interval->low, a.interval->high - a.value);
  const double up = std::hypot(b.interval->high - b.value, a.value - a.interval->low);
  return {difference - widening * down, difference + widening * up};
}

bool is_outside(double value, const Interval& interval) {
  return value < interval.low || value > interval.high;
}

bool is_beyond(const BenchFigure& before, const BenchFigure& after, double widening) {
  const std::optional<Interval> ratio = ratio_interval(before, after, widening);
  return ratio ? is_outside(1.0, *ratio)
               : is_outside(0.0, difference_interval(before, after, widening));
}

/// A figure of both runs.
struct BenchPair {
  BenchFigure before;
  BenchFigure after;

  BenchFigureKind kind() const {
    if (before.is_exact && after.is_exact) {
      return BenchFigureKind::exact;
    }
    return before.interval && after.interval ? BenchFigureKind::with_interval
                                             : BenchFigureKind::without_interval;
  }
};

BenchMove move_of(const BenchPair& pair, double widening) {
  switch (pair.kind()) {
    case BenchFigureKind::exact:
      return pair.before.value != pair.after.value ? BenchMove::exactly : BenchMove::none;
    case BenchFigureKind::without_interval:
      return pair.before.value != pair.after.value ? BenchMove::without_interval : BenchMove::none;
    case BenchFigureKind::with_interval:
      break;
  }
  if (!is_beyond(pair.before, pair.after, 1.0)) {
    return BenchMove::none;
  }
  return is_beyond(pair.before, pair.after, widening) ? BenchMove::together : BenchMove::alone;
}

BenchRatio judged(const BenchPair& pair, double widening) {
  BenchRatio row{.figure = pair.before.place,
                 .before = pair.before.value,
                 .after = pair.after.value,
                 .interval = ratio_interval(pair.before, pair.after, 1.0),
                 .together = ratio_interval(pair.before, pair.after, widening),
                 .kind = pair.kind(),
                 .move = move_of(pair, widening)};
  if (pair.before.value * pair.after.value > 0.0) {
    row.ratio = pair.after.value / pair.before.value;
  }
  return row;
}

void pair_figures(const BenchJson& before, const BenchJson& after, std::vector<BenchPair>& pairs,
                  std::vector<std::string>& unmatched) {
  std::vector<BenchFigure> others = figures_of(after);
  for (BenchFigure& figure : figures_of(before)) {
    const auto other = std::ranges::find(others, figure.place, &BenchFigure::place);
    if (other == others.end()) {
      unmatched.push_back(figure.place);
      continue;
    }
    pairs.push_back({std::move(figure), std::move(*other)});
    others.erase(other);
  }
  for (const BenchFigure& other : others) {
    unmatched.push_back(other.place);
  }
}

constexpr double level = 0.95;

void judge(const std::vector<BenchPair>& pairs, BenchComparison& comparison) {
  const auto count = std::ranges::count_if(
      pairs, [](const BenchPair& pair) { return pair.kind() == BenchFigureKind::with_interval; });
  comparison.level_of_each = std::pow(level, 1.0 / static_cast<double>(std::max(count, 1L)));
  const double widening =
      normal_two_sided_quantile(comparison.level_of_each) / normal_two_sided_quantile(level);
  for (const BenchPair& pair : pairs) {
    comparison.ratios.push_back(judged(pair, widening));
  }
}

}  // namespace

void collect_figures(const BenchJson& node, const std::string& place, IsIdentity is_identity,
                     std::vector<BenchFigure>& figures) {
  if (node.is_number()) {
    figures.push_back({place, node.get<double>(), {}, true});
  } else if (const BenchJson* value = estimated_value(node)) {
    BenchFigure figure{place, value->get<double>(), {}, false};
    if (node["low"].is_number() && node["high"].is_number()) {
      figure.interval = Interval{node["low"].get<double>(), node["high"].get<double>()};
    }
    figures.push_back(figure);
  } else if (node.is_object()) {
    for (const auto& [key, child] : node.items()) {
      if (!is_identity(key, child)) {
        collect_figures(child, fmt::format("{}{}{}", place, place.empty() ? "" : ".", key),
                        is_identity, figures);
      }
    }
  } else if (node.is_array()) {
    for (std::size_t i = 0; i < node.size(); ++i) {
      collect_figures(node[i], fmt::format("{}[{}]", place, identity_of(node[i], i, is_identity)),
                      is_identity, figures);
    }
  }
}

std::size_t BenchComparison::count(BenchFigureKind kind) const {
  return static_cast<std::size_t>(std::ranges::count(ratios, kind, &BenchRatio::kind));
}

std::vector<BenchRatio> BenchComparison::moved(BenchMove move) const {
  std::vector<BenchRatio> rows;
  std::ranges::copy_if(ratios, std::back_inserter(rows),
                       [move](const BenchRatio& row) { return row.move == move; });
  return rows;
}

BenchComparison compare_benches(const std::string& before, const std::string& before_name,
                                const std::string& after, const std::string& after_name) {
  const BenchJson was = parse(before, before_name);
  const BenchJson is = parse(after, after_name);
  BenchComparison comparison;
  std::vector<BenchPair> pairs;
  pair_figures(was, is, pairs, comparison.unmatched);
  comparison.differing = differing_settings(was, is);
  judge(pairs, comparison);
  if (comparison.ratios.empty()) {
    throw Error(after_name, "has no figure in common with " + before_name,
                "compare two outputs of the same bench command");
  }
  return comparison;
}

}  // namespace foveola::analysis
