#include "study/record/log/event_json.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "study/record/setup/session_devices.h"
#include "tests/study/record/small_study.h"

namespace foveola::study {
namespace {

/// One event of every kind, with values that are not their defaults. Payloads by hand.
/// (From a function: GCC 12 takes a quarter of a minute to compile a global of them.)
std::vector<std::pair<Event, std::string>> one_of_every_kind() {
  return {
      {SessionStarted{}, "{}"},
      {ConsentGiven{.text_sha256 = "ab", .language = "fi"},
       R"({"text_sha256":"ab","language":"fi"})"},
      {QuestionnaireAnswered{.questionnaire = "ssq",
                             .answers = {{.question = "a", .value = 0.1, .response = ms(1500)},
                                         {.question = "b", .value = "two\nlines, \"so\""}}},
       R"({"questionnaire":"ssq","answers":[{"question":"a","value":0.1,"response_ns":1500000000},)"
       R"({"question":"b","value":"two\nlines, \"so\""}]})"},
      {ReactionPressed{.shown = ms(5), .time = ms(4)}, R"({"shown_ns":5000000,"time_ns":4000000})"},
      {ObjectChosen{.object = "Väse"}, R"({"object":"Väse"})"},
      {TrialStarted{}, "{}"},
      {FirstFramePresented{.time = Nanoseconds(1)}, R"({"time_ns":1})"},
      {Marked{.time = Nanoseconds(2)}, R"({"time_ns":2})"},
      {TimedOut{.time = Nanoseconds(9'007'199'254'740'993)}, R"({"time_ns":9007199254740993})"},
      {Rated{.answers = {{.question = "artifacts", .value = 3.0}}, .looked_around = ms(4)},
       R"({"answers":[{"question":"artifacts","value":3.0}],"looked_around_ns":4000000})"},
      {RetimeRequested{}, "{}"},
      {PauseRequested{}, "{}"},
      {Interrupted{}, "{}"},
      {Resumed{}, "{}"},
      {NoteWritten{.text = "coughs"}, R"({"text":"coughs"})"},
      {Withdrawn{}, "{}"},
      {Excluded{.reason = "asleep"}, R"({"reason":"asleep"})"},
      {EndUndone{}, "{}"},
      {ConsentAsked{}, "{}"}};
}

TEST(EventJson, IsWhatTheSchemaSays) {
  for (const auto& [event, payload] : one_of_every_kind()) {
    EXPECT_EQ(payload_of(event), payload) << name_of(event);
  }
}

TEST(EventJson, GivesEveryEventBack) {
  const auto events = one_of_every_kind();
  EXPECT_EQ(events.size() + 1, std::variant_size_v<Event>) << "but for the validation, below";
  for (const auto& [event, payload] : events) {
    const Event back = event_from(name_of(event), payload);
    EXPECT_EQ(back.index(), event.index());
    EXPECT_EQ(payload_of(back), payload) << name_of(event);
  }
  const Event answered = event_from("questionnaire_answered", events[2].second);
  EXPECT_EQ(std::get<QuestionnaireAnswered>(answered).answers,
            std::get<QuestionnaireAnswered>(events[2].first).answers);
}

// Of 0.1.0, which knew no text of it.
TEST(EventJson, AConsentMaySayNothing) {
  const Event consent = event_from("consent_given", "{}");
  EXPECT_EQ(std::get<ConsentGiven>(consent).text_sha256, "");
  EXPECT_EQ(payload_of(consent), "{}");
}

TEST(EventJson, GivesAValidationBackToTheBit) {
  GazeRun run = good_run();
  run.quality.targets[0].direction = {0.1F, 1.0F / 3.0F, -0.9F};
  run.quality.targets[0].seen->mean_gaze = {0.3F, 1e-30F, -0.7F};
  run.quality.figures->accuracy_deg = 1.0 / 3.0;
  run.correction->azimuth = {0.1, 1.0 / 7.0, 1e-300};
  const GazeValidated validated{.runs = {bad_run(), run}, .passed = true};
  const Event event = event_from("gaze_validated", payload_of(validated));
  const auto& back = std::get<GazeValidated>(event);
  EXPECT_TRUE(back.passed);
  ASSERT_EQ(back.runs.size(), 2U);
  const GazeRun& same = back.runs[1];
  EXPECT_EQ(same.passed, run.passed);
  EXPECT_EQ(same.correction, run.correction);
  EXPECT_EQ(same.quality.figures->accuracy_deg, run.quality.figures->accuracy_deg);
  EXPECT_EQ(same.quality.figures->precision_sd_deg, run.quality.figures->precision_sd_deg);
  ASSERT_EQ(same.quality.targets.size(), 1U);
  EXPECT_EQ(same.quality.targets[0].direction, run.quality.targets[0].direction);
  EXPECT_EQ(same.quality.targets[0].seen->mean_gaze, run.quality.targets[0].seen->mean_gaze);
  EXPECT_EQ(same.quality.targets[0].seen->samples, 120U);
  EXPECT_FALSE(back.runs[0].correction);
  EXPECT_FALSE(back.runs[0].quality.targets[1].seen);
}

TEST(EventJson, RefusesWhatNoEventSays) {
  EXPECT_THROW(event_from("sneezed", "{}"), std::invalid_argument);
  EXPECT_THROW(event_from("marked", "{}"), std::invalid_argument);
  EXPECT_THROW(event_from("marked", R"({"time_ns":"soon"})"), std::invalid_argument);
  EXPECT_THROW(event_from("marked", "{"), std::invalid_argument);
  EXPECT_THROW(event_from("rated", R"({"answers":[],"looked_around_ns":0})"),
               std::invalid_argument);
}

// As deep as a file can say: a call for each level would end the program.
TEST(EventJson, RefusesWhatIsNestedDeeply) {
  constexpr std::size_t levels = 1'000'000;
  for (const std::string& nested :
       {std::string(levels, '['), std::string(levels, '[') + '0' + std::string(levels, ']')}) {
    EXPECT_THROW(event_from("marked", "{\"time_ns\":" + nested + "}"), std::invalid_argument);
    EXPECT_THROW(event_from("rated", "{\"answers\":" + nested + "}"), std::invalid_argument);
    EXPECT_EQ(field_of_view_in("{\"display\":" + nested + "}"), std::nullopt);
  }
}

TEST(EventJson, ReplacesWhatIsNoUnicode) {
  EXPECT_EQ(payload_of(NoteWritten{.text = "v\xff"}), "{\"text\":\"v\xEF\xBF\xBD\"}");
  EXPECT_EQ(payload_of(NoteWritten{.text = "Väse"}), "{\"text\":\"Väse\"}");
}

}  // namespace
}  // namespace foveola::study
