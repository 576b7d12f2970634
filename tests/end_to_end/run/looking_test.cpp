// Whether a participant sees and looks at the trial's object, and what is said and done if not.
#include <chrono>
#include <cmath>
#include <thread>

#include <SQLiteCpp/Database.h>

#include "renderer/base/angles.h"
#include "study/record/read/recorded_frames.h"
#include "study/record/sqlite/database.h"
#include "tests/end_to_end/run/study_run.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

class Looking : public StudyRun {
 protected:
  /// Until the participant is asked whether they are ready, with the wall ahead as the object.
  void choose_wall(const std::string& keys, const std::string& tables) {
    participant_.write_protocol(keys, tables + short_look);
    participant_.begin();
    participant_.begin_trials();
  }

  /// The view is 16 degrees wide, and a keystroke turns it by more than two.
  void turn_away() { participant_.type_all(std::vector<std::string>(10, "Right")); }

  void start_and_mark(int marks) {
    participant_.type("space");
    for (int mark = 0; mark < marks; ++mark) {
      EXPECT_EQ(participant_.wait_for_page(), "marking");
      std::this_thread::sleep_for(std::chrono::milliseconds(150));
      participant_.type("space");
    }
  }

  Rows notes() const { return participant_.ask("SELECT text FROM note ORDER BY sequence"); }
  Rows outcomes() const {
    return participant_.ask("SELECT attempt, object, outcome FROM attempt ORDER BY attempt");
  }
};

TEST_F(Looking, AMarkWithTheObjectOutOfViewIsNoted) {
  choose_wall(one_trial_keys, "");
  EXPECT_EQ(participant_.wait_for_page(), "ready");
  turn_away();
  start_and_mark(1);
  EXPECT_THAT(participant_.program().wait_for("outline was marked while"),
              HasSubstr("the object, Wall, was out of view"));
  EXPECT_EQ(participant_.wait_for_page(), "marking") << "goes on";
  participant_.type("space");
  participant_.wait_for_page();
  rate("3");
  end_by_enter();
  EXPECT_THAT(outcomes(), ElementsAre("1|Wall|rated"));
  EXPECT_THAT(notes(), ElementsAre(HasSubstr("outline was marked while"),
                                   HasSubstr("material was marked while")));
}

TEST_F(Looking, OneThatAProtocolWantsAgainIsTimedAgainTwiceAtMost) {
  choose_wall(one_trial_keys, "[looking]\nobject_out_of_view = \"retime\"\n");
  for (int attempt = 1; attempt <= 2; ++attempt) {
    EXPECT_EQ(participant_.wait_for_page(), "ready") << "the view is turned to the object again";
    turn_away();
    start_and_mark(1);
    participant_.program().wait_for("out of view");
    participant_.program().wait_for("retimed");
  }
  EXPECT_EQ(participant_.wait_for_page(), "ready");
  turn_away();
  start_and_mark(2);
  participant_.wait_for_page();
  rate("3");
  end_by_enter();
  EXPECT_THAT(outcomes(), ElementsAre("1|Wall|retimed", "2|Wall|retimed", "3|Wall|rated"));
}

TEST_F(Looking, AGazeElsewhereIsTimedAgainWhereAProtocolWantsIt) {
  choose_wall("methods = [\"fv\"]\nphases = [\"trials\"]\n",
              "[looking]\ngaze_elsewhere = \"retime\"\n");
  EXPECT_EQ(participant_.wait_for_page(), "ready");
  participant_.point_at(4, 4);
  start_and_mark(2);
  EXPECT_THAT(participant_.program().wait_for("the gaze was not on the object, Wall"),
              HasSubstr("the trial is retimed"));
  EXPECT_EQ(participant_.wait_for_page(), "ready");
  participant_.point_at(320, 240);
  start_and_mark(2);
  participant_.wait_for_page();
  rate("3");
  end_by_enter();
  EXPECT_THAT(outcomes(), ElementsAre("1|Wall|retimed", "2|Wall|rated"));
  EXPECT_EQ(notes().size(), 1U);
}

TEST_F(Looking, AfterAResumptionTheViewIsTheTrialsOwn) {
  participant_.write_protocol(one_trial_keys, short_look);
  participant_.begin();
  participant_.answer_page("Return");  // welcome
  participant_.wait_for_page();        // choosing: the wall is ahead, Tab goes on to the lamp
  participant_.type_all({"Tab", "Return"});
  EXPECT_EQ(participant_.wait_for_page(), "ready");
  participant_.quit();

  participant_.begin({"--resume"});
  time_trial();
  rate("3");
  end_by_enter();
  SQLite::Database frames = study::open_study_to_read(participant_.database());
  const std::vector<study::FrameRow> rows = study::frames_of(frames, 1, 0, 1);
  ASSERT_FALSE(rows.empty());
  const double lamps_elevation_rad = std::atan2(0.9, 0.5);
  EXPECT_NEAR(rows.front().head_elevation_rad, lamps_elevation_rad, radians(0.5));
}

}  // namespace
}  // namespace foveola::test
