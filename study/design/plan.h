// Plans a session: its trials in their order, and all its steps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "study/protocol/protocol.h"

namespace foveola::study {

enum class TrialKind {
  test,
  practice,     ///< For practice; never analysed.
  catch_trial,  ///< Nothing is rendered: a mark is a false alarm; never analysed.
};

/// Returns the name in records: "test", "practice", "catch".
const char* name_of(TrialKind kind);

/// One method in one scene.
struct PlannedTrial {
  std::string scene;
  std::string method;
  int scene_position = 0;   ///< 0 is the first scene; test trials only.
  int method_position = 0;  ///< 0 is the first method within the scene; test trials only.
  TrialKind kind = TrialKind::test;
};

using Plan = std::vector<PlannedTrial>;

// The kinds of a session's steps.
struct ConsentStep {};
struct QuestionnaireStep {
  std::string questionnaire;  ///< An id of Protocol::questionnaires.
};
struct ValidationStep {
  int attempts = 1;  ///< Maximum number of validations of the gaze until one passes.
};

/// The reaction test: key presses at a stimulus.
struct ReactionStep {
  int presses = 1;
};
struct TrialStep {
  std::size_t trial = 0;       ///< Index into the plan.
  bool chooses_object = true;  ///< False: the last chosen object is kept.
};
using AgendaStep =
    std::variant<ConsentStep, QuestionnaireStep, ValidationStep, ReactionStep, TrialStep>;

/// All steps of a session. At least one.
using Agenda = std::vector<AgendaStep>;

/// Returns the protocol's phases with the plan's trials in them. An object is chosen for each
/// trial. If the protocol keeps it for a scene, it is chosen only if the previous trial was in
/// another scene or one of the two trials is practice.
Agenda agenda_of(const Protocol& protocol, const Plan& plan);

/// Returns the plan of row `row` of the protocol's design, with practice before and catch trials
/// between its test trials. A catch trial has the scene and method of the previous test trial.
/// Random orders, and the positions of catch trials, are drawn by seed and row. The plan depends on
/// the arguments alone, on every platform. row >= 0; beyond design_rows the rows repeat, with other
/// draws.
Plan make_plan(const Protocol& protocol, std::uint64_t seed, int row);

/// Returns the number of rows until the design's squares repeat; 0 if all orders are random.
int design_rows(const Protocol& protocol);

/// Returns the next participant's row: the first of the design's least used rows, and of its
/// repetitions the first free one. `used` has the rows of people's completed and active sessions,
/// in any order. first: the row, at least 0, of the first participant.
int least_used_row(const Protocol& protocol, const std::vector<int>& used, int first = 0);

}  // namespace foveola::study
