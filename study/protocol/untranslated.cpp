#include "study/protocol/untranslated.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "renderer/gaze/profiles.h"
#include "study/protocol/built_in_texts.h"
#include "study/protocol/protocol_places.h"

namespace foveola::study {
namespace {

bool is_english(const std::string& language) {
  std::string tag = language.substr(0, language.find('-'));
  std::transform(tag.begin(), tag.end(), tag.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return tag == "en" || tag == "eng";
}

/// Returns whether a text has letters outside of its names in braces.
bool has_words(std::string_view text) {
  bool is_name = false;
  return std::ranges::any_of(text, [&](unsigned char letter) {
    is_name = letter == '{' || (is_name && letter != '}');
    return !is_name && std::isalpha(letter) != 0;
  });
}

}  // namespace

UntranslatedTexts untranslated_texts(const Protocol& protocol) {
  UntranslatedTexts texts;
  if (is_english(protocol.language)) {
    return texts;
  }
  const auto add = [&](const std::string& key, bool is_translated) {
    ++texts.of;
    if (!is_translated) {
      texts.keys.push_back(key);
    }
  };
  for (const BuiltInText& text : built_in_texts()) {
    if (has_words(text.english)) {
      const std::string id(text.id);
      add("texts." + id, protocol.texts.contains(id));
    }
  }
  const ProtocolPlaces places(protocol);
  for (const char* key : {"mark", "rating"}) {
    add(key, places.has(key));
  }
  for (std::size_t i = 0; i < protocol.questionnaires.size(); ++i) {
    const std::string& file = protocol.questionnaires[i].file;
    if (!file.empty()) {
      add(fmt::format("questionnaire[{}].file", i), is_profile_path(file));
    }
  }
  return texts;
}

}  // namespace foveola::study
