// What a study's file says, as plain rows: all that the analysis reads.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "study/design/plan.h"
#include "study/protocol/measure.h"
#include "study/record/setup/amendment_note.h"
#include "study/record/setup/session_programs.h"

namespace foveola::study {

struct SessionRow {
  std::string participant;
  std::string kind;   ///< "human", "pilot" or "simulated"
  std::string state;  ///< name_of(Phase); not an end's if the program died in it or still runs
  std::optional<int> design_row;  ///< row of the design; empty if the record keeps none
  std::string reason;             ///< why the session was excluded
};

/// What one measure came out as in one timing of a trial.
struct Value {
  enum class State : std::uint8_t {
    missing,
    right_censored,  ///< a time-out came first: the time is only a lower bound
    measured,        ///< a number
    in_words,        ///< a text
  };
  State state = State::missing;
  std::uint32_t words = 0;  ///< index of a text in StudyRecords::words
  double number = 0.0;      ///< seconds from the first presented frame, or the rating

  bool is_measured() const { return state == State::measured; }
};

/// One timing of a planned trial: an attempt, of which the last one counts. A trial that was never
/// begun has one row, with attempt 0.
struct TrialRow {
  std::uint32_t session = 0;  ///< index into StudyRecords::sessions
  std::uint32_t trial = 0;    ///< place in the session's plan, from 0
  TrialKind kind = TrialKind::test;
  std::uint16_t scene = 0;  ///< index into StudyRecords::scenes
  std::uint16_t method = 0;
  std::uint16_t scene_position = 0;   ///< 0 is the first scene that this participant saw
  std::uint16_t method_position = 0;  ///< 0 is the first method within the scene
  std::uint16_t attempt = 0;          ///< 1 is the first timing
  bool counts = true;                 ///< whether it is the trial's last timing
  std::uint32_t object = 0;           ///< index of the chosen object's name in StudyRecords::words
  std::uint32_t outcome = 0;  ///< index of its name in StudyRecords::words: "rated", "retimed", …
};

/// One answer of a questionnaire.
struct AnswerRow {
  std::uint32_t session = 0;        ///< index into StudyRecords::sessions
  std::int32_t step = 0;            ///< of the session's plan: a questionnaire may be asked twice
  std::uint32_t questionnaire = 0;  ///< index of its id in StudyRecords::words
  std::uint32_t question = 0;       ///< index of its id in StudyRecords::words
  Value value;                      ///< a number, or an answer in words
  std::optional<double> response_s;
};

/// A session that went by other words or time-outs than the study's protocol has.
struct AmendedSession {
  std::string participant;
  Amendment amendment;

  friend bool operator==(const AmendedSession&, const AmendedSession&) = default;
};

/// How a study's simulated sessions came about, all of them in the same way.
struct SimulationFacts {
  double scale = 1.0;  ///< so many times fewer pixels and samples per second
  /// The full-size machine's, where it is not the protocol's.
  std::optional<double> samples_per_second{};
  bool predicted = false;  ///< what was looked at was not rendered but predicted from pilots
  std::string injected;    ///< effects that were injected; empty: none
  /// Of a file that holds a part of a study: the number of the whole study's participants.
  std::optional<int> whole_participants{};

  friend bool operator==(const SimulationFacts&, const SimulationFacts&) = default;
};

struct StudyRecords {
  std::string file;  ///< that it was read from; empty if it was not read
  /// The part of the protocol that read_measured_part reads, with its text.
  Protocol protocol;
  std::string display_profile;  ///< name of the display's profile; empty if there is none
  std::string tracker_profile;

  std::vector<std::string> scenes;   ///< in the protocol's order
  std::vector<std::string> methods;  ///< in the protocol's order; the first is the baseline
  /// Of each trial: marks, the response times of which there are any, then ratings.
  std::vector<Measure> measures;
  std::vector<SessionRow> sessions;  ///< in the order in which they were begun
  /// How sessions were simulated; empty if none was, or if they are older than these facts.
  std::optional<SimulationFacts> simulation;
  std::vector<AmendedSession> amended;    ///< none twice: reports must say which
  std::vector<SessionPrograms> programs;  ///< of all sessions, in their order

  // Of withdrawn sessions only what WithdrawnSessions says.
  std::vector<TrialRow> trials;    ///< by session, trial and attempt
  std::vector<Value> values;       ///< [row of trials][measure]
  std::vector<std::string> words;  ///< texts that rows refer to; the first is empty
  std::vector<AnswerRow> answers;  ///< in the order in which they were given

  const std::string& questionnaire_of(const AnswerRow& row) const {
    return words[row.questionnaire];
  }
  const std::string& question_of(const AnswerRow& row) const { return words[row.question]; }
  const Value& value(std::size_t row, std::size_t measure) const {
    return values[row * measures.size() + measure];
  }
  /// Adds a timing of a trial; `of_measures` has a value for each measure.
  void add_trial(const TrialRow& row, const std::vector<Value>& of_measures) {
    trials.push_back(row);
    values.insert(values.end(), of_measures.begin(), of_measures.end());
  }
  const std::string& participant_of(const TrialRow& row) const {
    return sessions[row.session].participant;
  }
  /// Whether the row is the last timing of a test trial: what is analysed.
  static bool is_result(const TrialRow& row) { return row.counts && row.kind == TrialKind::test; }

  /// Whether any session was simulated: every table and report must then say so.
  bool has_simulated() const;
};

/// What is read of sessions that a participant withdrew from.
enum class WithdrawnSessions : std::uint8_t {
  without_data,  ///< that there was one: no trials and no answers
  with_data,
};

/// Reads a study's file without changing it. Throws Error if it is missing, not a database,
/// damaged, or of a schema that this program does not know.
StudyRecords read_study(const std::filesystem::path& path,
                        WithdrawnSessions withdrawn = WithdrawnSessions::without_data);

}  // namespace foveola::study
