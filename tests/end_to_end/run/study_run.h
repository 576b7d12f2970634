// A person's session in the real window, by keys.
#pragma once

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "tests/end_to_end/run/seated_participant.h"

namespace foveola::test {

/// A protocol's keys for one trial without anything before or after it.
inline constexpr const char* one_trial_keys = R"(
methods = ["od"]
phases = ["trials"]
)";

/// A protocol's table for a look around that takes no time to speak of.
inline constexpr const char* short_look = R"(
[timing]
rating_s = 0.2
)";

class StudyRun : public testing::Test {
 protected:
  /// From the page that asks whether the participant is ready to the one that says to look around.
  /// Returns the marks' keys.
  std::vector<KeyPress> time_trial(int marks = 2) {
    participant_.answer_page("space");
    std::vector<KeyPress> presses;
    for (int mark = 0; mark < marks; ++mark) {
      participant_.wait_for_page();
      std::this_thread::sleep_for(std::chrono::milliseconds(50 + mark * 37 % 90));
      presses.push_back(participant_.type("space"));
    }
    participant_.wait_for_page();
    return presses;
  }

  void rate(const std::string& point) {
    participant_.type("Return");
    participant_.wait_for_page();
    participant_.type_all({point, "Return", "Return"});
  }

  void end_by_enter() {
    participant_.answer_page("Return");
    EXPECT_EQ(participant_.program().wait_for_end(), 0);
  }

  /// In seconds of the session's clock.
  std::vector<double> recorded_marks() const {
    std::vector<double> marks_s;
    for (const std::string& time_ns :
         participant_.ask("SELECT time_ns FROM event WHERE type = 'marked' ORDER BY sequence")) {
      marks_s.push_back(1e-9 * std::stod(time_ns));
    }
    return marks_s;
  }

  /// A mark's time is within a millisecond of when the X server took its key.
  static void expect_marks_of(const std::vector<KeyPress>& presses,
                              const std::vector<double>& marks_s) {
    constexpr double servers_resolution_s = 1e-3;
    ASSERT_EQ(marks_s.size(), presses.size());
    for (std::size_t i = 0; i < presses.size(); ++i) {
      EXPECT_GT(marks_s[i], presses[i].asked_s - servers_resolution_s) << i;
      EXPECT_LT(marks_s[i], presses[i].taken_s + servers_resolution_s) << i;
    }
  }

  SeatedParticipant participant_;
};

}  // namespace foveola::test
