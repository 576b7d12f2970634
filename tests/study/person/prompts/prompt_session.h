// A small protocol, and a session in it, for what its participant is asked.
#pragma once

#include "study/person/prompts/prompt_state.h"
#include "tests/study/person/forms/typing.h"

namespace foveola::study::test {

/// Its words are their ids, so that a page is known by them.
inline Protocol asking_protocol() {
  Protocol protocol;
  for (const std::string& id : known_text_ids()) {
    protocol.texts[id] = id;
  }
  protocol.marks = {{.id = "outline", .instruction = "o"}, {.id = "material", .instruction = "m"}};
  protocol.ratings = {experience()};
  protocol.reaction = ReactionSettings{.presses = 2};
  protocol.tracker.validation = ValidationSettings{.points = 5, .attempts = 3};
  protocol.questionnaires = {{.id = "background", .title = "Background", .questions = {age()}},
                             {.id = "debrief", .title = "Debrief", .questions = {comments()}}};
  protocol.timing.rating_s = 4.0;
  return protocol;
}

/// Where a session stands, and what its participant is asked.
struct PromptSession {
  Protocol protocol = asking_protocol();
  Plan plan = {{.scene = "hall", .method = "od"}, {.scene = "yard", .method = "od"}};
  Procedure procedure{
      .agenda = {TrialStep{.trial = 0}, TrialStep{.trial = 1, .chooses_object = false}}};
  SessionState seen;
  PromptState prompt{.reaction = ReactionPresses(Pcg32(1))};

  SessionContext context() const { return {protocol, plan, procedure, seen}; }
  void prepare(const Effect& effect, Nanoseconds now = Nanoseconds(0)) {
    study::prepare(prompt, effect, context(), now);
  }
  void follow(const Event& event) { study::follow(prompt, event, context()); }
};

}  // namespace foveola::study::test
