#include "study/tables/session_summary.h"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/numbers/aligned_rows.h"
#include "renderer/base/text/utf8.h"
#include "study/record/read/data_quality_records.h"
#include "study/record/read/recorded_session.h"
#include "study/record/setup/session_programs.h"
#include "study/record/write/session_rows.h"

namespace foveola::study {
namespace {

constexpr std::array ends = {"completed", "withdrawn", "excluded", "refused"};

bool is_over(const SessionRow& session) {
  return std::ranges::find(ends, session.state) != ends.end();
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

std::string text_of(const Value& value, const StudyRecords& records) {
  switch (value.state) {
    case Value::State::measured:
      return fmt::format("{:.4g}", value.number);
    case Value::State::right_censored:
      return fmt::format(">{:.4g}", value.number);
    case Value::State::in_words:
      return records.words[value.words];
    case Value::State::missing:
      break;
  }
  return "-";
}

std::string percent(const std::optional<double>& part_s, double all_s) {
  return part_s && all_s > 0.0 ? fmt::format("{:.0f} %", 100.0 * *part_s / all_s) : "-";
}

const AttemptGazeFigures* figures_of(const DataQualityRecords& quality,
                                     const std::string& participant, const TrialRow& row) {
  const auto found = std::ranges::find_if(quality.gaze, [&](const AttemptGazeRow& one) {
    return one.participant == participant && one.trial == row.trial && one.attempt == row.attempt;
  });
  return found != quality.gaze.end() ? &found->figures : nullptr;
}

/// Returns remarks about a timing for the experimenter.
std::string remarks_on(const TrialRow& row, const AttemptGazeFigures* figures) {
  TextRow remarks;
  if (row.kind != TrialKind::test) {
    remarks.emplace_back(name_of(row.kind));
  }
  if (row.attempt > 1) {
    remarks.push_back(fmt::format("timing {}", row.attempt));
  }
  if (figures != nullptr) {
    for (const GazeAtMark& mark : figures->marks) {
      if (mark.object_in_view && !*mark.object_in_view) {
        remarks.push_back(fmt::format("object out of view at {}", mark.mark));
      }
    }
  }
  return fmt::format("{}", fmt::join(remarks, ", "));
}

TextRow heading(const StudyRecords& records) {
  TextRow cells = {"trial", "scene", "method", "object"};
  for (const Measure& measure : records.measures) {
    cells.push_back(measure.id());
  }
  cells.insert(cells.end(), {"on object", "no gaze", "remarks"});
  return cells;
}

TextRow cells_of(const StudyRecords& records, const DataQualityRecords& quality,
                 std::size_t index) {
  const TrialRow& row = records.trials[index];
  const AttemptGazeFigures* const figures = figures_of(quality, records.participant_of(row), row);
  TextRow cells = {fmt::format("{}", row.trial + 1), records.scenes[row.scene],
                   records.methods[row.method], records.words[row.object]};
  for (std::size_t measure = 0; measure < records.measures.size(); ++measure) {
    cells.push_back(text_of(records.value(index, measure), records));
  }
  const std::optional<GazeTimes> times = figures != nullptr ? figures->times : std::nullopt;
  cells.push_back(times ? percent(times->on_object_s, times->all_s) : "-");
  cells.push_back(times ? percent(times->without_gaze_s, times->all_s) : "-");
  cells.push_back(row.attempt == 0 ? "not begun" : remarks_on(row, figures));
  return cells;
}

std::string trials_of(const StudyRecords& records, const DataQualityRecords& quality,
                      const std::string& participant) {
  std::vector<TextRow> rows = {heading(records)};
  for (std::size_t i = 0; i < records.trials.size(); ++i) {
    if (records.participant_of(records.trials[i]) == participant && records.trials[i].counts) {
      rows.push_back(cells_of(records, quality, i));
    }
  }
  return aligned(rows, {.indent = 2});
}

std::string frames_of(const DataQualityRecords& quality, const std::string& participant) {
  constexpr double ms_per_s = 1e3;
  for (const FrameFigures& frames : quality.frames) {
    if (frames.participant == participant) {
      const auto all = static_cast<double>(frames.frames);
      return fmt::format(
          "Frames of the test trials: {}; {:.1f} % late, {:.1f} % without a valid gaze; the gaze "
          "was {:.1f} ms old in the mean, and its frame shown {:.1f} ms later.\n",
          frames.frames, 100.0 * static_cast<double>(frames.late) / all,
          100.0 * static_cast<double>(frames.untracked) / all, ms_per_s * frames.mean_gaze_age_s,
          ms_per_s * frames.mean_to_display_s);
    }
  }
  return "No frames of test trials were recorded.\n";
}

std::string validations_of(const DataQualityRecords& quality, const std::string& participant) {
  std::string text;
  for (const GazeRunRow& run : quality.gaze_runs) {
    if (run.participant == participant) {
      text += fmt::format("Validation {}: {}, {:.0f} % lost, {}.\n", run.run,
                          run.accuracy_deg && run.precision_rms_deg
                              ? fmt::format("accuracy {:.2f} degrees, precision {:.2f}",
                                            *run.accuracy_deg, *run.precision_rms_deg)
                              : "no valid gaze",
                          100.0 * run.data_loss, run.passed ? "passed" : "not passed");
    }
  }
  return text;
}

std::string reactions_of(const DataQualityRecords& quality, const std::string& participant) {
  std::vector<double> times_s;
  for (const ReactionRow& reaction : quality.reactions) {
    if (reaction.participant == participant && !reaction.early) {
      times_s.push_back(reaction.seconds);
    }
  }
  if (times_s.empty()) {
    return "";
  }
  std::ranges::sort(times_s);
  return fmt::format("Reactions: {} from {:.3f} to {:.3f} s.\n", times_s.size(), times_s.front(),
                     times_s.back());
}

/// Returns notes with their times. A note's first line has its subject.
std::string notes_of(const std::vector<LoggedEvent>& events) {
  constexpr std::size_t max_characters = 160;
  std::string text;
  for (const LoggedEvent& logged : events) {
    if (const auto* note = std::get_if<NoteWritten>(&logged.event)) {
      text += fmt::format("  {:9.3f} s  {}\n", seconds(logged.time),
                          beginning_of(note->text, max_characters));
    }
  }
  return text.empty() ? "No notes.\n" : "Notes:\n" + text;
}

}  // namespace

std::string session_summary(const std::filesystem::path& path, const std::string& participant) {
  const RecordedSession session = read_session(path, participant);
  const StudyRecords records = read_study(path);
  const DataQualityRecords quality = read_data_quality(path);
  const std::string kind =
      session.known.kind == SessionKind::human ? "" : name_of(session.known.kind);
  const Nanoseconds lasted = session.events.empty() ? Nanoseconds(0) : session.events.back().time;
  const std::string heading = fmt::format(
      "Session of {}{}: {}, {:.1f} min, begun {}", participant,
      kind.empty() ? "" : fmt::format(" ({})", kind), name_of(session.known.phase),
      seconds(lasted) / 60.0, session.events.empty() ? "never" : session.events.front().utc);
  return fmt::format("{}\nProgram: {}\n\n{}\n{}{}{}{}", printable(heading),
                     printable(programs_in_words(session.programs)),
                     trials_of(records, quality, participant), frames_of(quality, participant),
                     validations_of(quality, participant), reactions_of(quality, participant),
                     notes_of(session.events));
}

StudyStatus status_of(const StudyRecords& records) {
  StudyStatus status;
  for (const SessionRow& session : records.sessions) {
    add_session(session, status);
  }
  count_positions(records, status);
  status.trials_done =
      static_cast<int>(std::ranges::count_if(records.trials, [&](const TrialRow& trial) {
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
        {"amended", fmt::format("{} followed a protocol of SHA-256 {}: {}", session.participant,
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
