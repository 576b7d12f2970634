#include "study/person/forms/missing_letters.h"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>

#include "renderer/base/text/print.h"
#include "renderer/base/text/utf8.h"

namespace foveola::study {
namespace {

void add_question(std::vector<ShownText>& texts, const std::string& form,
                  const Question& question) {
  const std::string key = fmt::format("{}.{}", form, question.id);
  texts.push_back({key, question.text});
  for (const std::string& label : question.labels) {
    texts.push_back({key, label});
  }
  for (const Option& option : question.options) {
    texts.push_back({key, option.label});
  }
}

bool is_private_use(char32_t character) { return character >= 0xE000 && character <= 0xF8FF; }

/// By Unicode blocks: radicals to Yi, Hangul, ideographs, full-width forms.
bool is_east_asian(char32_t character) {
  return (character >= 0x2E80 && character <= 0xA4CF) ||
         (character >= 0xAC00 && character <= 0xD7FF) ||
         (character >= 0xF900 && character <= 0xFAFF) ||
         (character >= 0xFE30 && character <= 0xFE4F) ||
         (character >= 0xFF00 && character <= 0xFFEF);
}

std::string remedy_for(const Characters& characters) {
  const auto is_nobodys = [](char32_t character) {
    return is_private_use(character) || character > 0xFFFF;
  };
  if (std::all_of(characters.begin(), characters.end(), is_nobodys)) {
    return "write it with other characters";
  }
  const bool east_asian = std::any_of(characters.begin(), characters.end(), is_east_asian);
  return fmt::format("install a font that has them, such as Debian's package {}",
                     east_asian ? "fonts-noto-cjk" : "fonts-noto-core");
}

}  // namespace

std::vector<ShownText> shown_texts(const Protocol& protocol) {
  std::vector<ShownText> texts;
  for (const auto& [id, words] : protocol.texts) {
    texts.push_back({"texts." + id, words});
  }
  for (const MarkEntry& mark : protocol.marks) {
    texts.push_back({"mark." + mark.id, mark.instruction});
  }
  for (const Question& rating : protocol.ratings) {
    add_question(texts, "rating", rating);
  }
  for (const Questionnaire& questionnaire : protocol.questionnaires) {
    const std::string key = "questionnaire." + questionnaire.id;
    texts.push_back({key, questionnaire.title});
    texts.push_back({key, questionnaire.intro});
    for (const Question& question : questionnaire.questions) {
      add_question(texts, key, question);
    }
  }
  return texts;
}

std::vector<MissingLetters> missing_letters(const Protocol& protocol) {
  std::vector<ShownText> texts = shown_texts(protocol);
  std::string everything;
  for (const ShownText& text : texts) {
    everything += text.words;
  }
  const Characters missing = characters_without_font(everything);
  std::vector<MissingLetters> found;
  for (const ShownText& text : texts) {
    Characters here = characters_of(text.words);
    std::erase_if(here, [&](char32_t character) { return !missing.contains(character); });
    if (here.empty()) {
      continue;
    }
    if (found.empty() || found.back().key != text.key) {
      found.push_back({text.key, {}});
    }
    found.back().characters.merge(here);
  }
  return found;
}

std::string warning_of(const MissingLetters& missing) {
  std::string names;
  for (const char32_t character : missing.characters) {
    names += names.empty() ? "" : ", ";
    append_character(names, character);
    names += fmt::format(" (U+{:04X})", static_cast<std::uint32_t>(character));
  }
  return fmt::format("{}: no font here has {}, shown as a question mark; {}", missing.key, names,
                     remedy_for(missing.characters));
}

void warn_of_missing_letters(const Protocol& protocol) {
  for (const MissingLetters& missing : missing_letters(protocol)) {
    print_text(stderr, "foveola: warning: {}\n",
               printable(protocol.path.string() + ": " + warning_of(missing)));
  }
}

}  // namespace foveola::study
