// A study through losses of power, at any moment, with whatever the disk then holds.
//
// FOVEOLA_POWER_LOSSES=10000 loses it so often in each test instead of a few times.
#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <set>

#include <SQLiteCpp/SQLiteCpp.h>

#include "power_loss_study.h"
#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "study/record/maintain/maintenance.h"
#include "study/record/sqlite/database.h"
#include "tests/matchers.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

constexpr const char* study_name = "study.sqlite";

/// The moments between two calls at which the power is lost: half of them at any, the others right
/// after something was acknowledged; in order.
std::vector<std::size_t> drawn_moments(const std::vector<DiskCall>& calls, std::size_t count,
                                       std::mt19937& random) {
  const auto begun = std::find_if(calls.begin(), calls.end(), [](const DiskCall& call) {
    return std::holds_alternative<Begun>(call);
  });
  std::vector<std::size_t> after_acknowledgements;
  for (std::size_t i = 0; i < calls.size(); ++i) {
    if (std::holds_alternative<Acknowledged>(calls[i])) {
      after_acknowledgements.push_back(i + 1);
    }
  }
  std::uniform_int_distribution<std::size_t> any(
      static_cast<std::size_t>(begun - calls.begin()) + 1, calls.size());
  std::vector<std::size_t> moments;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t drawn = any(random);
    moments.push_back(i % 2 == 0 ? drawn
                                 : after_acknowledgements[drawn % after_acknowledgements.size()]);
  }
  std::sort(moments.begin(), moments.end());
  return moments;
}

std::size_t losses_or(std::size_t a_few) {
  const char* asked = std::getenv("FOVEOLA_POWER_LOSSES");
  return asked != nullptr ? std::stoul(asked) : a_few;
}

/// Loses the power again and again, and calls `judge` with the folder that is left and how much
/// had been acknowledged.
template <typename Judge>
void lose_power(const std::vector<DiskCall>& calls, std::size_t times, Syncs syncs,
                const Judge& judge) {
  std::mt19937 random(2018);
  LosingDisk disk(syncs);
  std::size_t gone_through = 0;
  std::size_t acknowledged = 0;
  std::size_t losses = 0;
  for (const std::size_t moment : drawn_moments(calls, times, random)) {
    for (; gone_through < moment; ++gone_through) {
      acknowledged += std::holds_alternative<Acknowledged>(calls[gone_through]) ? 1 : 0;
      disk.go_through(calls[gone_through]);
    }
    const TemporaryFolder left;
    for (const auto& [name, content] :
         disk.after(all_losses[losses++ % std::size(all_losses)], random)) {
      left.write(name, content);
    }
    judge(left, acknowledged);
  }
}

/// The value of a query, read as Foveola reads: a journal that a loss of power left is not played.
std::string value_in(const fs::path& path, const std::string& sql) {
  return open_as_it_is(path).execAndGet(sql).getString();
}

std::string marks_in(const fs::path& path) { return value_in(path, "SELECT count(*) FROM mark"); }

Holdings holdings_of(const fs::path& path) {
  SQLite::Database database = open_as_it_is(path);
  SQLite::Statement counts(database,
                           "SELECT (SELECT count(*) FROM session), (SELECT count(*) FROM event),"
                           " (SELECT count(*) FROM frame_chunk),"
                           " (SELECT count(*) FROM gaze_chunk), (SELECT count(*) FROM film_hash)");
  counts.executeStep();
  const auto number = [&](int column) {
    return static_cast<std::size_t>(counts.getColumn(column).getInt64());
  };
  return {number(0), number(1), number(2), number(3), number(4)};
}

