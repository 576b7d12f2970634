// One data-quality check: what was found, beside its limit, and the verdict.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace foveola::analysis {

enum class Verdict { passed, flagged, unknown };

/// "passed", "flagged", "not recorded".
std::string_view name_of(Verdict verdict);

/// Passed if it is good, else flagged.
Verdict within(bool good);

struct DataQualityCheck {
  std::string name;
  std::string found;  ///< The value found, in words, with its unit.
  std::string limit;  ///< The limit, and its source.
  Verdict verdict = Verdict::unknown;
};

/// Something that a check found of one participant.
struct Finding {
  std::string participant;
  std::string words;  ///< Begins with the participant's code.
};

/// The first few of them, then how many others there are, and of whom: nobody goes unnamed. Empty
/// if there are none.
std::string findings_in_words(const std::vector<Finding>& findings);

/// ": " and findings_in_words; empty if there are none.
std::string colon_and_findings(const std::vector<Finding>& findings);

}  // namespace foveola::analysis
