#include "analysis/convergence/convergence_figures.h"

#include "tests/analysis/convergence/made_up_measurement.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

TEST(DrawConvergence, DrawsWhatHasPointsWithItsSlopes) {
  const std::vector<Figure> figures = draw_convergence(
      {made_up_measurement({{.name = "od"}, {.name = "fv:acuity=guenter", .decay = 1.5}}, 2)});
  ASSERT_EQ(figures.size(), 1U);
  EXPECT_EQ(figures[0].name, "error-1-rmse-5deg");
  EXPECT_THAT(figures[0].svg, HasSubstr("od, slope -0.50"));
  EXPECT_THAT(figures[0].svg, HasSubstr("fv:acuity=guenter, slope -0.75"));
  EXPECT_THAT(figures[0].svg, HasSubstr("aula, gaze 10,0"));
  EXPECT_THAT(figures[0].svg, HasSubstr("RMSE within 5 degrees"));
}

TEST(DrawConvergence, LeavesOutAConfigurationWithoutPoints) {
  const std::vector<Figure> figures = draw_convergence(
      {made_up_measurement({{.name = "od"}, {.name = "sparse", .per_pixel = 0.0}}, 1)});
  ASSERT_EQ(figures.size(), 1U);
  EXPECT_THAT(figures[0].svg, Not(HasSubstr("sparse")));
}

TEST(DrawConvergence, DrawsNothingOfNothing) {
  EXPECT_THAT(draw_convergence({made_up_measurement({{.name = "od", .per_pixel = 0.0}}, 1)}),
              IsEmpty());
}

TEST(DrawConvergence, HostileNamesStayText) {
  const std::vector<Figure> figures =
      draw_convergence({made_up_measurement({{.name = "</text><script>'`id`\n\"@x"}}, 1)});
  EXPECT_THAT(figures.at(0).svg, Not(HasSubstr("<script")));
}

}  // namespace
}  // namespace foveola::analysis
