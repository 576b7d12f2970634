#include "analysis/commands/bench_ratios.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/error.h"

namespace foveola::analysis {
namespace {

using BenchJson = nlohmann::ordered_json;

/// The keys that distinguish the elements of an array.
constexpr std::array<std::string_view, 12> identities = {
    "name",   "kind",  "scene", "gaze",   "configuration", "region",
    "metric", "level", "unit",  "method", "option",        "threads"};

bool is_identity(std::string_view key) {
  return std::find(identities.begin(), identities.end(), key) != identities.end();
}

struct BenchFigure {
  std::string place;
  double value = 0.0;
  std::optional<Interval> interval;
};

/// "threads=2", or the position where no key distinguishes it.
std::string identity_of(const BenchJson& element, std::size_t position) {
  std::string identity;
  if (element.is_object()) {
    for (const auto& [key, value] : element.items()) {
      if (is_identity(key)) {
        identity += fmt::format("{}{}={}", identity.empty() ? "" : ",", key,
                                value.is_string() ? value.get<std::string>() : value.dump());
      }
    }
  }
  return identity.empty() ? std::to_string(position) : identity;
}

/// {"value": 3, "low": 2, "high": 4}, or "median" for "value", is one figure; the ends may be null.
const BenchJson* estimated_value(const BenchJson& node) {
  if (node.is_object() && node.contains("low") && node.contains("high")) {
    for (const char* key : {"value", "median"}) {
      if (const auto found = node.find(key); found != node.end() && found->is_number()) {
        return &*found;
      }
    }
  }
  return nullptr;
}

void collect(const BenchJson& node, const std::string& place, std::vector<BenchFigure>& figures) {
  if (node.is_number()) {
    figures.push_back({place, node.get<double>(), {}});
  } else if (const BenchJson* value = estimated_value(node)) {
    BenchFigure figure{place, value->get<double>(), {}};
    if (node["low"].is_number() && node["high"].is_number()) {
      figure.interval = Interval{node["low"].get<double>(), node["high"].get<double>()};
    }
    figures.push_back(figure);
  } else if (node.is_object()) {
    for (const auto& [key, child] : node.items()) {
      if (!is_identity(key)) {
        collect(child, fmt::format("{}.{}", place, key), figures);
      }
    }
  } else if (node.is_array()) {
    for (std::size_t i = 0; i < node.size(); ++i) {
      collect(node[i], fmt::format("{}[{}]", place, identity_of(node[i], i)), figures);
    }
  }
}

BenchJson parse(const std::string& text, const std::string& name) {
  BenchJson json = BenchJson::parse(text, nullptr, false);
  if (!json.is_object()) {
    throw Error(name, "is no JSON object", "give what a foveola bench command prints with --json");
  }
  return json;
}

std::vector<BenchFigure> figures_of(const BenchJson& json) {
  std::vector<BenchFigure> figures;
  for (const auto& [key, value] : json.items()) {
    if (value.is_array()) {
      collect(value, key, figures);
    }
  }
  return figures;
}

std::vector<std::string> differing_settings(const BenchJson& before, const BenchJson& after) {
  std::vector<std::string> differing;
  const auto text_of = [](const BenchJson& json, const std::string& key) {
    const auto found = json.find(key);
    return found != json.end() ? found->dump() : std::string("absent");
  };
  const auto compare = [&](const std::string& key) {
    const std::string was = text_of(before, key);
    const std::string is = text_of(after, key);
    if (was != is) {
      differing.push_back(fmt::format("{}: {}, now {}", key, was, is));
    }
  };
  for (const auto& [key, value] : before.items()) {
    if (!value.is_array()) {
      compare(key);
    }
  }
  for (const auto& [key, value] : after.items()) {
    if (!value.is_array() && !before.contains(key)) {
      compare(key);
    }
  }
  return differing;
}

/// The figure's absolute value, with the ends of its interval exchanged where needed.
BenchFigure magnitude(BenchFigure figure) {
  if (figure.value < 0.0) {
    figure.value = -figure.value;
    if (figure.interval) {
      figure.interval = Interval{-figure.interval->high, -figure.interval->low};
    }
  }
  return figure;
}

std::optional<Interval> ratio_interval(const BenchFigure& before, const BenchFigure& after) {
  const BenchFigure a = magnitude(before);
  const BenchFigure b = magnitude(after);
  if (!a.interval || !b.interval || a.interval->low <= 0.0 || b.interval->low <= 0.0) {
    return std::nullopt;
  }
  const double ratio = b.value / a.value;
  const double down =
      std::hypot(std::log(b.value / b.interval->low), std::log(a.interval->high / a.value));
  const double up =
      std::hypot(std::log(b.interval->high / b.value), std::log(a.value / a.interval->low));
  return Interval{ratio * std::exp(-down), ratio * std::exp(up)};
}

}  // namespace

BenchComparison compare_benches(const std::string& before, const std::string& before_name,
                                const std::string& after, const std::string& after_name) {
  const BenchJson before_json = parse(before, before_name);
  const BenchJson after_json = parse(after, after_name);
  const std::vector<BenchFigure> figures = figures_of(before_json);
  std::vector<BenchFigure> others = figures_of(after_json);
  BenchComparison comparison;
  comparison.differing = differing_settings(before_json, after_json);
  for (const BenchFigure& figure : figures) {
    const auto other = std::find_if(others.begin(), others.end(),
                                    [&](const BenchFigure& o) { return o.place == figure.place; });
    const bool has_ratio = other != others.end() && figure.value * other->value > 0.0;
    if (has_ratio) {
      comparison.ratios.push_back({.figure = figure.place,
                                   .before = figure.value,
                                   .after = other->value,
                                   .ratio = other->value / figure.value,
                                   .interval = ratio_interval(figure, *other)});
    } else {
      comparison.unmatched.push_back(figure.place);
    }
    if (other != others.end()) {
      others.erase(other);
    }
  }
  for (const BenchFigure& other : others) {
    comparison.unmatched.push_back(other.place);
  }
  if (comparison.ratios.empty()) {
    throw Error(after_name, "has no figure in common with " + before_name,
                "compare two outputs of the same bench command");
  }
  return comparison;
}

}  // namespace foveola::analysis
