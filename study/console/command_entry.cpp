#include "study/console/command_entry.h"

#include <utility>

#include "renderer/base/utf8.h"

namespace foveola::study {

std::optional<EnteredLine> CommandEntry::follow(const TypedKey& key) {
  switch (key.kind) {
    case TypedKey::Kind::character:
      append_character(line_.text, key.character);
      break;
    case TypedKey::Kind::enter:
      if (!key.is_pasted) {
        return std::exchange(line_, {});
      }
      append_character(line_.text, U' ');
      break;
    case TypedKey::Kind::erase:
      erase_last_character(line_.text);
      break;
    case TypedKey::Kind::escape:
      line_.text.clear();
      break;
  }
  line_.is_pasted = !line_.text.empty() && (line_.is_pasted || key.is_pasted);
  return std::nullopt;
}

}  // namespace foveola::study
