// Classifies changes of a protocol with recorded sessions: texts and time-outs may change, the
// design may not.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace foveola::study {

/// Keys in which two texts of a protocol differ, as "timing.rating_s" or "mark[0].instruction", in
/// alphabetical order. Comments and spaces are ignored.
struct ProtocolChanges {
  /// Keys among title, language and texts; instructions, questions, labels and titles of forms;
  /// [timing], also in overrides, and the catch trials' time-out. An option's label is among them
  /// only if the option has a value, since otherwise the label is recorded.
  std::vector<std::string> of_words_and_times;
  std::vector<std::string> of_design;  ///< All other keys.
};

/// Compares two texts of a protocol. `path`: of both texts, for messages. Throws Error if one of
/// the texts is not TOML.
ProtocolChanges changes_between(const std::string& before, const std::string& after,
                                const std::filesystem::path& path);

/// Compares two texts of a questionnaire's file that the protocol names, as "ssq.toml:
/// question[0].text".
ProtocolChanges changes_of_questionnaire(const std::string& before, const std::string& after,
                                         const std::string& name);

}  // namespace foveola::study
