// What the commands that begin a study say of its analysis.
#include "study/stage/analysable.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "study/person/run_person.h"
#include "tests/study/simulation/small_wall.h"

namespace foveola::study {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::ThrowsMessage;

/// A study of the wall whose artifacts are rated from 0 to 100.
class UnanalysableStudy : public testing::Test {
 protected:
  UnanalysableStudy() {
    folder_.write("wall.toml",
                  wall_protocol_text(20'000, 8.0) +
                      "[[rating]]\nid = \"artifacts\"\ntext = \"?\"\nminimum = 0\nmaximum = 100\n");
  }

  /// Comes to an end before anybody takes part, since a simulated eye is nobody's.
  void run() const {
    run_person({.protocol = folder_ / "wall.toml",
                .database = folder_ / "study.sqlite",
                .participant = "P1",
                .tracker = "simulated"},
               [this](const std::string&) { return wall_with_a_square(folder_); }, {});
  }

  test::TemporaryFolder folder_;
};

TEST_F(UnanalysableStudy, IsNotBegun) {
  EXPECT_THAT([this] { require_analysable(load_protocol(folder_ / "wall.toml")); },
              ThrowsMessage<Error>(HasSubstr("is a scale from 0 to 100")));
  EXPECT_THAT([this] { run(); }, ThrowsMessage<Error>(HasSubstr("is a scale from 0 to 100")));
}

TEST_F(UnanalysableStudy, GoesOnWithAWarningIfItWasBegunBeforeSuchWereRefused) {
  const StudyStore begun(folder_ / "study.sqlite", load_protocol(folder_ / "wall.toml"));
  testing::internal::CaptureStderr();
  EXPECT_THAT([this] { run(); }, ThrowsMessage<Error>(AllOf(HasSubstr("is of a simulated eye"),
                                                            Not(HasSubstr("100")))));
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              AllOf(HasSubstr("foveola: warning: "), HasSubstr("is a scale from 0 to 100")));
}

}  // namespace
}  // namespace foveola::study
