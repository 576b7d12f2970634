// Who sees what in which order.
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
  practice,     ///< to get used to it; never analysed
  catch_trial,  ///< nothing is rendered: whoever marks in it did not look; never analysed
};

/// The name that records use: "test", "practice", "catch".
const char* name_of(TrialKind kind);

/// One method in one scene.
struct PlannedTrial {
  std::string scene;
  std::string method;
  int scene_position = 0;   ///< 0 is the first scene; of test trials only
  int method_position = 0;  ///< 0 is the first method within the scene; of test trials only
  TrialKind kind = TrialKind::test;
};

/// A session's trials in their order.
using Plan = std::vector<PlannedTrial>;

// What a session consists of, one after the other.
struct ConsentStep {};
struct QuestionnaireStep {
  std::string questionnaire;  ///< an id of Protocol::questionnaires
};
struct ValidationStep {
  int attempts = 1;  ///< as often may the gaze be validated until it passes
};
/// Key presses at something that appears, to know how fast this participant's finger is.
struct ReactionStep {
  int presses = 1;
};
struct TrialStep {
  std::size_t trial = 0;       ///< index into the plan
  bool chooses_object = true;  ///< otherwise the one that was chosen last stays
};
using AgendaStep =
    std::variant<ConsentStep, QuestionnaireStep, ValidationStep, ReactionStep, TrialStep>;

/// All steps of a session. At least one.
using Agenda = std::vector<AgendaStep>;

/// The protocol's phases with the plan's trials in them. An object is chosen for each trial, or, if
/// the protocol keeps it for a scene, when the trial before was in another one or one of the two is
/// practice.
Agenda agenda_of(const Protocol& protocol, const Plan& plan);

/// The plan of row `row` of the protocol's design, with practice before and catch trials between
/// its test trials. A catch trial is like the test trial before it. Orders that are no squares, and
/// the places of catch trials, are drawn by seed and row. A function of its arguments alone, on
/// every platform. row >= 0, beyond design_rows it begins anew, with other draws.
Plan make_plan(const Protocol& protocol, std::uint64_t seed, int row);

/// How many rows the protocol's design has until its squares repeat; 0 if all orders are drawn.
int design_rows(const Protocol& protocol);

/// The row for the next participant: of the design's row that was used least, the first of those,
/// and among the rows that repeat it the first that is free. used: the rows of completed and active
/// sessions of people, in any order.
int least_used_row(const Protocol& protocol, const std::vector<int>& used);

}  // namespace foveola::study
