// Recorded sessions, driven and rendered again by the built program.
#include <nlohmann/json.hpp>
#include <sqlite3.h>

#include "renderer/base/files/files.h"
#include "renderer/image/image_file.h"
#include "tests/end_to_end/study/study_of_a_hall.h"
#include "tests/end_to_end/study_rows.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

TEST_F(StudyOfAHall, AScaledSessionIsReplayedAsItWasShown) {
  std::string protocol = hall_protocol();
  for (const auto& [small, large] :
       {std::pair("width = 32\nheight = 16", "width = 64\nheight = 32"),
        std::pair("view_width = 16\nview_height = 16", "view_width = 32\nview_height = 32")}) {
    protocol.replace(protocol.find(small), std::string(small).size(), large);
  }
  folder.write("share/protocols/hall.toml", protocol);
  const std::string study = (folder / "study.sqlite").string();
  succeeded(run({"study", "simulate", "hall", "--db", study, "--participants", "1", "--scale", "4",
                 "--samples-per-second", "20000"}));
  const ProgramResult replayed = run({"study", "replay", study, "--participant", "P001"});
  EXPECT_EQ(replayed.exit_code, 0) << replayed.output << replayed.errors;
  EXPECT_THAT(replayed.output, HasSubstr("bit-identical"));
  const ProgramResult mixed =
      run({"study", "simulate", "hall", "--db", study, "--participants", "1"});
  EXPECT_EQ(mixed.exit_code, 1);
  EXPECT_THAT(mixed.errors, HasSubstr("simulation/samples_per_second: 20000.0, now nothing"));
}

TEST_F(StudyOfAHall, APredictedSessionHasNothingToReplay) {
  const std::string study = (folder / "study.sqlite").string();
  const ProgramResult simulated =
      succeeded(run({"study", "simulate", "hall", "--db", study, "--participants", "3",
                     "--predicted", "--jobs", "2"}));
  EXPECT_THAT(simulated.output, HasSubstr("3 of 3 simulated sessions completed"));
  const ProgramResult replayed = run({"study", "replay", study, "--participant", "P001"});
  EXPECT_EQ(replayed.exit_code, 1);
  EXPECT_THAT(replayed.errors, HasSubstr("was predicted, not rendered"));
}

class ReplayOfAHall : public StudyOfAHall {
 protected:
  ReplayOfAHall() { simulate("study.sqlite"); }

  ProgramResult replay(const std::vector<std::string>& more = {}) const {
    return run(joined(
        {"study", "replay", (folder / "study.sqlite").string(), "--participant", "P001"}, more));
  }

  /// Changes a table behind the program's back: its triggers are put aside for the moment.
  void change(const std::string& table, const std::string& update) const {
    const auto of_triggers = [&](const std::string& column) {
      return value_of(folder / "study.sqlite", "SELECT group_concat(" + column +
                                                   ", ';') FROM sqlite_schema WHERE type ="
                                                   " 'trigger' AND tbl_name = '" +
                                                   table + "'");
    };
    const std::string guards = of_triggers("sql");
    const std::string drops = of_triggers("'DROP TRIGGER ' || name");
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open((folder / "study.sqlite").c_str(), &database), SQLITE_OK);
    for (const std::string& sql : {drops, update, guards}) {
      EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK) << sql;
    }
    sqlite3_close(database);
  }
};

TEST_F(ReplayOfAHall, IsTheSameBitForBitAndCanBeSeen) {
  const ProgramResult replayed = succeeded(replay({"-o", (folder / "pictures").string()}));
  const std::string frames =
      value_of(folder / "study.sqlite", "SELECT sum(frame_count) FROM frame_chunk");
  EXPECT_EQ(replayed.output.find("trial 0 (hall, od), attempt 1: " + frames + " frames, "), 0U)
      << replayed.output;
  EXPECT_THAT(replayed.output, HasSubstr("samples: bit-identical\n"));
  const IVec2 size = image_size(folder / "pictures/P001-trial-00-attempt-1.png");
  EXPECT_EQ(size, IVec2(16, 16));
}

TEST_F(ReplayOfAHall, SaysSoInJson) {
  const ProgramResult replayed = succeeded(replay({"--json", "--threads", "1"}));
  const nlohmann::json json = nlohmann::json::parse(replayed.output);
  EXPECT_EQ(json.at("approximate"), "");
  ASSERT_EQ(json.at("attempts").size(), 1U);
  const nlohmann::json attempt = json.at("attempts").at(0);
  EXPECT_EQ(attempt.at("films_compared"), 1);
  EXPECT_TRUE(attempt.at("first_difference").is_null());
  EXPECT_GT(attempt.at("samples").get<int>(), 0);
}

TEST_F(ReplayOfAHall, ThatIsAnotherFilmIsAnError) {
  change("session", "UPDATE session SET seed = '99'");
  const ProgramResult replayed = replay();
  EXPECT_EQ(replayed.exit_code, 1);
  EXPECT_THAT(replayed.output, HasSubstr("differs from frame"));
  EXPECT_THAT(replayed.errors, HasSubstr("1 of 1 replayed attempts differ"));
}

TEST_F(ReplayOfAHall, PicturesOfAnotherVersionAreNotCompared) {
  change("session", "UPDATE session SET program_version = '0.0.9', seed = '99'");
  const ProgramResult replayed = replay();
  EXPECT_EQ(replayed.exit_code, 0) << replayed.errors;
  EXPECT_THAT(replayed.output, AllOf(HasSubstr("Approximate: its pictures are of Foveola 0.0.9 ("),
                                     HasSubstr("samples: no film was compared\n")));
  const std::string study = (folder / "study.sqlite").string();
  expect_one_line(run({"study", "simulate", "hall", "--db", study, "--participants", "2"}), 1,
                  "has sessions by Foveola 0.0.9");
  EXPECT_EQ(value_of(study, "SELECT count(*) FROM session"), "1");
}

TEST_F(ReplayOfAHall, NamesTheEventThatIsAnotherOne) {
  const std::string number = value_of(
      folder / "study.sqlite", "SELECT sequence FROM event WHERE type = 'first_frame_presented'");
  change("event", "UPDATE event SET time_ns = time_ns + 1 WHERE sequence = " + number);
  const ProgramResult replayed = replay();
  EXPECT_EQ(replayed.exit_code, 1);
  EXPECT_THAT(replayed.output, HasSubstr("samples: bit-identical\n"));
  EXPECT_THAT(replayed.errors,
              HasSubstr("study.sqlite: event " + number + " is recorded as first_frame_presented"));
  EXPECT_THAT(nlohmann::json::parse(replay({"--json"}).output).at("difference"),
              StartsWith("event " + number));
}

TEST_F(ReplayOfAHall, NeedsTheSceneAsItWas) {
  std::string other = room_glb();
  other.replace(other.find("room"), 4, "hall");
  folder.write("real/hall.glb", other);
  const ProgramResult refused = replay();
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.errors, HasSubstr("another file as hall"));
}

TEST_F(ReplayOfAHall, NobodyElseHasNoneAndNoTrialIsMadeUp) {
  EXPECT_THAT(
      run({"study", "replay", (folder / "study.sqlite").string(), "--participant", "P9"}).errors,
      HasSubstr("has no session of participant P9"));
  EXPECT_THAT(replay({"--trial", "7"}).errors, HasSubstr("has no such attempt"));
}

}  // namespace
}  // namespace foveola::test
