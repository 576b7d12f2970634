// The changes that a protocol with recorded sessions allows: words and time-outs, never the design.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace foveola::study {

/// The keys in which two texts of a protocol differ, as "timing.rating_s" or
/// "mark[0].instruction", in alphabetical order. Comments and spaces make no difference.
struct ProtocolChanges {
  /// Keys among title, language and texts; instructions, questions, labels and titles of forms;
  /// [timing], also in overrides, and the catch trials' time-out. An option's label is one of them
  /// only if the option has a value, since otherwise the label is what is recorded.
  std::vector<std::string> of_words_and_times;
  std::vector<std::string> of_design;  ///< All other keys.
};

/// `path` is that of both texts, for messages. Throws Error if one of the texts is no TOML.
ProtocolChanges changes_between(const std::string& before, const std::string& after,
                                const std::filesystem::path& path);

/// The same of a ready questionnaire's file that the protocol names, as "ssq.toml:
/// question[0].text".
ProtocolChanges changes_of_questionnaire(const std::string& before, const std::string& after,
                                         const std::string& name);

}  // namespace foveola::study
