#include "study/person/pages.h"

namespace foveola::study {
namespace {

ScreenPage page_of_doubt(Doubt doubt, const Texts& texts) {
  return doubt == Doubt::timing_again ? retiming_screen(texts)
                                      : notice_screen(Notice::stopping, texts);
}

ScreenPage page_of_validation(const Standing& standing) {
  const int attempts = standing.protocol.tracker.validation->attempts;
  const bool is_first = standing.seen.validations_left == attempts;
  return notice_screen(is_first ? Notice::validation : Notice::validation_again,
                       standing.protocol.texts);
}

ScreenPage page_of_reaction(ReactionLook look, const Texts& texts) {
  switch (look) {
    case ReactionLook::appeared:
      return reaction_now_screen(texts);
    case ReactionLook::waiting_again:
      return reaction_early_screen(texts);
    case ReactionLook::waiting:
      break;
  }
  return reaction_wait_screen(texts);
}

ScreenPage page_before_trial(const Standing& standing) {
  const std::size_t trial = *trial_of(standing.procedure, standing.seen);
  return ready_screen(standing.protocol.marks, trial_count(standing.plan, trial),
                      standing.seen.timing > 1, standing.protocol.texts);
}

ScreenPage page_of_rating(const Asked& asked, const Protocol& protocol, bool acknowledges) {
  if (asked.form) {
    return asked.form->screen();
  }
  const std::size_t marks = protocol.marks.size();
  return acknowledges ? mark_taken_screen(marks, marks, protocol.texts)
                      : look_around_screen(protocol.texts);
}

ScreenPage page_of_end(Phase phase, const Texts& texts) {
  switch (phase) {
    case Phase::paused:
      return notice_screen(Notice::pause, texts);
    case Phase::completed:
      return notice_screen(Notice::goodbye, texts);
    case Phase::withdrawn:
      return notice_screen(Notice::withdrawn, texts);
    case Phase::refused:
      return notice_screen(Notice::refused, texts);
    default:
      return notice_screen(Notice::interrupted, texts);
  }
}

std::optional<ScreenPage> page_of_phase(const Asked& asked, const Standing& standing,
                                        Nanoseconds now) {
  const Protocol& protocol = standing.protocol;
  const SessionState& seen = standing.seen;
  const bool acknowledges = now < asked.acknowledged_until;
  switch (seen.phase) {
    case Phase::created:
    case Phase::interrupted:
      return notice_screen(Notice::loading, protocol.texts);
    case Phase::consent:
    case Phase::questionnaire:
      return asked.form->screen();
    case Phase::validation:
      return asked.validation ? std::nullopt : std::optional(page_of_validation(standing));
    case Phase::reaction:
      return page_of_reaction(asked.reaction.look(), protocol.texts);
    case Phase::choosing_object:
      return choosing_screen(protocol.texts);
    case Phase::ready:
      return page_before_trial(standing);
    case Phase::armed:
      return asked.awaits_gaze ? std::optional(no_gaze_screen(protocol.texts)) : std::nullopt;
    case Phase::marking:
      return acknowledges ? std::optional(
                                mark_taken_screen(seen.mark, protocol.marks.size(), protocol.texts))
                          : std::nullopt;
    case Phase::rating:
      return page_of_rating(asked, protocol, acknowledges);
    default:
      return page_of_end(seen.phase, protocol.texts);
  }
}

std::optional<ScreenPage> page_without_progress(const Asked& asked, const Standing& standing,
                                                Nanoseconds now) {
  if (asked.doubt) {
    return page_of_doubt(*asked.doubt, standing.protocol.texts);
  }
  return asked.notices.empty() ? page_of_phase(asked, standing, now) : asked.notices.front();
}

}  // namespace

std::optional<ScreenPage> page_of(const Asked& asked, const Standing& standing, Nanoseconds now) {
  std::optional<ScreenPage> page = page_without_progress(asked, standing, now);
  if (page && page->covers_picture && !page->is_signal) {
    page->progress = static_cast<double>(standing.seen.step) /
                     static_cast<double>(standing.procedure.agenda.size());
  }
  return page;
}

}  // namespace foveola::study
