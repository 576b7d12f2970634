// What a study's file says, as plain rows: all that the analysis reads.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "study/record/amendment_note.h"

namespace foveola::study {

/// One method in one scene by one participant, practice and catch trials left out; the last
/// attempt's values.
struct TrialRow {
  std::string participant;  ///< code
  std::string scene;
  std::string method;                ///< "od", "vp", "fv"
  int scene_position = 0;            ///< 0 is the first scene that this participant saw
  int method_position = 0;           ///< 0 is the first method within the scene
  int attempts = 0;                  ///< 0 if the session ended before it
  std::optional<double> outline_s;   ///< from the first presented frame to the outline mark
  std::optional<double> material_s;  ///< from the first presented frame to the material mark
  bool outline_censored = false;     ///< right-censored: outline_s is a lower bound
  bool material_censored = false;
  std::optional<int> artifact_rating;  ///< the rating "artifacts", a whole number from 1 to 5
};

/// One answer of the questionnaire "background" that is a number.
struct BackgroundRow {
  std::string participant;
  std::string question;  ///< its id in the protocol
  double value = 0.0;
};

struct SessionRow {
  std::string participant;
  std::string kind;   ///< "human", "pilot" or "simulated"
  std::string state;  ///< name_of(Phase); not an end's if the program died in it or still runs
  std::optional<int> design_row;  ///< row of the design; empty if the record keeps none
  std::string reason;             ///< why the session was excluded
};

/// A session that went by other words or time-outs than the study's protocol has.
struct AmendedSession {
  std::string participant;
  Amendment amendment;

  friend bool operator==(const AmendedSession&, const AmendedSession&) = default;
};

/// How a study's simulated sessions came about, all of them in the same way.
struct SimulationFacts {
  double scale = 1.0;      ///< so many times fewer pixels and samples per second
  bool predicted = false;  ///< what was looked at was not rendered but predicted from pilots
  std::string injected;    ///< effects that were injected; empty: none

  friend bool operator==(const SimulationFacts&, const SimulationFacts&) = default;
};

struct StudyRecords {
  std::string protocol_name;
  std::string protocol_title;
  std::string protocol_sha256;
  std::string protocol_text;         ///< the researcher's file, to the letter
  std::vector<std::string> scenes;   ///< in the protocol's order
  std::vector<std::string> methods;  ///< in the protocol's order; the first is the baseline
  std::vector<SessionRow> sessions;
  /// How sessions were simulated; empty if none was, or if they are older than these facts.
  std::optional<SimulationFacts> simulation;
  std::vector<AmendedSession> amended;  ///< none twice: reports must say which
  std::vector<TrialRow> trials;  ///< all that were planned, in order; none of withdrawn sessions
  std::vector<BackgroundRow> background;  ///< none of withdrawn sessions

  /// Whether any session was simulated: every table and report must then say so.
  bool has_simulated() const;
};

/// Reads a study's file without changing it. Throws Error if it is missing, not a database,
/// damaged, or of a schema that this program does not know.
StudyRecords read_study(const std::filesystem::path& path);

}  // namespace foveola::study
