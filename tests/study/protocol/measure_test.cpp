#include "study/protocol/measure.h"

#include <utility>

#include "study/protocol/reading/read_procedure.h"
#include "tests/matchers.h"

namespace foveola::study {
namespace {

Measure rating_of(const Question& question) {
  return {.kind = MeasureKind::rating, .questionnaire = {}, .question = question};
}

Measure scale_of(double minimum, double maximum, const std::vector<std::string>& labels = {}) {
  return rating_of({.id = "x", .minimum = minimum, .maximum = maximum, .labels = labels});
}

Measure choice_of(const std::vector<Option>& options) {
  return rating_of({.id = "x", .kind = QuestionKind::choice, .options = options});
}

TEST(Measure, OfTrialsAreMarksThenRatings) {
  const std::vector<Measure> measures = trial_measures(published_marks(), published_ratings());
  ASSERT_EQ(measures.size(), 3U);
  EXPECT_EQ(measures[0].id(), "outline");
  EXPECT_EQ(measures[0].kind, MeasureKind::time);
  EXPECT_EQ(measures[0].unit(), "s");
  EXPECT_EQ(measures[1].id(), "material");
  EXPECT_EQ(measures[2].id(), "artifacts");
  EXPECT_EQ(measures[2].kind, MeasureKind::rating);
  EXPECT_EQ(measures[2].unit(), "points");
}

TEST(Measure, TimesAreNumbersWithoutPoints) {
  const Measure time = trial_measures(published_marks(), {}).front();
  EXPECT_TRUE(time.is_numeric());
  EXPECT_THAT(time.points(), IsEmpty());
  EXPECT_EQ(scale_in_words(time), "in seconds");
}

TEST(Measure, OfQuestionnairesAreTheirQuestions) {
  Questionnaire form;
  form.id = "mood";
  form.questions = {{.id = "ease"}, {.id = "remarks", .kind = QuestionKind::text}};
  const std::vector<Measure> measures = measures_of(form);
  ASSERT_EQ(measures.size(), 2U);
  EXPECT_EQ(measures[0].kind, MeasureKind::answer);
  EXPECT_EQ(measures[0].questionnaire, "mood");
  EXPECT_EQ(measures[1].id(), "remarks");
  EXPECT_FALSE(measures[1].is_numeric());
}

TEST(Measure, PointsOfAScaleAreItsWholeNumbers) {
  EXPECT_THAT(scale_of(1, 5).points(), ElementsAre(1, 2, 3, 4, 5));
  EXPECT_THAT(scale_of(-1, 1).points(), ElementsAre(-1, 0, 1));
  EXPECT_EQ(scale_of(1, 20).points().size(), 20U);
  EXPECT_THAT(scale_of(0, 20).points(), IsEmpty());
  EXPECT_THAT(scale_of(0, 100).points(), IsEmpty());
  EXPECT_TRUE(scale_of(0, 100).is_numeric());
}

TEST(Measure, PointsOfAChoiceAreItsValuesIfAllHaveOne) {
  const Measure choice = choice_of({{"none", 0.0}, {"a little", 0.5}, {"much", 3.0}});
  EXPECT_TRUE(choice.is_numeric());
  EXPECT_THAT(choice.points(), ElementsAre(0.0, 0.5, 3.0));
  EXPECT_EQ(choice.label_of(0.5), "a little");
  EXPECT_EQ(choice.label_of(1.0), "");
  EXPECT_EQ(choice.unit(), "");
  const Measure in_words = choice_of({{"left", std::nullopt}, {"right", 1.0}});
  EXPECT_FALSE(in_words.is_numeric());
  EXPECT_THAT(in_words.points(), IsEmpty());
}

TEST(Measure, LabelsAreOfTheEndsOrOfEachPoint) {
  const Measure ends = scale_of(1, 5, {"none", "all over"});
  EXPECT_EQ(ends.label_of(1), "none");
  EXPECT_EQ(ends.label_of(3), "");
  EXPECT_EQ(ends.label_of(5), "all over");
  const Measure each = scale_of(0, 2, {"a", "b", "c"});
  EXPECT_EQ(each.label_of(0), "a");
  EXPECT_EQ(each.label_of(2), "c");
  EXPECT_EQ(each.label_of(3), "");
  EXPECT_EQ(scale_of(1, 5).label_of(1), "");
}

TEST(Measure, ScalesAreSaidInWords) {
  std::vector<std::string> each;
  for (int point = 0; point <= 30; ++point) {
    each.push_back("p" + std::to_string(point));
  }
  const std::vector<std::pair<Measure, std::string>> cases = {
      {scale_of(1, 5), "1 to 5"},
      {scale_of(1, 5, {"keine", "überall"}), "1 keine to 5 überall"},
      {scale_of(1, 3, {"a", "b", "c"}), "1 (a), 2 (b), 3 (c)"},
      {scale_of(0, 30, each), "0 p0 to 30 p30"},
      {choice_of({{"none", 0.0}, {"a little", 0.5}}), "0 (none), 0.5 (a little)"},
      {choice_of({{"left", std::nullopt}, {"right", 1.0}}), "a choice"},
      {rating_of({.id = "x", .kind = QuestionKind::number, .minimum = 0.0, .maximum = 99.5}),
       "a number from 0 to 99.5"},
      {rating_of({.id = "x", .kind = QuestionKind::text}), "in words"},
      {rating_of(published_ratings().front()), "1 none to 5 not discernible at all"}};
  for (const auto& [measure, words] : cases) {
    EXPECT_EQ(scale_in_words(measure), words);
  }
}

}  // namespace
}  // namespace foveola::study