/// Holds the study against what is known of it, and goes on with it. Returns what is wrong.
std::string fault_of(const fs::path& path, const RecordedStudy& known, std::size_t acknowledged) {
  if (acknowledged > 0 && !fs::exists(path)) {
    return "is not there";
  }
  try {
    StudyStore store(path, small_protocol());
    const Holdings left = holdings_of(path);
    const auto first = known.commits.begin() + static_cast<std::ptrdiff_t>(acknowledged);
    if (std::find(first, known.commits.end(), left) == known.commits.end()) {
      return "lost what was acknowledged, or holds half of something";
    }
    std::vector<TimedEvent> events;
    for (const KnownSession& session : store.sessions()) {
      SessionState state;
      for (const LoggedEvent& logged : store.events_of(session.id)) {
        events.push_back({logged.time, std::string(name_of(logged.event))});
        state =
            step(procedure_of(small_protocol(), small_plan()), state, logged.event).value().state;
      }
      if (!state.is_over()) {
        store.record(session.id, EventEntry{.time = ms(100'000),
                                            .event = NoteWritten{.text = "the power was lost"},
                                            .before = state,
                                            .after = state});
      }
    }
    if (!std::equal(events.begin(), events.end(), known.events.begin())) {
      return "shows other events";
    }
  } catch (const Error& error) {
    return error.what();
  }
  const Verification verified = verify_study(path);
  return verified.faults.empty() ? "" : verified.faults.front().what;
}

/// In how many of the losses the study was at fault; each is a failure where syncs are kept.
std::size_t count_faults(const RecordedStudy& study, std::size_t times, Syncs syncs) {
  std::size_t faults = 0;
  std::size_t losses = 0;
  lose_power(study.calls, times, syncs, [&](const TemporaryFolder& left, std::size_t acknowledged) {
    const std::string fault = fault_of(left / study_name, study, acknowledged);
    faults += fault.empty() ? 0 : 1;
    ++losses;
    if (syncs == Syncs::kept) {
      EXPECT_EQ(fault, "") << "loss " << losses << ", " << acknowledged << " acknowledged";
    }
  });
  std::cout << losses << " losses of power, " << faults << " faults\n";
  return faults;
}

TEST(PowerLoss, WhatWasAcknowledgedStays) {
  count_faults(short_study(), losses_or(70), Syncs::kept);
}

/// Whether SQLite began its log anew, which it does once all of it is in the file.
bool folds_in_its_log(const RecordedStudy& study) {
  std::map<FileId, std::size_t> beginnings;
  for (const DiskCall& call : study.calls) {
    if (const auto* const write = std::get_if<Written>(&call);
        write != nullptr && write->offset == 0 && write->bytes.size() == 32) {  // a log's header
      ++beginnings[write->file];
    }
  }
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [](const auto& file) { return file.second > 1; });
}

TEST(PowerLoss, WhatWasAcknowledgedStaysWhileTheLogIsFoldedIn) {
  ASSERT_TRUE(folds_in_its_log(long_study()));
  count_faults(long_study(), losses_or(10), Syncs::kept);
}

// A record that did not sync, or too late, would be found out.
TEST(PowerLoss, IsFoundIfFilesAreNotSynced) {
  EXPECT_GT(count_faults(short_study(), 30, Syncs::files_ignored), 7);
}

TEST(PowerLoss, IsFoundIfFoldersAreNotSynced) {
  EXPECT_GT(count_faults(short_study(), 30, Syncs::folders_ignored), 4);
}

// Otherwise a loss of power may leave an empty file under the name of a whole one.
TEST(PowerLoss, AFileIsSyncedBeforeItHasItsName) {
  const TemporaryFolder folder;
  DiskWatch watch(folder.path());
  write_file(folder / "consent.txt", "yes");
  bool is_named = false;
  std::set<FileId> synced;
  for (const DiskCall& call : watch.calls()) {
    if (const auto* sync = std::get_if<Synced>(&call)) {
      synced.insert(sync->file);
    } else if (const auto* named = std::get_if<Named>(&call)) {
      const auto file = named->names.find("consent.txt");
      is_named = file != named->names.end();
      EXPECT_TRUE(!is_named || synced.contains(file->second.id));
    }
  }
  EXPECT_TRUE(is_named);
}

// Otherwise a loss of power may take a receipt or an export that was reported as written.
TEST(PowerLoss, AFileThatWasWrittenHasItsName) {
  const TemporaryFolder folder;
  DiskWatch watch(folder.path());
  write_file(folder / "consent.txt", "yes");
  LosingDisk disk;
  for (const DiskCall& call : watch.calls()) {
    disk.go_through(call);
  }
  std::mt19937 random;
  EXPECT_TRUE(disk.after(Loss::everything, random).contains("consent.txt"));
}

