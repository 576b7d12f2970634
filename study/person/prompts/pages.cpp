#include "study/person/prompts/pages.h"

#include <fmt/format.h>

namespace foveola::study {
namespace {

ScreenPage page_of_validation(const SessionContext& context) {
  const int attempts = context.protocol.tracker.validation->attempts;
  const bool is_first = context.seen.validations_left == attempts;
  return notice_screen(is_first ? Notice::validation : Notice::validation_again,
                       context.protocol.texts);
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

ScreenPage page_before_trial(const PromptState& prompt, const SessionContext& context) {
  const std::size_t trial = *trial_of(context.procedure, context.seen);
  const bool was_timed = context.seen.timing > 1;
  const bool says_why = prompt.timed_again != TimedAgain::no;
  return ready_screen(context.protocol.marks,
                      {.object = prompt.object,
                       .count = trial_count(context.plan, trial),
                       .again = !was_timed ? TimedAgain::no
                                : says_why ? prompt.timed_again
                                           : TimedAgain::asked_for},
                      context.protocol.texts);
}

ScreenPage page_of_rating(const PromptState& prompt, const Protocol& protocol, bool acknowledges) {
  if (prompt.form) {
    return prompt.form->screen();
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

std::optional<ScreenPage> page_of_phase(const PromptState& prompt, const SessionContext& context,
                                        Nanoseconds now) {
  const Protocol& protocol = context.protocol;
  const SessionState& seen = context.seen;
  const bool acknowledges = now < prompt.acknowledged_until;
  switch (seen.phase) {
    case Phase::created:
    case Phase::interrupted:
      return notice_screen(Notice::loading, protocol.texts);
    case Phase::consent:
    case Phase::questionnaire:
      return prompt.form->screen();
    case Phase::validation:
      return prompt.validation ? std::nullopt : std::optional(page_of_validation(context));
    case Phase::reaction:
      return page_of_reaction(prompt.reaction.look(), protocol.texts);
    case Phase::choosing_object:
      return choosing_screen(prompt.object, protocol.texts);
    case Phase::ready:
      return page_before_trial(prompt, context);
    case Phase::armed:
      return prompt.awaits_gaze ? std::optional(no_gaze_screen(protocol.texts)) : std::nullopt;
    case Phase::marking:
      return acknowledges ? std::optional(
                                mark_taken_screen(seen.mark, protocol.marks.size(), protocol.texts))
                          : std::nullopt;
    case Phase::rating:
      return page_of_rating(prompt, protocol, acknowledges);
    default:
      return page_of_end(seen.phase, protocol.texts);
  }
}

std::optional<ScreenPage> page_without_progress(const PromptState& prompt,
                                                const SessionContext& context, Nanoseconds now) {
  if (prompt.confirmation) {
    return prompt.confirmation->screen(context.protocol.texts);
  }
  return prompt.notices.empty() ? page_of_phase(prompt, context, now) : prompt.notices.front();
}

}  // namespace

std::optional<ScreenPage> page_of(const PromptState& prompt, const SessionContext& context,
                                  Nanoseconds now) {
  std::optional<ScreenPage> page = page_without_progress(prompt, context, now);
  if (page && page->covers_picture && !page->is_signal) {
    page->progress = static_cast<double>(context.seen.step) /
                     static_cast<double>(context.procedure.agenda.size());
  }
  return page;
}

std::string words_for_next_key(const PromptState& prompt, const SessionContext& context,
                               Nanoseconds now) {
  const std::optional<ScreenPage> page = page_of(prompt, context, now);
  if (page && !page->keys.empty()) {
    return page->keys;
  }
  if (context.seen.phase == Phase::marking) {
    return fmt::format("[Space] {}", context.protocol.marks[context.seen.mark].id);
  }
  return context.seen.is_over() ? "[Enter] closes the window" : "none";
}

}  // namespace foveola::study
