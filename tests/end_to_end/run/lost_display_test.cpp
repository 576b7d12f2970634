// The X server goes away under the window: one line, and what was recorded stays.
#include <string>

#include "tests/end_to_end/run/study_run.h"
#include "tests/end_to_end/running_program.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

/// That the display broke is the last line that was said, and the only one about it.
void expect_last_line(const std::string& said, const std::string& remedy) {
  const std::size_t begin = said.find("foveola: error: ");
  ASSERT_NE(begin, std::string::npos) << said;
  EXPECT_THAT(said.substr(begin),
              AllOf(MatchesRegex("foveola: error: window: the connection to the display broke; "
                                 "[^\n]*\n"),
                    HasSubstr(remedy)));
  for (const char* const xlibs_own : {"XIO", "X connection", "X server"}) {
    EXPECT_EQ(said.find(xlibs_own), std::string::npos) << said;
  }
}

TEST(LostDisplay, EndsThePreviewWithOneLine) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("room.gltf", room_gltf()).string();
  XServer server;
  RunningProgram program({"preview", scene, "--size", "512x256", "--window", "200x160"});
  XUser(server.display()).point_at("Foveola: " + scene, 100, 80);
  server.kill();
  EXPECT_EQ(program.wait_for_end(), 1);
  expect_last_line(program.said(), "start it again where there is one");
}

TEST_F(StudyRun, ALostDisplayEndsItWithOneLineAndItGoesOn) {
  participant_.write_protocol(one_trial_keys, short_look);
  participant_.begin({"--pilot"});
  EXPECT_EQ(participant_.wait_for_page(), "choosing_object");
  participant_.take_display_away();
  EXPECT_EQ(participant_.program().wait_for_end(), 1);
  expect_last_line(participant_.program().said(), "what P1 did up to then is in " +
                                                      participant_.database().string() +
                                                      ": repeat the command with --resume");
  EXPECT_THAT(participant_.ask("SELECT state FROM session"), ElementsAre("choosing_object"));
  EXPECT_EQ(participant_.status().exit_code, 0);
}

}  // namespace
}  // namespace foveola::test
