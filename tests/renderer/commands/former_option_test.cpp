#include "renderer/commands/former_option.h"

#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace foveola {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::internal::CaptureStderr;
using testing::internal::GetCapturedStderr;

struct Parsed {
  int repetitions = 1;
  bool no_fast_path = false;
  std::vector<std::string> changes;
  std::string help;

  explicit Parsed(const std::string& line) {
    CLI::App app;
    CLI::Option* const number =
        app.add_option("--repetitions", repetitions)->check(CLI::Range(1, 9));
    accept_former_name(app, *number, "--rounds");
    CLI::Option* const flag = app.add_flag("--no-fast-path", no_fast_path);
    accept_former_name(app, *flag, "--no-skip");
    CLI::Option* const list = app.add_option("--changes", changes)->delimiter(',');
    accept_former_values(*list, {{"spare-done", "adaptive"}});
    help = app.help();
    app.parse(line);
  }
};

TEST(FormerOption, SaysWhatItIsCalledNow) {
  CaptureStderr();
  const Parsed parsed("--rounds 5 --no-skip");
  EXPECT_EQ(parsed.repetitions, 5);
  EXPECT_TRUE(parsed.no_fast_path);
  EXPECT_EQ(GetCapturedStderr(),
            "foveola: note: --rounds is now called --repetitions\n"
            "foveola: note: --no-skip is now called --no-fast-path\n");
}

TEST(FormerOption, SaysWhatItsValuesAreCalledNow) {
  CaptureStderr();
  EXPECT_THAT(Parsed("--changes clamp,spare-done").changes, ElementsAre("clamp", "adaptive"));
  EXPECT_EQ(GetCapturedStderr(), "foveola: note: --changes spare-done is now called adaptive\n");
}

TEST(FormerOption, IsCheckedAsUnderItsNewName) {
  CaptureStderr();
  EXPECT_THROW(Parsed("--rounds 10"), CLI::ValidationError);
  EXPECT_THROW(Parsed("--rounds five"), CLI::ParseError);
  GetCapturedStderr();
}

TEST(FormerOption, IsNotInTheHelp) {
  const std::string help = Parsed("").help;
  EXPECT_THAT(help, HasSubstr("--repetitions"));
  EXPECT_THAT(help, Not(HasSubstr("--rounds")));
}

TEST(FormerOption, IsSilentWhereItIsNotUsed) {
  CaptureStderr();
  EXPECT_EQ(Parsed("--repetitions 3").repetitions, 3);
  EXPECT_EQ(GetCapturedStderr(), "");
}

}  // namespace
}  // namespace foveola
