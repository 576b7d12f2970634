#include "study/protocol/texts.h"

#include <algorithm>
#include <cassert>

#include "renderer/base/transformed.h"
#include "study/protocol/built_in_texts.h"

namespace foveola::study {
namespace {

/// Returns null if there is none.
const BuiltInText* find_built_in(std::string_view id) {
  const std::span<const BuiltInText> all = built_in_texts();
  const auto found = std::ranges::find(all, id, &BuiltInText::id);
  return found != all.end() ? &*found : nullptr;
}

}  // namespace

std::vector<std::string> known_text_ids() {
  return transformed<std::string>(built_in_texts(), &BuiltInText::id);
}

std::string text_of(const Texts& texts, std::string_view id) {
  if (const auto replaced = texts.find(std::string(id)); replaced != texts.end()) {
    return replaced->second;
  }
  const BuiltInText* const known = find_built_in(id);
  assert(known != nullptr);
  return std::string(known->english);
}

Texts texts_in_headset(Texts texts) {
  for (const BuiltInText& text : built_in_texts_in_headset()) {
    texts.try_emplace(std::string(text.id), text.english);
  }
  return texts;
}

std::vector<std::string> names_in(std::string_view text) {
  std::vector<std::string> names;
  for (std::size_t open = text.find('{'); open != std::string_view::npos;
       open = text.find('{', open + 1)) {
    const std::size_t close = text.find('}', open);
    if (close == std::string_view::npos) {
      break;
    }
    names.emplace_back(text.substr(open + 1, close - open - 1));
  }
  return names;
}

std::string filled(std::string_view text,
                   const std::vector<std::pair<std::string_view, std::string>>& values) {
  std::string result;
  while (!text.empty()) {
    const std::size_t open = std::min(text.find('{'), text.size());
    result += text.substr(0, open);
    text.remove_prefix(open);
    const std::size_t close = text.find('}');
    const auto value = std::ranges::find_if(values, [&](const auto& known) {
      return close != std::string_view::npos && known.first == text.substr(1, close - 1);
    });
    const bool is_known = value != values.end();
    const std::size_t used = is_known ? close + 1 : std::min<std::size_t>(1, text.size());
    result += is_known ? value->second : std::string(text.substr(0, used));
    text.remove_prefix(used);
  }
  return result;
}

}  // namespace foveola::study
