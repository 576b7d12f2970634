// What the live preview tells its user for a while.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "renderer/base/clock.h"

namespace foveola {

/// How long a message stays, chosen by judgement.
enum class MessageStay {
  briefly,      ///< 4 s: what a key did
  long_enough,  ///< 15 s: what the user did not ask for
  until_key     ///< until the next key: what the user waits for, and may not look at just then
};

class PreviewMessages {
 public:
  void tell(Nanoseconds now, std::string text, MessageStay stay = MessageStay::briefly);

  /// A key was pressed: what waits for one goes.
  void answer_key();

  /// Those that still stay at `now`, the oldest first; at most the newest four.
  std::vector<std::string> lines(Nanoseconds now) const;

 private:
  struct Message {
    std::string text;
    std::optional<Nanoseconds> end;  ///< empty: the next key
  };
  std::vector<Message> messages_;
};

}  // namespace foveola
