#include "study/person/asked.h"

namespace foveola::study {
namespace {

constexpr Nanoseconds acknowledgement = std::chrono::milliseconds(900);

/// What each event leaves behind; most leave nothing.
struct Following {
  Asked& asked;
  const Texts& texts;

  void operator()(const SessionStarted& /*event*/) const {
    asked.notices.push_back(notice_screen(Notice::welcome, texts));
  }
  void operator()(const ReactionPressed& pressed) const { asked.reaction.was_kept(pressed); }
  void operator()(const QuestionnaireAnswered& /*event*/) const { asked.form.reset(); }
  void operator()(const ConsentGiven& /*event*/) const { asked.form.reset(); }
  template <typename Other>
  void operator()(const Other& /*event*/) const {}
};

/// What each effect asks for.
struct Preparing {
  Asked& asked;
  const Standing& standing;
  Nanoseconds now;

  const Texts& texts() const { return standing.protocol.texts; }

  void tell_what_comes() const {
    if (const std::optional<Notice> notice = notice_before_trial(standing)) {
      asked.notices.push_back(notice_screen(*notice, texts()));
    }
  }

  void operator()(const AskForConsent& /*effect*/) const {
    asked.form.emplace(consent_form(texts()));
    asked.form_of.clear();
  }
  void operator()(const AskQuestionnaire& effect) const {
    // After a pause the answers so far are still there.
    if (!asked.form || asked.form_of != effect.questionnaire) {
      const Questionnaire& asks = questionnaire_of(standing.protocol, effect.questionnaire);
      asked.form.emplace(questionnaire_form(asks, texts()));
      asked.form_of = effect.questionnaire;
    }
  }
  void operator()(const ValidateGaze& /*effect*/) const { asked.validation.reset(); }
  void operator()(const AskForPress& /*effect*/) const {
    const int presses = standing.protocol.reaction->presses;
    const bool is_first = standing.seen.presses_left == presses;
    if (is_first && !asked.reaction.was_early()) {
      asked.notices.push_back(reaction_screen(presses, texts()));
    }
    asked.reaction.ask();
  }
  void operator()(const AskForObject& /*effect*/) const { tell_what_comes(); }
  void operator()(const AskWhetherReady& /*effect*/) const {
    const auto& step = std::get<TrialStep>(standing.procedure.agenda[standing.seen.step]);
    if (!step.chooses_object) {
      tell_what_comes();
    }
  }
  void operator()(const AcknowledgeMark& /*effect*/) const {
    asked.acknowledged_until = now + acknowledgement;
  }
  void operator()(const AskForRating& /*effect*/) const {
    const PlannedTrial& rated = trial_at(standing);
    const Timing timing = settings_of(standing.protocol, rated.scene, rated.method).timing;
    asked.wants_to_rate = false;
    asked.look_around_until = now + nanoseconds_from_seconds(timing.rating_s);
  }
  void operator()(const StopRendering& /*effect*/) const { asked.form.reset(); }
  void operator()(const ShowPause& /*effect*/) const { asked.notices.clear(); }
  void operator()(const EndSession& /*effect*/) const { asked.notices.clear(); }
  void operator()(const StartRendering& /*effect*/) const {}
};

}  // namespace

void follow(Asked& asked, const Event& event, const Standing& standing) {
  std::visit(Following{asked, standing.protocol.texts}, event);
}

void prepare(Asked& asked, const Effect& effect, const Standing& standing, Nanoseconds now) {
  std::visit(Preparing{asked, standing, now}, effect);
}

bool begin_rating(Asked& asked, const Protocol& protocol, Nanoseconds now) {
  if (asked.form || !asked.wants_to_rate || now < asked.look_around_until) {
    return false;
  }
  asked.form.emplace(rating_form(protocol.ratings, protocol.texts));
  asked.form_of.clear();
  return true;
}

void begin_validation(Asked& asked, const ValidationSettings& settings,
                      const ViewGeometry& geometry, Nanoseconds start) {
  if (!asked.validation) {
    asked.validation.emplace(settings, geometry.horizontal_fov_deg, geometry.vertical_fov_deg,
                             start);
  }
}

bool is_form_shown(const Asked& asked, Phase phase) {
  const bool asks =
      phase == Phase::consent || phase == Phase::questionnaire || phase == Phase::rating;
  return asked.form && asks && !asked.doubt && asked.notices.empty();
}

Event event_of_form(const Asked& asked, Phase phase) {
  if (phase == Phase::consent) {
    return ConsentGiven{};
  }
  if (phase == Phase::rating) {
    return Rated{asked.form->answers()};
  }
  return QuestionnaireAnswered{asked.form_of, asked.form->answers()};
}

}  // namespace foveola::study
