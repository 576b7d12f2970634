// The times of marks, against those of their keys in the X server.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/end_to_end/run/study_run.h"

namespace foveola::test {
namespace {

void print_lateness(const char* than, const std::vector<double>& marks_s,
                    const std::vector<KeyPress>& presses, double KeyPress::* since_s) {
  std::vector<double> late_ms;
  for (std::size_t i = 0; i < marks_s.size(); ++i) {
    late_ms.push_back(1e3 * (marks_s[i] - presses[i].*since_s));
  }
  std::sort(late_ms.begin(), late_ms.end());
  std::printf("%zu marks later than %s: median %.3f ms, 99th percentile %.3f, worst %.3f\n",
              late_ms.size(), than, late_ms[late_ms.size() / 2], late_ms[late_ms.size() * 99 / 100],
              late_ms.back());
}

TEST_F(StudyRun, AMarkHasTheTimeOfItsKey) {
  // With FOVEOLA_PRESSES set, prints how long after their keys so many marks are.
  const char* const asked = std::getenv("FOVEOLA_PRESSES");
  constexpr int marks_a_trial = 20;
  const int trials = std::max(1, (asked != nullptr ? std::atoi(asked) : 0) / marks_a_trial);
  std::string tables = short_look;
  for (int i = 0; i < marks_a_trial; ++i) {
    tables += "[[mark]]\nid = \"m" + std::to_string(i) + "\"\ninstruction = \"Press.\"\n";
  }
  for (int i = 1; i < trials; ++i) {
    tables += "[[practice]]\nscene = \"hall\"\nmethod = \"od\"\n";
  }
  participant_.write_protocol(one_trial_keys, tables);
  participant_.begin();
  participant_.answer_page("Return");  // welcome
  std::vector<KeyPress> presses;
  for (int trial = 0; trial < trials; ++trial) {
    const bool begins_a_kind = trial == 0 || trial == trials - 1;
    if (begins_a_kind && trials > 1) {
      participant_.answer_page("Return");  // practice, or from now on it counts
    }
    if (begins_a_kind) {
      participant_.answer_page("Return");  // choosing
    }
    for (const KeyPress& press : time_trial(marks_a_trial)) {
      presses.push_back(press);
    }
    rate("1");
  }
  end_by_enter();

  const std::vector<double> marks_s = recorded_marks();
  expect_marks_of(presses, marks_s);
  print_lateness("the X server's own time of their keys", marks_s, presses, &KeyPress::stamped_s);
  print_lateness("asking the X server for their keys", marks_s, presses, &KeyPress::asked_s);
}

}  // namespace
}  // namespace foveola::test
