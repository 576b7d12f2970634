#include "study/person/person_session.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "renderer/preview/direct_panorama.h"
#include "study/person/console_words.h"

namespace foveola::study {
namespace {

/// Enough to know an object by, and a second's work.
constexpr IVec2 largest_panorama{2048, 1024};

constexpr Nanoseconds acknowledgement = std::chrono::milliseconds(900);

IVec2 panorama_size(const FilmSettings& film) {
  return film.width <= largest_panorama.x ? IVec2(film.width, film.height) : largest_panorama;
}

}  // namespace

PersonSession::PersonSession(const PersonSessionSettings& settings, const Parts& parts)
    : settings_(settings),
      parts_(parts),
      zero_(parts.clock->now() - settings.time),
      log_(procedure_of(*parts.protocol, *parts.plan), settings.state,
           [this](Nanoseconds time, const Event& event, const SessionState& before,
                  const SessionState& after) {
             return parts_.record->event(settings_.session, time, event, before, after);
           }),
      seen_(settings.state),
      waits_(derive_seed(settings.seed, SeedPurpose::waiting, {settings.state.presses_left})) {
  parts_.eye->correct(settings.correction);
  begin_viewing({});
}

Phase PersonSession::run(const std::stop_token& stop) {
  begin();
  while (!is_done_) {
    show_frame();
    answer_window();
    for (const DurableEvent& durable : log_.take_durable()) {
      carry_out(durable);
    }
    if (stop.stop_requested()) {
      interrupt();
    } else {
      answer_console();
    }
  }
  return log_.state().phase;
}

void PersonSession::begin() {
  // By this, what else was recorded on the machine can be laid beside the session.
  parts_.tell(
      fmt::format("Session time 0 is {:.9f} s of this machine's monotonic clock.", seconds(zero_)));
  if (log_.state().phase == Phase::created) {
    feed(SessionStarted{});
    return;
  }
  if (log_.state().phase != Phase::interrupted) {
    feed(Interrupted{});  // it died before it could say so
  }
  feed(NoteWritten{"goes on with " + settings_.devices});
  feed(Resumed{});
}

void PersonSession::interrupt() {
  is_done_ = true;
  for (const DurableEvent& durable : log_.wait_for_all()) {
    carry_out(durable);
  }
  feed(Interrupted{});
  for (const DurableEvent& durable : log_.wait_for_all()) {
    carry_out(durable);
  }
}

void PersonSession::carry_out(const DurableEvent& durable) {
  parts_.tell(fmt::format("{:9.3f} s  {}", seconds(durable.time), words_for(durable.event)));
  seen_ = durable.after;
  follow(durable.event);
  for (const Effect& effect : durable.effects) {
    std::visit([this](const auto& one) { carry_out(one); }, effect);
  }
  if (!durable.effects.empty()) {
    doubt_.reset();
    show_new_page();
  }
}

void PersonSession::follow(const Event& event) {
  if (std::holds_alternative<SessionStarted>(event)) {
    give_notice(Notice::welcome);
  } else if (const auto* validated = std::get_if<GazeValidated>(&event)) {
    parts_.eye->correct(correction_after(*validated));
  } else if (const auto* pressed = std::get_if<ReactionPressed>(&event)) {
    was_false_start_ = pressed->time < pressed->shown;
  } else if (std::holds_alternative<QuestionnaireAnswered>(event) ||
             std::holds_alternative<ConsentGiven>(event)) {
    form_.reset();
  }
}

void PersonSession::carry_out(const AskForConsent& /*effect*/) {
  form_.emplace(consent_form(texts()));
  form_of_.clear();
}

void PersonSession::carry_out(const AskQuestionnaire& effect) {
  // After a pause the answers so far are still there.
  if (!form_ || form_of_ != effect.questionnaire) {
    form_.emplace(
        questionnaire_form(questionnaire_of(*parts_.protocol, effect.questionnaire), texts()));
    form_of_ = effect.questionnaire;
  }
}

void PersonSession::carry_out(const ValidateGaze& /*effect*/) { validation_.reset(); }

void PersonSession::carry_out(const AskForPress& /*effect*/) {
  reaction_.reset();
  const bool is_first = seen_.presses_left == parts_.protocol->reaction->presses;
  if (is_first && !was_false_start_) {
    notices_.push_back(reaction_screen(parts_.protocol->reaction->presses, texts()));
  }
}

void PersonSession::carry_out(const AskForObject& /*effect*/) {
  tell_what_comes();
  enter_scene();
}

void PersonSession::carry_out(const AskWhetherReady& /*effect*/) {
  const auto& step = std::get<TrialStep>(log_.procedure().agenda[seen_.step]);
  if (!step.chooses_object) {
    tell_what_comes();
  }
  enter_scene();
}

void PersonSession::tell_what_comes() {
  const std::size_t index = *trial_of(log_.procedure(), seen_);
  const bool is_practice = trial().kind == TrialKind::practice;
  if (seen_.attempt > 1) {
    return;
  }
  if (index == 0) {
    if (is_practice) {
      give_notice(Notice::practice);
    }
    return;
  }
  const PlannedTrial& before = (*parts_.plan)[index - 1];
  if (before.kind == TrialKind::practice && !is_practice) {
    give_notice(Notice::first_trial);
  } else if (before.scene != trial().scene) {
    give_notice(Notice::next_scene);
  }
}

void PersonSession::carry_out(const StartRendering& /*effect*/) {
  const std::size_t index = *trial_of(log_.procedure(), seen_);
  const int attempt = seen_.attempt;
  RecordThread& record = *parts_.record;
  const std::int64_t session = settings_.session;
  attempt_ = std::make_unique<LiveAttempt>(AttemptSetting{
      .protocol = parts_.protocol,
      .stage = &stage(),
      .workers = parts_.workers,
      .clock = parts_.clock,
      .display = parts_.display,
      .eye = parts_.eye,
      .head = &viewer_->head,
      .trial = trial(),
      .seed = rendering_seed(settings_.seed.seed, settings_.seed.design_row, *parts_.protocol,
                             trial(), seen_.timing),
      .session_zero = zero_,
      .sink = {.frames =
                   [&record, session, index, attempt](std::uint64_t first,
                                                      std::vector<FrameRow> frames) {
                     record.frames(session, index, attempt, first, std::move(frames));
                   },
               .gaze =
                   [&record, session, index, attempt](std::uint64_t first,
                                                      std::vector<GazeSample> samples) {
                     record.gaze(session, index, attempt, first, std::move(samples));
                   }},
      .keep_film_hash =
          [&record, session, index, attempt](FilmHash hash) {
            record.film_hash(session, index, attempt, std::move(hash));
          },
      .while_waiting = [this] { answer_window(); },
      .page = [this] { return page(); }});
}

void PersonSession::carry_out(const AcknowledgeMark& /*effect*/) {
  acknowledged_until_ = now() + acknowledgement;
}

void PersonSession::carry_out(const AskForRating& /*effect*/) {
  wants_to_rate_ = false;
  const PlannedTrial& rated = trial();
  look_around_until_ =
      now() + nanoseconds_from_seconds(
                  settings_of(*parts_.protocol, rated.scene, rated.method).timing.rating_s);
}

void PersonSession::carry_out(const StopRendering& /*effect*/) {
  // There is none if it was another program's, which died.
  if (attempt_) {
    attempt_->finish();
    attempt_.reset();
  }
  form_.reset();
}

void PersonSession::carry_out(const ShowPause& /*effect*/) { notices_.clear(); }

void PersonSession::carry_out(const EndSession& /*effect*/) {
  notices_.clear();
  if (seen_.is_over()) {
    parts_.tell("The session is over. Enter in the window, or quit here, closes it.");
  }
}

void PersonSession::enter_scene() {
  const std::string& scene = trial().scene;
  if (scene != scene_) {
    scene_ = scene;
    parts_.display->show_no_film();
    parts_.display->show({.screen = notice_screen(Notice::loading, texts())});
    begin_viewing(stage().source().heading);
    const IVec2 size = panorama_size(settings_of(*parts_.protocol, scene, trial().method).film);
    panorama_ = std::make_unique<EquirectFilm>(size.x, size.y);
    show_direct_shading(stage().scene(), stage().tracer().ray_scene(), stage().viewpoint(),
                        *panorama_, *parts_.workers);
  }
  parts_.display->show_film(*panorama_);
}

void PersonSession::begin_viewing(const AzimuthElevation& heading) {
  viewer_ = std::make_unique<Viewer>(heading, parts_.pointer);
  viewer_->steering.show(parts_.display->geometry(), parts_.display->framebuffer(),
                         pixels_per_unit_);
}

const PlannedTrial& PersonSession::trial() const {
  const std::optional<std::size_t> index = trial_of(log_.procedure(), seen_);
  if (!index) {
    throw std::logic_error(std::string("no trial belongs to the phase ") + name_of(seen_.phase));
  }
  return (*parts_.plan)[*index];
}

}  // namespace foveola::study
