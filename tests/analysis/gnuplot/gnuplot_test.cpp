#include "analysis/gnuplot/gnuplot.h"

#include <cstdlib>
#include <filesystem>

#include "renderer/base/error.h"
#include "tests/matchers.h"
#include "tests/temporary_folder.h"

namespace foveola::analysis {
namespace {

TEST(Gnuplot, PrintsWhatTheScriptDraws) {
  EXPECT_THAT(run_gnuplot("set terminal svg\nplot [0:1] x\n"),
              AllOf(HasSubstr("<svg"), HasSubstr("</svg>")));
}

TEST(Gnuplot, AnErrorInTheScriptIsAnError) {
  EXPECT_THAT([] { (void)run_gnuplot("plot [0:1] nonsense(x)\n"); },
              ThrowsMessage<Error>(AllOf(HasSubstr("gnuplot"), HasSubstr("nonsense"))));
}

TEST(Gnuplot, QuotedTextIsNeitherRunNorExpanded) {
  const std::string label = "it's `echo run` @macro \"x\" \\n %d\nend";
  const std::string svg =
      run_gnuplot("macro = 'expanded'\nset terminal svg noenhanced\nset label " +
                  gnuplot_quoted(label) + " at 0.5,0.5\nplot [0:1] x\n");
  EXPECT_THAT(svg, HasSubstr("it's `echo run` @macro \"x\" \\n %d end"));
}

TEST(Gnuplot, ALabelOfATickIsNoFormat) {
  const std::string label = "50 % ; 100 %d %% it's";
  const std::string svg = run_gnuplot("set terminal svg noenhanced\nset ytics (" +
                                      gnuplot_tick_label(label) + " 0.5)\nplot [0:1] x\n");
  EXPECT_THAT(svg, HasSubstr(label));
}

/// Sets PATH for the length of a test.
class PathWithoutPrograms : public testing::Test {
 protected:
  void SetUp() override { ::setenv("PATH", "/nonexistent", 1); }
  void TearDown() override { ::setenv("PATH", before_.c_str(), 1); }

 private:
  std::string before_ = std::getenv("PATH");
};

TEST_F(PathWithoutPrograms, AMissingGnuplotIsAnErrorWithARemedy) {
  EXPECT_THAT([] { (void)run_gnuplot("plot x\n"); },
              ThrowsMessage<Error>(
                  AllOf(HasSubstr("cannot be started"), HasSubstr("install gnuplot-nox"))));
}

/// As one without its terminals, or a wrapper that hides a failure.
TEST_F(PathWithoutPrograms, AGnuplotThatDrawsNothingIsAnError) {
  const test::TemporaryFolder folder;
  folder.write("gnuplot", "#!/bin/sh\n");
  std::filesystem::permissions(folder / "gnuplot", std::filesystem::perms::owner_all);
  ::setenv("PATH", folder.path().c_str(), 1);
  EXPECT_THAT([] { (void)drawn_figure("x", 100, 100, "plot x\n"); },
              ThrowsMessage<Error>(HasSubstr("drew nothing")));
}

}  // namespace
}  // namespace foveola::analysis
