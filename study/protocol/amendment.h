// What may change in a protocol that has sessions already: words and time-outs, never the design.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace foveola::study {

/// The keys in which two texts of a protocol differ, as "timing.rating_s" or
/// "mark[0].instruction", in alphabetical order. Comments and spaces are none.
struct ProtocolChanges {
  /// title, language, texts; instructions, questions, labels and titles of forms; [timing], of
  /// overrides too, and the catch trials' time-out. An option's label only if the option has a
  /// value: without, the label is what is recorded.
  std::vector<std::string> of_words_and_times;
  std::vector<std::string> of_design;  ///< all others
};

/// path: of both, for messages. Throws Error if one of the texts is no TOML.
ProtocolChanges changes_between(const std::string& before, const std::string& after,
                                const std::filesystem::path& path);

}  // namespace foveola::study
