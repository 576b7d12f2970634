#include "study/tables/record_tables.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/aligned_rows.h"

namespace foveola::study {
namespace {

constexpr std::array ends = {"completed", "withdrawn", "excluded", "refused"};

bool is_over(const SessionRow& session) {
  return std::find(ends.begin(), ends.end(), session.state) != ends.end();
}

void add_session(const SessionRow& session, StudyStatus& status) {
  KindStatus& kind = status.kinds[session.kind];
  ++kind.sessions[session.state];
  if (session.design_row && (session.state == "completed" || !is_over(session))) {
    ++kind.design_rows[*session.design_row];
  }
  if (!is_over(session)) {
    status.unfinished.push_back(session);
  }
  if (session.state == "excluded") {
    status.excluded.push_back(session);
  }
}

void count_positions(const StudyRecords& records, StudyStatus& status) {
  for (const TrialRow& trial : records.trials) {
    const SessionRow& session = records.sessions[trial.session];
    if (session.state == "completed" && StudyRecords::is_result(trial)) {
      std::vector<int>& counts =
          status.kinds[session.kind].method_positions[records.methods[trial.method]];
      counts.resize(records.methods.size());
      ++counts.at(trial.method_position);
    }
  }
}

void add_kind_rows(const StudyRecords& records, const std::string& name, const KindStatus& kind,
                   std::vector<TextRow>& rows) {
  for (const auto& [state, count] : kind.sessions) {
    rows.push_back({"sessions", fmt::format("{} {} {}", count, name, state)});
  }
  if (!kind.design_rows.empty()) {
    std::vector<std::string> uses;
    for (const auto& [row, count] : kind.design_rows) {
      uses.push_back(fmt::format("{} x {}", row, count));
    }
    rows.push_back(
        {"orders", fmt::format("{}, by row of the design: {}", name, fmt::join(uses, ", "))});
  }
  for (const std::string& method : records.methods) {
    const auto counts = kind.method_positions.find(method);
    if (counts != kind.method_positions.end()) {
      rows.push_back(
          {"positions", fmt::format("{} {}: {}", name, method, fmt::join(counts->second, " / "))});
    }
  }
}

void add_program_rows(const std::vector<SessionPrograms>& sessions, std::vector<TextRow>& rows) {
  for (const ProgramUse& use : program_uses(sessions)) {
    rows.push_back({"program", use_in_words(use)});
  }
  for (const SessionPrograms& session : sessions) {
    if (session.programs.size() > 1) {
      rows.push_back({"programs", fmt::format("{} by {}", session.participant,
                                              programs_in_words(session.programs))});
    }
  }
}

std::string words_for_changes(const Amendment& amendment) {
  return amendment.changed.empty() ? "only comments changed"
                                   : fmt::format("{} changed", fmt::join(amendment.changed, ", "));
}

}  // namespace

StudyStatus status_of(const StudyRecords& records) {
  StudyStatus status;
  for (const SessionRow& session : records.sessions) {
    add_session(session, status);
  }
  count_positions(records, status);
  status.trials_done = static_cast<int>(
      std::count_if(records.trials.begin(), records.trials.end(), [&](const TrialRow& trial) {
        return StudyRecords::is_result(trial) && records.words[trial.outcome] == "rated";
      }));
  return status;
}

std::string status_table(const StudyRecords& records, const StudyStatus& status) {
  std::vector<TextRow> rows = {{"protocol", records.protocol.name},
                               {"title", records.protocol.title},
                               {"sha256", records.protocol.sha256}};
  for (const auto& [name, kind] : status.kinds) {
    add_kind_rows(records, name, kind, rows);
  }
  if (records.simulation && records.simulation->whole_participants) {
    rows.push_back({"part", fmt::format("of a simulated study of {} participants",
                                        *records.simulation->whole_participants)});
  }
  for (const SessionRow& session : status.unfinished) {
    rows.push_back({"unfinished", fmt::format("{} {}", session.participant, session.state)});
  }
  for (const SessionRow& session : status.excluded) {
    rows.push_back({"excluded", fmt::format("{}: {}", session.participant, session.reason)});
  }
  add_program_rows(records.programs, rows);
  for (const AmendedSession& session : records.amended) {
    rows.push_back(
        {"amended", fmt::format("{} went by a protocol of SHA-256 {}: {}", session.participant,
                                session.amendment.sha256, words_for_changes(session.amendment))});
  }
  rows.push_back({"trials", fmt::format("{} done", status.trials_done)});
  return aligned(rows);
}

std::string verification_table(const Verification& found) {
  std::vector<TextRow> rows = {{"sessions", std::to_string(found.sessions)},
                               {"events", std::to_string(found.events)},
                               {"chunks", std::to_string(found.chunks)},
                               {"faults", std::to_string(found.faults.size())}};
  const auto add = [&](const char* heading, const std::vector<RecordFault>& findings) {
    for (const RecordFault& one : findings) {
      rows.push_back({heading, one.participant.empty()
                                   ? one.what
                                   : fmt::format("{}: {}", one.participant, one.what)});
    }
  };
  add("fault", found.faults);
  add("gap", found.gaps);
  add("warning", found.warnings);
  return aligned(rows);
}

}  // namespace foveola::study
