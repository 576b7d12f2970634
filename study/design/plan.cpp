#include "study/design/plan.h"

#include <algorithm>
#include <numeric>
#include <span>

#include "renderer/base/numbers/random.h"
#include "renderer/base/transformed.h"
#include "study/design/orders.h"

namespace foveola::study {
namespace {

int scene_count(const Protocol& protocol) { return static_cast<int>(protocol.scenes.size()); }
int method_count(const Protocol& protocol) { return static_cast<int>(protocol.methods.size()); }

Permutation drawn_order(int n, Pcg32& generator) {
  Permutation order = row_of(Order::fixed, n, 0);
  shuffle(std::span(order), generator);
  return order;
}

Permutation order_of_scenes(const Protocol& protocol, int row, Pcg32& generator) {
  const int n = scene_count(protocol);
  return protocol.scene_order == Order::random ? drawn_order(n, generator)
                                               : row_of(protocol.scene_order, n, row);
}

Permutation order_of_methods(const Protocol& protocol, int scene, int row, Pcg32& generator) {
  const int n = method_count(protocol);
  return protocol.method_order == Order::random
             ? drawn_order(n, generator)
             : crossed_row_of(protocol.method_order, n, scene, row);
}

Plan practice_trials(const Protocol& protocol) {
  return transformed(protocol.practice, [&](const PracticeEntry& entry) {
    return PlannedTrial{.scene = entry.scene, .method = entry.method, .kind = TrialKind::practice};
  });
}

Plan test_trials(const Protocol& protocol, int row, Pcg32& generator) {
  Plan plan;
  const Permutation scenes = order_of_scenes(protocol, row, generator);
  for (std::size_t scene = 0; scene < scenes.size(); ++scene) {
    const Permutation methods = order_of_methods(protocol, scenes[scene], row, generator);
    for (std::size_t method = 0; method < methods.size(); ++method) {
      plan.push_back({.scene = protocol.scenes[scenes[scene]].name,
                      .method = protocol.methods[methods[method]],
                      .scene_position = static_cast<int>(scene),
                      .method_position = static_cast<int>(method)});
    }
  }
  return plan;
}

/// Inserts catch trials, each after a test trial of its scene and method, so that none is the first
/// and no two are adjacent.
Plan with_catch_trials(const Plan& tests, int count, Pcg32& generator) {
  Permutation places = drawn_order(static_cast<int>(tests.size()), generator);
  places.resize(static_cast<std::size_t>(count));
  Plan plan;
  for (std::size_t i = 0; i < tests.size(); ++i) {
    plan.push_back(tests[i]);
    if (std::ranges::find(places, static_cast<int>(i)) != places.end()) {
      plan.push_back(
          {.scene = tests[i].scene, .method = tests[i].method, .kind = TrialKind::catch_trial});
    }
  }
  return plan;
}

/// Returns whether the previous trial's object is kept.
bool keeps_object(const PlannedTrial& before, const PlannedTrial& trial) {
  return before.scene == trial.scene &&
         (before.kind == TrialKind::practice) == (trial.kind == TrialKind::practice);
}

void add_trials(Agenda& agenda, const Protocol& protocol, const Plan& plan) {
  for (std::size_t i = 0; i < plan.size(); ++i) {
    const bool chooses_object = protocol.object_choice == ObjectChoice::per_method || i == 0 ||
                                !keeps_object(plan[i - 1], plan[i]);
    agenda.push_back(TrialStep{.trial = i, .chooses_object = chooses_object});
  }
}

}  // namespace

const char* name_of(TrialKind kind) {
  switch (kind) {
    case TrialKind::practice:
      return "practice";
    case TrialKind::catch_trial:
      return "catch";
    case TrialKind::test:
      break;
  }
  return "test";
}

Agenda agenda_of(const Protocol& protocol, const Plan& plan) {
  Agenda agenda;
  for (const PhaseEntry& phase : protocol.phases) {
    switch (phase.kind) {
      case PhaseEntry::Kind::consent:
        agenda.emplace_back(ConsentStep{});
        break;
      case PhaseEntry::Kind::questionnaire:
        agenda.emplace_back(QuestionnaireStep{phase.questionnaire});
        break;
      case PhaseEntry::Kind::validation:
        agenda.emplace_back(ValidationStep{protocol.tracker.validation->attempts});
        break;
      case PhaseEntry::Kind::reaction:
        agenda.emplace_back(ReactionStep{protocol.reaction->presses});
        break;
      case PhaseEntry::Kind::trials:
        add_trials(agenda, protocol, plan);
        break;
    }
  }
  return agenda;
}

Plan make_plan(const Protocol& protocol, std::uint64_t seed, int row) {
  Pcg32 generator(seed, static_cast<std::uint64_t>(row));
  Plan plan = practice_trials(protocol);
  Plan tests = test_trials(protocol, row, generator);
  if (protocol.catch_trials.count > 0) {
    tests = with_catch_trials(tests, protocol.catch_trials.count, generator);
  }
  plan.insert(plan.end(), tests.begin(), tests.end());
  return plan;
}

int design_rows(const Protocol& protocol) {
  const int scene_rows = row_count(protocol.scene_order, scene_count(protocol));
  const int method_rows = row_count(protocol.method_order, method_count(protocol));
  return scene_rows == 0 || method_rows == 0 ? std::max(scene_rows, method_rows)
                                             : std::lcm(scene_rows, method_rows);
}

int least_used_row(const Protocol& protocol, const std::vector<int>& used, int first) {
  const int rows = std::max(1, design_rows(protocol));
  std::vector<int> uses(static_cast<std::size_t>(rows), 0);
  for (const int row : used) {
    ++uses[static_cast<std::size_t>(row % rows)];
  }
  std::rotate(uses.begin(), uses.begin() + first % rows, uses.end());
  const auto least_used = std::ranges::min_element(uses) - uses.begin();
  int row = (static_cast<int>(least_used) + first % rows) % rows;
  while (std::ranges::find(used, row) != used.end()) {
    row += rows;
  }
  return row;
}

}  // namespace foveola::study
