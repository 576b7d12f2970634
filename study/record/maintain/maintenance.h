// What a researcher does with a study's file between sessions: check, merge, forget, restore.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "study/record/maintain/remaining_copies.h"

namespace foveola::study {

/// A fault of a study's file, in words that say where it is.
struct RecordFault {
  std::string participant;  ///< empty if the fault is the whole file's
  std::string what;
};

struct Verification {
  std::size_t sessions = 0;
  std::size_t events = 0;
  std::size_t chunks = 0;  ///< chunks of frames and of gaze that were checked
  std::vector<RecordFault> faults;
  /// Sessions that are not over, trials without a mark or rating, attempts without frames: no
  /// damage, but not complete either.
  std::vector<RecordFault> gaps;
  /// Facts to know before dates or times are compared, which are not damage: a wall clock that was
  /// set or a computer that slept within a session, and several programs that recorded one session,
  /// or the file. Also the files beside the study, whether they belong to it or not.
  std::vector<RecordFault> warnings;
};

/// The file's size, integrity, foreign keys, nothing beside the schema, each session's hash chain,
/// each chunk's checksum, whether the tables follow from the log, completeness, the wall clock and
/// the programs. Changes nothing. Throws Error if the file is not a study.
Verification verify_study(const std::filesystem::path& path);

/// Throws Error, with the first fault and `remedy`, if verify_study finds any.
void require_sound_record(const std::filesystem::path& path, const std::string& remedy);

struct Merge {
  std::size_t sessions_added = 0;
  std::set<std::string> known;         ///< participants whom several sources have, by UUID
  std::vector<std::string> missing;    ///< simulated participants whom no source has
  std::size_t sessions_forgotten = 0;  ///< that another source was told to forget, left out
};

enum class MissingParts { refuse, note };

struct MergeSettings {
  /// None, or one of letters and digits for each source, whose sessions that have none yet then are
  /// SITE-CODE's.
  std::vector<std::string> sites;
  MissingParts missing = MissingParts::refuse;
};

/// Adds the sessions of `sources`, files of one schema, to a new file at `target`, each once, by
/// UUID. Throws Error, and leaves no target, if the studies differ, a session differs between two
/// of them, two people have one code, or sources are shards of different simulations. If the shards
/// together lack participants, throws Error, or notes in the target that it is a part.
Merge merge_studies(const std::vector<std::filesystem::path>& sources,
                    const std::filesystem::path& target, const MergeSettings& settings = {});

struct Forgotten {
  std::size_t files = 0;                 ///< rebuilt: the study and its backups
  std::vector<RemainingCopy> remaining;  ///< that still hold something of the participant
  /// The events of other sessions in whose texts people typed the participant's code. They stay,
  /// since the hash chain covers them.
  std::vector<std::string> mentions;
};

/// Rebuilds the study and all of its backups without one participant's session, and looks for what
/// is left of it in their folder. A backup that cannot be read is left as it is. What a kill leaves
/// undone is done by calling it again. Throws Error if there is no such participant, or if the
/// study itself cannot be rebuilt.
Forgotten forget_participant(const std::filesystem::path& path, const std::string& code);

/// Where a study's backups lie: beside it, STUDY.sqlite.backups.
std::filesystem::path backup_folder(const std::filesystem::path& study);

/// All that lie there, in any order.
std::vector<std::filesystem::path> backups_of(const std::filesystem::path& study);

/// A free name in it, by the time of now; the folder is made. Throws Error if it cannot be.
std::filesystem::path new_backup(const std::filesystem::path& study);

/// Copies the study to new_backup and checks the copy. Returns its path. Throws Error.
std::filesystem::path back_up_study(const std::filesystem::path& study);

/// A free name for a copy of the study in a folder, by the time of now: STUDY.TIME.sqlite.
std::filesystem::path new_backup_in(const std::filesystem::path& folder,
                                    const std::filesystem::path& study);

/// As back_up_study, to new_backup_in the folder.
std::filesystem::path back_up_study_to(const std::filesystem::path& folder,
                                       const std::filesystem::path& study);

/// Whether the folder is on the disk of the study's folder, whose failure then takes both.
bool is_on_disk_of(const std::filesystem::path& folder, const std::filesystem::path& study);

/// Events of a session that a damaged study has and the restored one lacks.
struct MissingEvents {
  std::string participant;
  std::size_t missing = 0;
  std::size_t events = 0;  ///< of the session in the damaged study
};

struct Restored {
  std::filesystem::path copy;  ///< what the study is a copy of now
  /// The new names of what lay under the study's name: its journal, log and index, and last itself.
  std::vector<std::filesystem::path> moved_aside;
  /// By participant; empty if there was no study, or if nobody can read it.
  std::optional<std::vector<MissingEvents>> missing;
};

/// Puts `copy`, or else the newest sound backup, in the place of a study that is damaged or gone.
/// What was there is renamed. Throws Error, and moves nothing, if the copy has a fault, if no
/// backup is without one, or if another program writes the study.
Restored restore_study(const std::filesystem::path& path,
                       const std::optional<std::filesystem::path>& copy);

}  // namespace foveola::study
