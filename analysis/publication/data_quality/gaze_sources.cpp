#include "analysis/publication/data_quality/gaze_sources.h"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"

namespace foveola::analysis {

bool is_pointer(const std::string& tracker) { return tracker == "pointer"; }

std::string tracker_in_words(const std::string& tracker) {
  return is_pointer(tracker)      ? "the mouse pointer in place of an eye"
         : tracker == "simulated" ? "a simulated eye"
                                  : "the eye tracker of profile " + tracker;
}

std::vector<GazeSource> gaze_sources(const Dataset& set,
                                     std::span<const study::AttemptGazeRow> gaze) {
  std::map<std::string, std::set<std::string>> participants;
  for (const study::AttemptGazeRow& row : gaze) {
    if (!row.tracker.empty() && std::ranges::binary_search(set.participants, row.participant)) {
      participants[row.tracker].insert(row.participant);
    }
  }
  std::vector<GazeSource> sources;
  for (const auto& [tracker, codes] : participants) {
    sources.push_back({tracker, {codes.begin(), codes.end()}});
  }
  return sources;
}

std::string gaze_sources_in_words(const std::vector<GazeSource>& sources) {
  std::vector<std::string> words;
  for (const GazeSource& source : sources) {
    words.push_back(sources.size() == 1 ? tracker_in_words(source.tracker)
                                        : fmt::format("{} ({})", tracker_in_words(source.tracker),
                                                      comma_list(source.participants)));
  }
  return fmt::format("{}", fmt::join(words, "; "));
}

DataQualityCheck check_gaze_source(const Dataset& set,
                                   std::span<const study::AttemptGazeRow> gaze) {
  DataQualityCheck check{"Source of the gaze", "not recorded",
                         "an eye, by the same tracker in all sessions, ours"};
  const std::vector<GazeSource> sources = gaze_sources(set, gaze);
  if (!sources.empty()) {
    check.value_text = gaze_sources_in_words(sources);
    check.verdict = verdict_of(sources.size() == 1 && !is_pointer(sources.front().tracker));
  }
  return check;
}

}  // namespace foveola::analysis
