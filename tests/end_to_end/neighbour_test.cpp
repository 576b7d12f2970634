// Other programs at the files of a running session: those that read the study, those that take its
// log away, and commands that were told to write where they read.
//
// FOVEOLA_KILLS=1000 kills so many sessions instead of a few.
#include <csignal>
#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "renderer/base/files.h"
#include "study/record/maintenance.h"
#include "tests/end_to_end/rendered_room.h"
#include "tests/end_to_end/study_run.h"

namespace fs = std::filesystem;

namespace foveola::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class RunWithNeighbours : public StudyRun {
 protected:
  void begin(int participant) {
    participant_.seat(fmt::format("P{}", participant));
    participant_.begin();
    participant_.wait_for_page();
  }
  /// Returns once it was acknowledged.
  void note(const std::string& text) {
    participant_.program().type_line("note " + text);
    participant_.program().wait_for("Note: " + text);
  }
  /// By SQLite's own program and by Python's, in turn.
  void read_study(int time) const {
    const std::string python =
        "import sqlite3, sys; c = sqlite3.connect(sys.argv[1]);"
        " print(c.execute('SELECT count(*) FROM event').fetchone()); c.close()";
    const std::string command =
        time % 2 == 0
            ? fmt::format("sqlite3 '{}' .dump >/dev/null", participant_.database().string())
            : fmt::format("python3 -c \"{}\" '{}' >/dev/null", python,
                          participant_.database().string());
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
  }
};

TEST_F(RunWithNeighbours, WhatAnotherProgramReadsIsNotLostByAKill) {
  const char* const asked = std::getenv("FOVEOLA_KILLS");
  const int kills = asked != nullptr ? std::stoi(asked) : 4;
  participant_.write_protocol(one_trial_keys, short_look);
  for (int i = 1; i <= kills; ++i) {
    begin(i);
    note("before");
    read_study(i);
    note("after");
    participant_.program().kill(SIGKILL);
    participant_.program().wait_for_end();
    ASSERT_EQ(
        participant_.ask(fmt::format("SELECT text FROM note JOIN session ON session.id = session"
                                     " WHERE participant = 'P{}' ORDER BY sequence",
                                     i)),
        Rows({"before", "after"}))
        << "kill " << i;
  }
  EXPECT_THAT(study::verify_study(participant_.database()).faults, IsEmpty());
}

TEST_F(RunWithNeighbours, ASessionWhoseLogIsTakenAwayEndsAndIsSaved) {
  participant_.write_protocol(one_trial_keys, short_look);
  begin(1);
  note("before");
  fs::remove(participant_.database().string() + "-wal");
  participant_.program().type_line("note after");
  EXPECT_EQ(participant_.program().wait_for_end(), 1);
  EXPECT_THAT(participant_.program().said(),
              AllOf(HasSubstr("its log (-wal) was removed"), HasSubstr("study.saved-"),
                    HasSubstr("give the same command with that file and --resume")));
  for (const fs::directory_entry& entry : fs::directory_iterator(participant_.folder().path())) {
    if (entry.path().filename().string().starts_with("study.saved-")) {
      EXPECT_EQ(rows_of(entry.path(), "SELECT text FROM note ORDER BY sequence"),
                Rows({"before", "after"}));
      return;
    }
  }
  ADD_FAILURE() << "nothing was saved";
}

class OutputsApart : public Render {};

TEST_F(OutputsApart, NoCommandWritesOverWhatItReads) {
  const std::string study = (folder_ / "study.sqlite").string();
  const std::string scene = (folder_ / "room.gltf").string();
  write_file(study, "a study");
  const std::string link = (folder_ / "link.sqlite").string();
  fs::create_hard_link(study, link);
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"study", "gaze", study, "--participant", "P1", "--trial", "0", "-o", study},
           {"study", "gaze", study, "--participant", "P1", "--trial", "0", "-o", link},
           {"study", "gaze", study, "--participant", "P1", "--trial", "0", "-o", study + "-wal"},
           {"study", "run", "demo", "--db", study, "--participant", "P1", "--receipt", study},
           {"study", "run", "demo", "--db", study, "--participant", "P1", "--receipt",
            study + ".controller"},
           {"study", "run", "demo", "--db", study, "--participant", "P1", "--screens",
            study + ".backups"},
           {"study", "merge", study, "-o", study + "-journal"},
           {"analyze", study, "-o", study + ".backups"},
           {"render", scene, "-o", scene},
           {"render", scene, "-o", (folder_ / "x.png").string(), "--view", scene}}) {
    SCOPED_TRACE(fmt::format("{} {}", arguments[0], arguments.back()));
    const auto before = folder_.content();
    const ProgramResult result = run_foveola(arguments);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.errors, HasSubstr("name another file"));
    EXPECT_TRUE(folder_.content() == before);
  }
}

}  // namespace
}  // namespace foveola::test