// The disk that the tests lose is the one that the program wrote.
TEST(PowerLoss, ADiskThatLosesNothingHoldsWhatTheProgramWrote) {
  const TemporaryFolder folder;
  std::vector<DiskCall> calls;
  std::map<std::string, std::string> written;
  {
    DiskWatch watch(folder.path());
    StudyStore store(folder / study_name, thorough_protocol());
    run_thorough_session(store, "P01");
    calls = watch.calls();
    for (const char* name : {study_name, "study.sqlite-wal"}) {
      written[name] = read_file(folder / name);
    }
  }
  LosingDisk disk;
  for (const DiskCall& call : calls) {
    disk.go_through(call);
  }
  std::mt19937 random;
  EXPECT_TRUE(disk.after(Loss::nothing, random) == written);
}

/// What a disk loses that has watched `work` on a study of one thorough session, which lies at
/// study_name and may be open or not; `work` returns the path that must then be there.
template <typename Work>
void expect_whole_session(const TemporaryFolder& folder, std::size_t times, const Work& work) {
  const std::string marks = marks_in(folder / study_name);
  std::vector<DiskCall> calls;
  std::string name;
  {
    DiskWatch watch(folder.path());
    name = fs::path(work()).lexically_relative(folder.path());
    watch.acknowledge();
    calls = watch.calls();
  }
  lose_power(calls, times, Syncs::kept, [&](const TemporaryFolder& left, std::size_t acknowledged) {
    EXPECT_TRUE(fs::exists(left / study_name));
    EXPECT_TRUE(acknowledged == 0 || fs::exists(left / name)) << name << " is gone";
    for (const std::string& study : std::set<std::string>{study_name, name}) {
      if (fs::exists(left / study)) {
        EXPECT_THAT(verify_study(left / study).faults, IsEmpty());
        EXPECT_EQ(marks_in(left / study), marks);
      }
    }
  });
}

TEST(PowerLoss, ABackupThatWasMadeStays) {
  const TemporaryFolder folder;
  const fs::path path = folder / study_name;
  StudyStore store(path, thorough_protocol());
  run_thorough_session(store, "P01");
  expect_whole_session(folder, losses_or(15), [&] { return back_up_study(path); });
}

TEST(PowerLoss, ARestoredBackupIsGoneOnWith) {
  const TemporaryFolder folder;
  const fs::path path = folder / study_name;
  {
    const TemporaryFolder elsewhere;
    StudyStore store(elsewhere / study_name, thorough_protocol());
    run_thorough_session(store, "P01");
    store.back_up(path);
  }
  expect_whole_session(folder, losses_or(30), [&] {
    const StudyStore store(path, thorough_protocol());
    return path;
  });
}

// Several sites' files.
TEST(PowerLoss, AMergedStudyIsThereWholeOrNotAtAll) {
  const TemporaryFolder folder;
  const std::vector<fs::path> sites = {folder / "helsinki.sqlite", folder / "tampere.sqlite"};
  for (std::size_t site = 0; site < sites.size(); ++site) {
    StudyStore store(sites[site], thorough_protocol());
    run_thorough_session(store, "P0" + std::to_string(site));
  }
  std::vector<DiskCall> calls;
  {
    DiskWatch watch(folder.path());
    merge_studies(sites, folder / study_name);
    watch.acknowledge();
    calls = watch.calls();
  }
  lose_power(calls, losses_or(20), Syncs::kept,
             [&](const TemporaryFolder& left, std::size_t acknowledged) {
               EXPECT_TRUE(acknowledged == 0 || fs::exists(left / study_name));
               if (fs::exists(left / study_name)) {
                 EXPECT_THAT(verify_study(left / study_name).faults, IsEmpty());
                 EXPECT_EQ(value_in(left / study_name, "SELECT count(*) FROM session"), "2");
               }
               for (const fs::path& site : sites) {
                 const fs::path file = left / site.filename().string();
                 EXPECT_THAT(verify_study(file).faults, IsEmpty());
                 EXPECT_EQ(marks_in(file), marks_in(site));
               }
             });
}

std::size_t count_files_with(const fs::path& folder, const std::string& words) {
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file() && read_file(entry.path()).find(words) != std::string::npos) {
      ++count;
    }
  }
  return count;
}

constexpr const char* forgotten_code = "PERSON-0123";

