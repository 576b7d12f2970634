#include "study/commands/record_tables.h"

#include <algorithm>

#include <fmt/format.h>

#include "study/commands/aligned_rows.h"

namespace foveola::study {

StudyStatus status_of(const StudyRecords& records) {
  StudyStatus status;
  for (const SessionRow& session : records.sessions) {
    ++status.sessions[{session.kind, session.state}];
  }
  status.trials_done = static_cast<int>(
      std::count_if(records.trials.begin(), records.trials.end(),
                    [](const TrialRow& trial) { return trial.artifact_rating.has_value(); }));
  return status;
}

std::string status_table(const StudyRecords& records, const StudyStatus& status) {
  std::vector<Row> rows = {{"protocol", records.protocol_name},
                           {"title", records.protocol_title},
                           {"sha256", records.protocol_sha256}};
  for (const auto& [group, count] : status.sessions) {
    rows.push_back({"sessions", fmt::format("{} {} {}", count, group.first, group.second)});
  }
  rows.push_back({"trials", fmt::format("{} done", status.trials_done)});
  return aligned(rows);
}

}  // namespace foveola::study
