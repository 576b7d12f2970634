// The writer of a study's file: what it returns from is on the disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/base/build_info.h"
#include "renderer/base/clock.h"
#include "study/design/plan.h"
#include "study/protocol/protocol.h"
#include "study/record/setup/same_protocol.h"
#include "study/record/setup/simulated_part.h"
#include "study/record/write/session_recorder.h"
#include "study/session/session.h"

namespace foveola::study {

enum class SessionKind { human, pilot, simulated };

/// A scene as it was really shown.
struct ShownScene {
  std::string name;
  std::string file_name;  ///< without its folder
  std::string sha256;     ///< hash of the file
  std::string shown_as;   ///< the JSON object that schema.sql describes at session_scene
};

struct SessionFacts {
  std::string participant;  ///< code, never a name
  SessionKind kind = SessionKind::simulated;
  std::uint64_t seed = 0;
  int design_row = 0;  ///< row of the design that the plan was made of
  BuildInfo build;
  MachineInfo machine;
  /// A JSON object: of a person's session what the display turned out to be (its size, refresh
  /// rate, whether that was measured, graphics card) and the eye tracker; of a simulated one how it
  /// was simulated. The record adds what traces the rays and by which instructions, by `build`.
  std::string devices = "{}";
  std::vector<ShownScene> scenes;
};

/// A session of the file, with all that its program needs to go on with it.
struct KnownSession {
  std::int64_t id = 0;
  std::string participant;
  SessionKind kind = SessionKind::simulated;
  std::uint64_t seed = 0;
  int design_row = 0;
  Phase phase = Phase::created;
  BuildInfo build;      ///< the program that began it, as far as it was recorded
  std::string devices;  ///< as SessionFacts', with what traced the rays
  std::vector<ShownScene> scenes;
};

struct LoggedEvent {
  Nanoseconds time{0};  ///< session clock
  Event event;
  std::string utc;
};

/// What the dates in a record are, and the identifiers of its sessions.
enum class RecordDates {
  wall_clock,  ///< as it is; identifiers are random
  /// Virtual: a study and all of its sessions begin with 1970. With identifiers that follow from
  /// the protocol, the seed, the row of the design and how it is simulated, the same session is the
  /// same record, wherever and whenever it is simulated.
  virtual_time
};

/// A study's file, open for writing. Every function that returns has committed with
/// synchronous=FULL, and found what it committed in the file and its log; one that throws Error has
/// changed nothing. If the file or its log was moved, removed or replaced by another program,
/// everything is saved in another file and nothing more is recorded. There is one at a time for a
/// file.
class StudyStore {
 public:
  /// Opens the study at `path` or makes it. Throws Error if the folder is missing or not writable,
  /// the file is no database, damaged, of another schema, with triggers or indexes of others, or of
  /// another protocol, other files of its methods or other profiles (by their hashes), or if
  /// another program has it open to write: then it says which, and since when. Nothing is then made
  /// or changed. An amended protocol may be taken, too: the study keeps its own, and every session
  /// by the other is to have a note of it.
  StudyStore(const std::filesystem::path& path, const Protocol& protocol,
             OtherProtocol other = OtherProtocol::refuse,
             RecordDates dates = RecordDates::wall_clock);
  /// Leaves one self-contained file (the write-ahead log is folded in).
  ~StudyStore();
  StudyStore(const StudyStore&) = delete;
  StudyStore& operator=(const StudyStore&) = delete;

  /// The study's file; once that was lost, the file in which the record was saved.
  const std::filesystem::path& record_file() const;

  /// The text of the protocol that the study was begun with.
  std::string protocol_text() const;

  /// What the protocol differs in from the one that the study was begun with; empty if it is that.
  const std::optional<Amendment>& amendment() const;

  /// Records that the file holds a part of the simulated study `whole`; empty: that it holds a
  /// whole one. Throws Error if `whole` is empty and the file holds a part.
  void mark_as_part(const std::optional<ShardedStudy>& whole);

  /// Whether a participant of this code has a session.
  bool has_participant(const std::string& code) const;

  /// All sessions in the order in which they were begun.
  std::vector<KnownSession> sessions() const;

  /// The session's plan as it was recorded before anything happened.
  Plan plan_of(std::int64_t session) const;

  /// Everything that happened in a session, in order.
  std::vector<LoggedEvent> events_of(std::int64_t session) const;

  /// Records a new session with its whole plan, before anything happens in it. Returns its row id.
  /// Throws Error if the participant has one already.
  std::int64_t begin_session(const SessionFacts& facts, const Plan& plan);

  /// Appends `entry` to the record of the session whose row is `session`; an event together with
  /// the session's state.
  void record(std::int64_t session, const SessionEntry& entry);

  /// Runs `work`, in which the functions above commit nothing by themselves: all that it records is
  /// on the disk when this returns, or, if it throws, nothing of it.
  void record_together(const std::function<void()>& work);

  /// Copies the whole study to `path`, and checks the copy; the file is there whole or not at all.
  void back_up(const std::filesystem::path& path) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace foveola::study
