#include "analysis/koskela2018/machine_speed.h"

#include <cmath>
#include <optional>
#include <utility>

#include "renderer/base/error.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

ComparedNumber cell(const std::string& scene, const std::string& mark, double published,
                    std::optional<double> study, const std::string& method = "od") {
  ComparedNumber number;
  number.source = "Table 2";
  number.row = scene;
  number.mark = mark;
  number.method = method;
  number.published.value = published;
  if (study) {
    number.study = Estimate{.n = 16, .value = *study, .interval = std::nullopt};
  }
  return number;
}

/// How long a scene's mark takes on a machine: a reaction, and the wait for so many samples.
struct MadeUpCell {
  std::string scene;
  std::string mark;
  double published_s;
  double samples;
};

class Studies {
 public:
  explicit Studies(std::vector<MadeUpCell> cells, double reaction_s = 0.0)
      : cells_(std::move(cells)), reaction_s_(reaction_s) {}

  CompareAtSpeed compare() {
    return [this](double speed) {
      ++simulated_;
      std::vector<ComparedNumber> numbers;
      for (const MadeUpCell& made_up : cells_) {
        numbers.push_back(cell(made_up.scene, made_up.mark, made_up.published_s,
                               reaction_s_ + made_up.samples / speed));
        numbers.push_back(cell(made_up.scene, made_up.mark, 10.0, 1e3 * speed, "fv"));
      }
      return numbers;
    };
  }

  int simulated() const { return simulated_; }

 private:
  std::vector<MadeUpCell> cells_;
  double reaction_s_;
  int simulated_ = 0;
};

TEST(MachineSpeed, OfTimesThatAreAllWaitingIsFoundAtOnce) {
  Studies studies({{"bmw", "outline", 10.0, 4e6}, {"sponza", "outline", 20.0, 8e6}});
  const MachineSpeed speed = fit_machine_speed(studies.compare(), 7e6);
  EXPECT_NEAR(speed.samples_per_second, 4e5, 1.0);
  EXPECT_FALSE(speed.interval) << "the scenes do not differ";
  EXPECT_LE(studies.simulated(), 3);
}

// Two scenes, of which one takes half and the other twice the published time at the fitted speed:
// logarithms of -ln 2 and ln 2 have a standard error of ln 2, and t of one degree of freedom is
// 12.706 at 97.5 %.
TEST(MachineSpeed, HasAnIntervalOverScenes) {
  Studies studies({{"bmw", "outline", 10.0, 2e6}, {"sponza", "outline", 10.0, 8e6}});
  const MachineSpeed speed = fit_machine_speed(studies.compare(), 1e6);
  EXPECT_NEAR(speed.samples_per_second, 4e5, 1.0);
  ASSERT_TRUE(speed.interval);
  EXPECT_NEAR(std::log(speed.interval->high / 4e5), 12.706205 * std::log(2.0), 1e-4);
  EXPECT_NEAR(std::log(speed.interval->low / 4e5), -12.706205 * std::log(2.0), 1e-4);
}

// With a reaction of 5 of 10 s a faster machine saves half as much, so that the same scatter leaves
// twice the range of speeds.
TEST(MachineSpeed, IsFoundWherePartOfTheTimeIsNoWaiting) {
  Studies studies({{"bmw", "outline", 10.0, 2e6}, {"sponza", "outline", 10.0, 2e6}}, 5.0);
  EXPECT_NEAR(fit_machine_speed(studies.compare(), 7e6).samples_per_second, 4e5, 0.01 * 4e5);
  Studies scattered({{"bmw", "outline", 10.0 / 1.1, 2e6}, {"sponza", "outline", 11.0, 2e6}}, 5.0);
  const MachineSpeed speed = fit_machine_speed(scattered.compare(), 7e6);
  ASSERT_TRUE(speed.interval);
  // The slope is a chord's over a tenth, which bends the range a little.
  EXPECT_NEAR(std::log(speed.interval->high / speed.samples_per_second),
              12.706205 * std::log(1.1) / 0.488, 0.02);
}

TEST(MachineSpeed, OfOneMarkLeavesTheOtherOut) {
  Studies studies({{"bmw", "outline", 10.0, 2e6}, {"bmw", "material", 10.0, 8e6}});
  EXPECT_NEAR(fit_machine_speed(studies.compare(), 1e6, "outline").samples_per_second, 2e5, 1.0);
  EXPECT_NEAR(fit_machine_speed(studies.compare(), 1e6, "material").samples_per_second, 8e5, 1.0);
  EXPECT_NEAR(fit_machine_speed(studies.compare(), 1e6).samples_per_second, 4e5, 1.0);
}

TEST(MachineSpeed, AScenesMarksAreOneValueOfTheScatter) {
  const std::vector<double> ratios =
      log_ratios_of_scenes({cell("sponza", "outline", 1.0, 2.0), cell("bmw", "outline", 1.0, 3.0),
                            cell("sponza", "material", 1.0, 8.0)});
  EXPECT_THAT(ratios, ElementsAre(DoubleEq(std::log(4.0)), DoubleEq(std::log(3.0))));
}

TEST(MachineSpeed, NeedsEveryCell) {
  const CompareAtSpeed compare = [](double) {
    return std::vector{cell("bmw", "outline", 1.0, 2.0), cell("sponza", "outline", 1.0, {})};
  };
  EXPECT_THAT([&] { fit_machine_speed(compare, 1e6); },
              ThrowsMessage<Error>(HasSubstr("no times with OD to the mark outline in sponza")));
  EXPECT_THAT([&] { fit_machine_speed(compare, 1e6, "texture"); },
              ThrowsMessage<Error>(HasSubstr("no times with OD to the mark 'texture'")));
}

TEST(MachineSpeed, IsNotGuessedWhereTimesDoNotDependOnIt) {
  int studies = 0;
  const CompareAtSpeed constant = [&](double) {
    ++studies;
    return std::vector{cell("bmw", "outline", 1.0, 2.0), cell("sponza", "outline", 1.0, 2.0)};
  };
  EXPECT_THAT([&] { fit_machine_speed(constant, 1e6); },
              ThrowsMessage<Error>(HasSubstr("no speed was found in 13 studies")));
  EXPECT_EQ(studies, 13);
  const CompareAtSpeed published = [](double) {
    return std::vector{cell("bmw", "outline", 1.0, 1.0), cell("sponza", "outline", 1.0, 1.0)};
  };
  EXPECT_THAT([&] { fit_machine_speed(published, 1e6); },
              ThrowsMessage<Error>(HasSubstr("does not make times shorter")));
}

}  // namespace
}  // namespace foveola::analysis
