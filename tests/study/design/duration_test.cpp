#include "study/design/duration.h"

#include "tests/matchers.h"
#include "tests/study/design/small_protocol.h"

namespace foveola::study {
namespace {

/// The assumption that begins so.
Duration assumed(std::string_view of) {
  for (const AssumedDuration& assumption : assumed_durations()) {
    if (assumption.of.starts_with(of)) {
      return assumption.duration;
    }
  }
  ADD_FAILURE() << of;
  return {};
}

const SessionPart& part_of(const std::vector<SessionPart>& parts, std::string_view name) {
  for (const SessionPart& part : parts) {
    if (part.name == name) {
      return part;
    }
  }
  throw std::out_of_range(std::string(name));
}

class DurationOfASession : public testing::Test {
 protected:
  DurationOfASession() {
    protocol_.timing = {.mark_timeout_s = 100.0, .rating_s = 4.0};
    protocol_.marks = {{.id = "outline"}, {.id = "material"}};
    protocol_.ratings = {{.id = "artifacts"}};
  }

  Protocol protocol_ = test::small_protocol(2, 3, Order::random, Order::random);
};

// 2 scenes of 3 methods: 2 choices; 6 times getting ready, two marks, looking around, a rating.
TEST_F(DurationOfASession, TrialsTakeTheirPartsTogether) {
  const std::vector<SessionPart> parts = session_parts(protocol_);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].count, 6);
  const Duration choice = assumed("choosing");
  const Duration ready = assumed("getting ready");
  const Duration mark = assumed("a mark");
  const Duration answer = assumed("an answer on a scale");
  EXPECT_DOUBLE_EQ(
      parts[0].duration.least_s,
      2 * choice.least_s + 6 * (ready.least_s + 2 * mark.least_s + 4.0 + answer.least_s));
  EXPECT_DOUBLE_EQ(parts[0].duration.most_s,
                   2 * choice.most_s + 6 * (ready.most_s + 100.0 + 4.0 + answer.most_s));
}

TEST_F(DurationOfASession, AnObjectForEachMethodTakesLonger) {
  const double once = total_of(session_parts(protocol_)).least_s;
  protocol_.object_choice = ObjectChoice::per_method;
  EXPECT_DOUBLE_EQ(total_of(session_parts(protocol_)).least_s - once,
                   4 * assumed("choosing").least_s);
}

TEST_F(DurationOfASession, OverridesCount) {
  const double before = total_of(session_parts(protocol_)).most_s;
  protocol_.cells[{"b", "y"}] = {.timing = {.mark_timeout_s = 160.0, .rating_s = 4.0}};
  EXPECT_DOUBLE_EQ(total_of(session_parts(protocol_)).most_s - before, 60.0);
}

TEST_F(DurationOfASession, PhasesComeInTheirOrder) {
  using Kind = PhaseEntry::Kind;
  protocol_.phases = {
      {Kind::validation}, {Kind::reaction}, {Kind::trials}, {Kind::questionnaire, "debrief"}};
  protocol_.tracker.validation = ValidationSettings{.points = 5, .attempts = 3};
  protocol_.reaction = ReactionSettings{.presses = 10, .shortest_wait_s = 1, .longest_wait_s = 3};
  protocol_.catch_trials = {.count = 2, .timeout_s = 8.0};
  protocol_.practice = {{.scene = "a", .method = "x"}};
  protocol_.questionnaires = {
      {.id = "debrief",
       .questions = {{.id = "one"}, {.id = "two", .kind = QuestionKind::text, .required = false}}}};
  const std::vector<SessionPart> parts = session_parts(protocol_);
  std::vector<std::string> names;
  for (const SessionPart& part : parts) {
    names.push_back(part.name);
  }
  EXPECT_THAT(names, ElementsAre("validation", "reaction", "practice", "trials", "catch trials",
                                 "debrief"));
  const Duration target = assumed("a target");
  EXPECT_DOUBLE_EQ(part_of(parts, "validation").duration.least_s, 5 * target.least_s);
  EXPECT_DOUBLE_EQ(part_of(parts, "validation").duration.most_s, 3 * 5 * target.most_s);
  EXPECT_DOUBLE_EQ(part_of(parts, "reaction").duration.least_s,
                   10 * (1.0 + assumed("a press").least_s));
  EXPECT_DOUBLE_EQ(part_of(parts, "catch trials").duration.most_s,
                   2 * (8.0 + assumed("getting ready").most_s));
  EXPECT_DOUBLE_EQ(part_of(parts, "debrief").duration.least_s,
                   assumed("an answer on a scale").least_s);
  EXPECT_DOUBLE_EQ(part_of(parts, "debrief").duration.most_s,
                   assumed("an answer on a scale").most_s + assumed("an answer in words").most_s);
}

}  // namespace
}  // namespace foveola::study
