// A session whose study is copied to another disk.
#include <filesystem>

#include "study/record/maintain/maintenance.h"
#include "tests/end_to_end/run/study_run.h"
#include "tests/end_to_end/small_disk.h"
#include "tests/matchers.h"

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

std::vector<fs::path> files_in(const fs::path& folder) {
  return {fs::directory_iterator(folder), fs::directory_iterator()};
}

class BackupRun : public StudyRun {
 protected:
  void run_to_the_last_page(const fs::path& backup_folder) {
    participant_.write_protocol(one_trial_keys, short_look);
    participant_.begin({"--backup-to", backup_folder});
    participant_.begin_trials();
    time_trial();
    rate("3");
    EXPECT_EQ(participant_.wait_for_page(), "completed");
  }
  void end() {
    participant_.type("Return");
    EXPECT_EQ(participant_.program().wait_for_end(), 0);
    EXPECT_THAT(participant_.ask("SELECT state FROM session"), ElementsAre("completed"));
    EXPECT_THAT(files_in(study::backup_folder(participant_.database())), SizeIs(1));
  }
};

TEST_F(BackupRun, IsRefusedBeforeAnythingRunsWithoutItsFolder) {
  participant_.write_protocol(one_trial_keys, short_look);
  const fs::path folder = participant_.folder() / "none";
  expect_one_line(participant_.run_besides("P1", {"--backup-to", folder}), 1,
                  "the folder " + folder.string() + " does not exist");
  EXPECT_FALSE(fs::exists(participant_.database()));
}

TEST_F(BackupRun, LeavesACopyInItsFolder) {
  const fs::path folder = participant_.folder() / "copies";
  fs::create_directory(folder);
  run_to_the_last_page(folder);
  end();
  EXPECT_THAT(participant_.program().said(),
              HasSubstr("foveola: warning: " + folder.string() + ": is on the same disk as " +
                        participant_.database().string()));
  ASSERT_THAT(files_in(folder), SizeIs(1));
  const fs::path copy = files_in(folder).front();
  EXPECT_THAT(participant_.program().said(), HasSubstr("; copy " + copy.string()));
  EXPECT_THAT(study::verify_study(copy).faults, IsEmpty());
  EXPECT_THAT(all_rows_of(copy, "SELECT participant, state FROM session"),
              ElementsAre("P1|completed"));
}

TEST_F(BackupRun, WhoseOtherDiskIsFullOnlyWarns) {
  if (const std::string refusal = refusal_of_own_mounts(); !refusal.empty()) {
    GTEST_SKIP() << refusal;
  }
  const SmallDisk disk(participant_.folder() / "disk");
  run_to_the_last_page(disk.folder());
  disk.fill();
  end();
  EXPECT_THAT(
      participant_.program().said(),
      AllOf(HasSubstr("foveola: warning: " + disk.folder().string() + ": no copy of " +
                      participant_.database().string() + " was written (" + disk.folder().string()),
            HasSubstr("the disk is full"), HasSubstr("run foveola study backup --to"),
            Not(HasSubstr("is on the same disk"))));
  EXPECT_THAT(files_in(disk.folder()), SizeIs(1)) << "the filling";
}

}  // namespace
}  // namespace foveola::test
