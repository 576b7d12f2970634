#include "study/console/key_prompt.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/utf8.h"

namespace foveola::study {
namespace {

/// What comes before the command.
enum class Before { nothing, confirmation, text };

struct CommandKey {
  char32_t key;
  std::string_view command;
  std::string_view does;
  Before before;
  std::string_view question;
};

constexpr std::array keys = {
    CommandKey{U'p', "pause", "pauses, and goes on; a trial that has begun is timed again after it",
               Before::nothing, ""},
    CommandKey{U'r', "retime", "the timing failed: the method is timed again", Before::confirmation,
               "Time this method again?"},
    CommandKey{U'n', "note", "keeps a note in the record", Before::text, "A note for the record:"},
    CommandKey{U'x', "exclude", "ends the session, whose data stay, for a reason", Before::text,
               "The session ends and its data stay; exclude it because of:"},
    CommandKey{U'w', "withdraw", "the participant stops taking part", Before::confirmation,
               "Does the participant stop taking part? The session ends."},
    CommandKey{U'q', "quit", "interrupts the session; --resume goes on later", Before::confirmation,
               "Interrupt the session? It goes on later with --resume."},
};

}  // namespace

std::optional<std::string> KeyPrompt::follow(const TypedKey& key, bool is_paused) {
  if (!asked_) {
    return key.kind == TypedKey::Kind::character ? begin(key.character, is_paused) : std::nullopt;
  }
  switch (key.kind) {
    case TypedKey::Kind::escape:
      asked_.reset();
      break;
    case TypedKey::Kind::enter:
      return end();
    case TypedKey::Kind::erase:
      erase_last_character(asked_->text);
      break;
    case TypedKey::Kind::character:
      if (asked_->takes_text) {
        append_character(asked_->text, key.character);
      }
      break;
  }
  return std::nullopt;
}

std::string KeyPrompt::question() const {
  if (!asked_) {
    return {};
  }
  return asked_->takes_text ? fmt::format("{} {}_   (Enter keeps it, Escape lets it go)",
                                          asked_->question, asked_->text)
                            : fmt::format("{}   (Enter: yes, Escape: no)", asked_->question);
}

std::optional<std::string> KeyPrompt::begin(char32_t key, bool is_paused) {
  const auto* const known =
      std::find_if(keys.begin(), keys.end(), [&](const CommandKey& one) { return one.key == key; });
  if (known == keys.end()) {
    return std::nullopt;
  }
  if (known->before == Before::nothing) {
    return is_paused ? "resume" : std::string(known->command);
  }
  asked_ = Asked{.command = std::string(known->command),
                 .question = std::string(known->question),
                 .takes_text = known->before == Before::text};
  return std::nullopt;
}

std::optional<std::string> KeyPrompt::end() {
  const Asked asked = *std::exchange(asked_, std::nullopt);
  if (!asked.takes_text) {
    return asked.command;
  }
  return asked.text.empty() ? std::nullopt
                            : std::optional(fmt::format("{} {}", asked.command, asked.text));
}

std::string key_names(bool is_paused) {
  std::string names;
  for (const CommandKey& one : keys) {
    const bool ends_pause = one.before == Before::nothing && is_paused;
    names += fmt::format("{} {}   ", static_cast<char>(one.key),
                         ends_pause ? std::string_view("resume") : one.command);
  }
  return names + "? help";
}

std::vector<std::string> key_help() {
  std::vector<std::string> help;
  for (const CommandKey& one : keys) {
    help.push_back(fmt::format("{}  {}", static_cast<char>(one.key), one.does));
  }
  return help;
}

}  // namespace foveola::study
