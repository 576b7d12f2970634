#include "study/person/prompts/prompt_state.h"

namespace foveola::study {
namespace {

constexpr Nanoseconds acknowledgement = std::chrono::milliseconds(900);

/// Updates the prompt for each event; most change nothing.
struct Following {
  PromptState& prompt;
  const Texts& texts;

  void operator()(const SessionStarted& /*event*/) const {
    prompt.notices.push_back(notice_screen(Notice::welcome, texts));
  }
  void operator()(const ReactionPressed& pressed) const { prompt.reaction.was_kept(pressed); }
  void operator()(const QuestionnaireAnswered& /*event*/) const { prompt.form.reset(); }
  void operator()(const ConsentGiven& /*event*/) const { prompt.form.reset(); }
  void operator()(const TrialStarted& /*event*/) const { prompt.timed_again = TimedAgain::no; }
  template <typename Other>
  void operator()(const Other& /*event*/) const {}
};

struct Preparing {
  PromptState& prompt;
  const SessionContext& context;
  Nanoseconds now;

  const Texts& texts() const { return context.protocol.texts; }

  void tell_what_comes() const {
    if (const std::optional<Notice> notice = notice_before_trial(context)) {
      prompt.notices.push_back(notice_screen(*notice, texts()));
    }
  }

  void operator()(const AskForConsent& /*effect*/) const {
    prompt.form.emplace(consent_form(texts()));
    prompt.form_of.clear();
  }
  void operator()(const AskQuestionnaire& effect) const {
    // After a pause, the answers so far are kept.
    if (!prompt.form || prompt.form_of != effect.questionnaire) {
      const Questionnaire& asks = questionnaire_of(context.protocol, effect.questionnaire);
      prompt.form.emplace(questionnaire_form(asks, texts()));
      prompt.form_of = effect.questionnaire;
    }
  }
  void operator()(const ValidateGaze& /*effect*/) const { prompt.validation.reset(); }
  void operator()(const AskForPress& /*effect*/) const {
    const int presses = context.protocol.reaction->presses;
    const bool is_first = context.seen.presses_left == presses;
    if (is_first && !prompt.reaction.was_early()) {
      prompt.notices.push_back(reaction_screen(presses, texts()));
    }
    prompt.reaction.ask();
  }
  void operator()(const AskForObject& /*effect*/) const { tell_what_comes(); }
  void operator()(const AskWhetherReady& /*effect*/) const {
    const auto& step = std::get<TrialStep>(context.procedure.agenda[context.seen.step]);
    if (!step.chooses_object) {
      tell_what_comes();
    }
  }
  void operator()(const AcknowledgeMark& /*effect*/) const {
    prompt.acknowledged_until = now + acknowledgement;
  }
  void operator()(const AskForRating& /*effect*/) const { prompt.wants_to_rate = false; }
  void operator()(const StopRendering& /*effect*/) const { prompt.form.reset(); }
  void operator()(const ShowPause& /*effect*/) const { prompt.notices.clear(); }
  void operator()(const EndSession& /*effect*/) const { prompt.notices.clear(); }
  void operator()(const StartRendering& /*effect*/) const {}
};

}  // namespace

void follow(PromptState& prompt, const Event& event, const SessionContext& context) {
  std::visit(Following{prompt, context.protocol.texts}, event);
}

void prepare(PromptState& prompt, const Effect& effect, const SessionContext& context,
             Nanoseconds now) {
  std::visit(Preparing{prompt, context, now}, effect);
}

bool begin_rating(PromptState& prompt, const Protocol& protocol, Nanoseconds now) {
  if (prompt.form || !prompt.wants_to_rate || now < prompt.look_around_until) {
    return false;
  }
  prompt.form.emplace(rating_form(protocol.ratings, protocol.texts));
  prompt.form_of.clear();
  return true;
}

void begin_validation(PromptState& prompt, const ValidationSettings& settings,
                      const ViewGeometry& geometry, Nanoseconds start) {
  if (!prompt.validation) {
    prompt.validation.emplace(settings, geometry.horizontal_fov_deg, geometry.vertical_fov_deg,
                              start);
  }
}

bool is_form_shown(const PromptState& prompt, Phase phase) {
  const bool asks =
      phase == Phase::consent || phase == Phase::questionnaire || phase == Phase::rating;
  return prompt.form && asks && !prompt.confirmation && prompt.notices.empty();
}

std::optional<Event> event_of_form(const PromptState& prompt, Phase phase,
                                   const Protocol& protocol) {
  if (phase == Phase::consent) {
    const bool agrees = prompt.form->answers().front().value == consent_answers().front().value;
    return agrees ? std::optional<Event>(consent_to(protocol)) : std::nullopt;
  }
  if (phase == Phase::rating) {
    return Rated{.answers = prompt.form->answers(), .looked_around = prompt.looked_around};
  }
  return QuestionnaireAnswered{prompt.form_of, prompt.form->answers()};
}

}  // namespace foveola::study
