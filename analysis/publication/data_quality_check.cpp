#include "analysis/publication/data_quality_check.h"

#include <algorithm>
#include <span>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"

namespace foveola::analysis {
namespace {

/// Each participant once, in the findings' order.
std::vector<std::string> participants_of(std::span<const Finding> findings) {
  std::vector<std::string> participants;
  for (const Finding& finding : findings) {
    if (std::ranges::find(participants, finding.participant) == participants.end()) {
      participants.push_back(finding.participant);
    }
  }
  return participants;
}

}  // namespace

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::passed:
      return "passed";
    case Verdict::flagged:
      return "flagged";
    case Verdict::unknown:
      break;
  }
  return "not recorded";
}

Verdict within(bool good) { return good ? Verdict::passed : Verdict::flagged; }

std::string findings_in_words(const std::vector<Finding>& findings) {
  constexpr std::size_t most_told = 5;
  const std::span<const Finding> all(findings);
  const std::size_t told = std::min(most_told, all.size());
  std::string text;
  for (const Finding& finding : all.first(told)) {
    text += (text.empty() ? "" : "; ") + finding.words;
  }
  const std::span<const Finding> others = all.subspan(told);
  return others.empty() ? text
                        : fmt::format("{}; and {} of {}", text, counted(others.size(), "other"),
                                      listed(participants_of(others)));
}

std::string colon_and_findings(const std::vector<Finding>& findings) {
  return findings.empty() ? "" : ": " + findings_in_words(findings);
}

}  // namespace foveola::analysis
