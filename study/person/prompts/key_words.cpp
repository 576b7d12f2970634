#include "study/person/prompts/key_words.h"

#include <fmt/format.h>

#include "study/person/prompts/pages.h"

namespace foveola::study {

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