enum class HeldBy { backup, killed_backup };

/// A study as a killed program leaves it, with its log, in which the participant is between two
/// others; and a backup, or one that was killed and never had its name.
void leave_study(const TemporaryFolder& folder, HeldBy held_by) {
  const TemporaryFolder elsewhere;
  StudyStore store(elsewhere / study_name, thorough_protocol());
  for (const char* code : {"P01", forgotten_code, "P03"}) {
    run_thorough_session(store, code);
  }
  const fs::path backup = new_backup(folder / study_name);
  store.back_up(backup);
  if (held_by == HeldBy::killed_backup) {
    fs::rename(backup, backup.parent_path() / ".another.sqlite.4711.partial");
  }
  for (const char* name : {study_name, "study.sqlite-wal"}) {
    fs::copy_file(elsewhere / name, folder / name);
  }
}

/// Of the study and its backups; a folder without files does not come back.
std::vector<fs::path> studies_in(const TemporaryFolder& folder) {
  std::vector<fs::path> studies = {folder / study_name};
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(backup_folder(studies.front()), ignored)) {
    if (!entry.path().filename().string().starts_with('.')) {
      studies.push_back(entry.path());
    }
  }
  return studies;
}

/// That a study's fault is none, and that it holds all others than the one who is forgotten.
void expect_others_in(const fs::path& study) {
  EXPECT_THAT(verify_study(study).faults, IsEmpty()) << study;
  EXPECT_EQ(value_in(study,
                     "SELECT group_concat(participant) FROM (SELECT participant FROM session"
                     " WHERE participant <> 'PERSON-0123' ORDER BY id)"),
            "P01,P03");
}

/// After a loss of power the researcher forgets again, unless it was done by then.
void forget_again(const fs::path& study) {
  try {
    forget_participant(study, forgotten_code);
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("has no participant"));
  }
}

void lose_power_forgetting(HeldBy held_by) {
  const TemporaryFolder folder;
  leave_study(folder, held_by);
  ASSERT_EQ(count_files_with(folder.path(), forgotten_code), 2U) << "the log and the other";
  std::vector<DiskCall> calls;
  {
    DiskWatch watch(folder.path());
    forget_participant(folder / study_name, forgotten_code);
    watch.acknowledge();
    calls = watch.calls();
  }
  ASSERT_EQ(count_files_with(folder.path(), forgotten_code), 0U);
  lose_power(calls, losses_or(15), Syncs::kept,
             [&](const TemporaryFolder& left, std::size_t acknowledged) {
               if (acknowledged > 0) {
                 EXPECT_EQ(count_files_with(left.path(), forgotten_code), 0U);
               }
               for (const fs::path& study : studies_in(left)) {
                 expect_others_in(study);
               }
               forget_again(left / study_name);
               EXPECT_EQ(count_files_with(left.path(), forgotten_code), 0U);
               for (const fs::path& study : studies_in(left)) {
                 expect_others_in(study);
               }
             });
}

TEST(PowerLoss, WhoWasForgottenDoesNotComeBack) { lose_power_forgetting(HeldBy::backup); }

// Then nothing but the removal itself brings that to the disk.
TEST(PowerLoss, ARemovedBackupDoesNotComeBack) { lose_power_forgetting(HeldBy::killed_backup); }

TEST(PowerLoss, AStudyIsRestoredAndNothingOfTheFormerOneIsLost) {
  const TemporaryFolder folder;
  leave_study(folder, HeldBy::backup);
  std::vector<DiskCall> calls;
  {
    DiskWatch watch(folder.path());
    restore_study(folder / study_name, std::nullopt);
    watch.acknowledge();
    calls = watch.calls();
  }
  lose_power(calls, losses_or(15), Syncs::kept,
             [&](const TemporaryFolder& left, std::size_t acknowledged) {
               EXPECT_GE(count_files_with(left.path(), forgotten_code), acknowledged > 0 ? 3U : 2U)
                   << "its log, the backup and what was restored";
               if (acknowledged == 0) {
                 restore_study(left / study_name, std::nullopt);
               }
               EXPECT_FALSE(fs::exists(left / "study.sqlite-wal"));
               expect_others_in(left / study_name);
             });
}

}  // namespace
}  // namespace foveola::study
