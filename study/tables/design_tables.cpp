#include "study/tables/design_tables.h"

#include <algorithm>

#include <fmt/format.h>

#include "renderer/base/aligned_rows.h"
#include "study/design/participant_code.h"

namespace foveola::study {
namespace {

std::vector<std::string> scene_names(const Protocol& protocol) {
  std::vector<std::string> names;
  for (const SceneEntry& scene : protocol.scenes) {
    names.push_back(scene.name);
  }
  return names;
}

/// "" "1st" ... "after od" ...
TextRow balance_header(const std::string& what, const std::vector<std::string>& names) {
  TextRow header{what};
  for (std::size_t position = 1; position <= names.size(); ++position) {
    header.push_back(fmt::format("at {}", position));
  }
  for (const std::string& name : names) {
    header.push_back("after " + name);
  }
  return header;
}

void add_counts(std::vector<TextRow>& rows, const std::string& what,
                const std::vector<std::string>& names, const Counts& at, const Counts& after) {
  rows.push_back(balance_header(what, names));
  for (std::size_t i = 0; i < names.size(); ++i) {
    TextRow row{names[i]};
    for (const int count : at[i]) {
      row.push_back(fmt::format("{}", count));
    }
    for (std::size_t before = 0; before < names.size(); ++before) {
      row.push_back(before == i ? "-" : fmt::format("{}", after[i][before]));
    }
    rows.push_back(row);
  }
}

int largest_in_one_scene(const Balance& balance) {
  int largest = 0;
  for (const Counts& counts : balance.method_at_in) {
    largest = std::max(largest, largest_difference(counts));
  }
  return largest;
}

TextRow minutes(const std::string& name, const std::string& count, const Duration& duration) {
  return {name, count, fmt::format("{:.1f}", duration.least_s / 60.0),
          fmt::format("{:.1f}", duration.most_s / 60.0)};
}

}  // namespace

std::string plan_table(const std::vector<Plan>& plans) {
  std::vector<TextRow> rows = {{"participant", "position", "scene", "methods"}};
  for (std::size_t index = 0; index < plans.size(); ++index) {
    const std::string code = participant_code(static_cast<int>(index));
    for (const PlannedTrial& trial : plans[index]) {
      if (trial.kind == TrialKind::practice) {
        rows.push_back({code, name_of(trial.kind), trial.scene, trial.method});
      } else if (trial.kind == TrialKind::catch_trial) {
        rows.back().back() += fmt::format(", ({})", name_of(trial.kind));
      } else if (trial.method_position == 0) {
        rows.push_back(
            {code, fmt::format("{}", trial.scene_position + 1), trial.scene, trial.method});
      } else {
        rows.back().back() += ", " + trial.method;
      }
    }
  }
  return aligned(rows);
}

std::string balance_table(const Protocol& protocol, const Balance& balance) {
  std::vector<TextRow> methods;
  add_counts(methods, "methods", protocol.methods, balance.method_at, balance.method_after);
  std::vector<TextRow> scenes;
  add_counts(scenes, "scenes", scene_names(protocol), balance.scene_at, balance.scene_after);
  const std::vector<TextRow> differences = {
      {"largest difference", "at positions", "in one scene", "after one another"},
      {"methods", fmt::format("{}", largest_difference(balance.method_at)),
       fmt::format("{}", largest_in_one_scene(balance)),
       fmt::format("{}", largest_difference_after(balance.method_after))},
      {"scenes", fmt::format("{}", largest_difference(balance.scene_at)), "",
       fmt::format("{}", largest_difference_after(balance.scene_after))}};
  return aligned(methods) + "\n" + aligned(scenes) + "\n" + aligned(differences);
}

std::string duration_table(const std::vector<SessionPart>& parts) {
  std::vector<TextRow> rows = {{"minutes of", "", "at least", "at most"}};
  for (const SessionPart& part : parts) {
    rows.push_back(minutes(part.name, fmt::format("{}", part.count), part.duration));
  }
  rows.push_back(minutes("a session", "", total_of(parts)));
  std::vector<TextRow> assumed = {{"assumed seconds", "at least", "at most"}};
  for (const AssumedDuration& assumption : assumed_durations()) {
    const double most_s = assumption.duration.most_s;
    assumed.push_back({std::string(assumption.of), fmt::format("{}", assumption.duration.least_s),
                       most_s > 0.0 ? fmt::format("{}", most_s) : ""});
  }
  return aligned(rows) + "\n" + aligned(assumed);
}

}  // namespace foveola::study
