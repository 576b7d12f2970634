// What happens when standard output takes nothing: it is full, closed, or nobody reads it.
#include <string>
#include <utility>
#include <vector>

#include "renderer/base/files/files.h"
#include "tests/end_to_end/program.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

/// The program with its standard output redirected as a shell does by `redirection`.
ProgramResult run_redirected(const std::vector<std::string>& arguments,
                             const std::string& redirection) {
  return run_program(
      joined({"sh", "-c", "exec \"$@\" " + redirection, "sh", FOVEOLA_PROGRAM}, arguments));
}

class StandardOutput : public testing::Test {
 protected:
  StandardOutput() {
    write_file(room(), room_gltf());
    for (const char* const name : {"a.png", "b.png"}) {
      EXPECT_EQ(run_foveola({"render", room(), "-o", path(name), "--size", "8x4", "--spp", "1"})
                    .exit_code,
                0);
    }
    EXPECT_EQ(run_foveola({"study", "simulate", "demo", "--participants", "1", "--predicted",
                           "--db", path("s.sqlite")})
                  .exit_code,
              0);
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string room() const { return path("room.gltf"); }

  const TemporaryFolder folder_;
};

TEST_F(StandardOutput, ThatTakesNothingIsAnErrorOfEveryCommand) {
  for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
           {"--help"},
           {"--version"},
           {"analyze", path("s.sqlite"), "-o", path("out")},
           {"compare", path("a.png"), path("b.png")},
           {"completion", "bash"},
           {"manual"},
           {"render", room(), "-o", path("a.png"), "--size", "8x4", "--spp", "1"},
           {"scene", "info", room()},
           {"scene", "list", "--json"},
           {"study", "check", "demo"},
           {"study", "keys"},
           {"study", "plan", "demo", "--participants", "2"},
           {"study", "status", path("s.sqlite")},
           {"study", "summary", path("s.sqlite"), "--participant", "P001"},
           {"study", "verify", path("s.sqlite"), "--json"},
           {"study", "watch", path("s.sqlite")},
           {"tracker", "list"}}) {
    for (const auto& [redirection, why] :
         {std::pair(">/dev/full", "No space left on device"), {">&-", "Bad file descriptor"}}) {
      const ProgramResult result = run_redirected(command, redirection);
      EXPECT_EQ(result.exit_code, 1) << command.front() << ' ' << redirection;
      EXPECT_THAT(result.errors,
                  EndsWith("foveola: error: standard output: cannot be "
                           "written: " +
                           std::string(why) + "; make room there, or print to another place\n"));
    }
  }
}

TEST_F(StandardOutput, ThatTakesNothingHidesNoOtherError) {
  expect_one_line(run_redirected({"study", "plan"}, ">/dev/full"), 2, "study plan --help");
  expect_one_line(run_redirected({"study", "status", path("none")}, ">&-"), 1, "no such file");
}

TEST_F(StandardOutput, ThatIsClosedIsNoFile) {
  EXPECT_EQ(run_redirected({"study", "simulate", "demo", "--participants", "1", "--predicted",
                            "--db", path("t.sqlite"), "--json"},
                           "<&- >&-")
                .exit_code,
            1);
  const ProgramResult verified = run_foveola({"study", "verify", path("t.sqlite")});
  EXPECT_EQ(verified.exit_code, 0) << verified.output << verified.errors;
}

TEST_F(StandardOutput, ThatNobodyReadsEndsTheProgramAsEverywhere) {
  // The reader has gone for certain: the shell was it.
  const ProgramResult result = run_program(
      {"sh", "-c",
       "mkfifo \"$1\" && exec 3<>\"$1\" 4>\"$1\" 3>&- && \"$0\" study keys >&4; echo $?",
       FOVEOLA_PROGRAM, path("pipe")});
  EXPECT_EQ(result.output, "141\n") << "128 + SIGPIPE";
}

}  // namespace
}  // namespace foveola::test
