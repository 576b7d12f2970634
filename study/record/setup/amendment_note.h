// A session that was run by a protocol whose words or time-outs were amended says so in its log.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace foveola::study {

/// Another text than the study was begun with, of the same design.
struct Amendment {
  std::string sha256;                ///< hash of the protocol's text
  std::vector<std::string> changed;  ///< keys; none if only comments or spaces did
  std::string text;
  /// The questionnaires' files that changed, by the names that the protocol has for them.
  std::map<std::string, std::string> files{};

  friend bool operator==(const Amendment&, const Amendment&) = default;
};

/// The session's note. Its first line names hash and keys, and holds the changed files; the text
/// follows to the letter.
std::string note_of(const Amendment& amendment);

/// What such a note says; empty if it is another note, or its text has another hash.
std::optional<Amendment> amendment_in(const std::string& note);

}  // namespace foveola::study
