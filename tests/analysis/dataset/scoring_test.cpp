// Scores computed by hand from the published keys.
#include "analysis/dataset/scoring.h"

#include <map>

#include "tests/analysis/made_up_study.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

using Items = std::vector<std::pair<std::string, double>>;

const Items ssq_answers = {{"general_discomfort", 1},
                           {"fatigue", 2},
                           {"headache", 0},
                           {"eyestrain", 3},
                           {"difficulty_focusing", 1},
                           {"increased_salivation", 0},
                           {"sweating", 2},
                           {"nausea", 1},
                           {"difficulty_concentrating", 2},
                           {"fullness_of_head", 1},
                           {"blurred_vision", 0},
                           {"dizzy_eyes_open", 1},
                           {"dizzy_eyes_closed", 2},
                           {"vertigo", 0},
                           {"stomach_awareness", 1},
                           {"burping", 3}};

const Items tlx_answers = {{"mental_demand", 12}, {"physical_demand", 3}, {"temporal_demand", 8},
                           {"performance", 5},    {"effort", 14},         {"frustration", 0}};

const Items sus_answers = {{"sus_1", 4}, {"sus_2", 2}, {"sus_3", 5}, {"sus_4", 1}, {"sus_5", 3},
                           {"sus_6", 2}, {"sus_7", 4}, {"sus_8", 3}, {"sus_9", 5}, {"sus_10", 2}};

study::Questionnaire form_of(const std::string& id, const Items& items, double minimum,
                             double maximum) {
  study::Questionnaire form;
  form.id = id;
  for (const auto& [item, answer] : items) {
    form.questions.push_back({.id = item, .minimum = minimum, .maximum = maximum});
  }
  return form;
}

/// One participant's answers to one questionnaire.
study::StudyRecords answered(const study::Questionnaire& form, const Items& answers) {
  study::StudyRecords records = complete_study(1);
  records.answers.clear();
  records.protocol.questionnaires = {form};
  for (const auto& [item, answer] : answers) {
    add_answer(records, "P1", form.id, item, answer);
  }
  return records;
}

std::map<std::string, std::optional<double>> scores_in(const study::StudyRecords& records) {
  std::map<std::string, std::optional<double>> scores;
  for (const ScoreRow& row : score_questionnaires(records)) {
    EXPECT_EQ(row.participant, "P1");
    scores[row.instrument + " " + row.score] = row.value;
  }
  return scores;
}

// Kennedy, Lane, Berbaum, Lilienthal 1993, Table 5: nausea is items 1, 6, 7, 8, 9, 15, 16, here
// 1 + 0 + 2 + 1 + 2 + 1 + 3 = 10; oculomotor 1, 2, 3, 4, 5, 9, 11, here 1 + 2 + 0 + 3 + 1 + 2 + 0
// = 9; disorientation 5, 8, 10, 11, 12, 13, 14, here 1 + 1 + 1 + 0 + 1 + 2 + 0 = 6.
TEST(Scoring, SimulatorSicknessByItsWeights) {
  const auto scores = scores_in(answered(form_of("after", ssq_answers, 0, 3), ssq_answers));
  ASSERT_EQ(scores.size(), 4U);
  EXPECT_DOUBLE_EQ(*scores.at("SSQ nausea"), 95.4);
  EXPECT_DOUBLE_EQ(*scores.at("SSQ oculomotor"), 68.22);
  EXPECT_DOUBLE_EQ(*scores.at("SSQ disorientation"), 83.52);
  EXPECT_DOUBLE_EQ(*scores.at("SSQ total"), 25 * 3.74);
}

// The most that can be reached, as published: 200.34, 159.18, 292.32, 235.62.
TEST(Scoring, SimulatorSicknessAtItsWorst) {
  Items worst = ssq_answers;
  for (auto& [item, answer] : worst) {
    answer = 3;
  }
  const auto scores = scores_in(answered(form_of("after", worst, 0, 3), worst));
  EXPECT_NEAR(*scores.at("SSQ nausea"), 200.34, 1e-9);
  EXPECT_NEAR(*scores.at("SSQ oculomotor"), 159.18, 1e-9);
  EXPECT_NEAR(*scores.at("SSQ disorientation"), 292.32, 1e-9);
  EXPECT_NEAR(*scores.at("SSQ total"), 235.62, 1e-9);
}

// 12 + 3 + 8 + 5 + 14 + 0 = 42, a mean of 7 on 0 to 20.
TEST(Scoring, TaskLoadWithoutWeights) {
  const auto scores = scores_in(answered(form_of("load", tlx_answers, 0, 20), tlx_answers));
  ASSERT_EQ(scores.size(), 1U);
  EXPECT_DOUBLE_EQ(*scores.at("NASA-TLX raw_load"), 35.0);
}

// Odd items: 3 + 4 + 2 + 3 + 4 = 16; even ones: 3 + 4 + 3 + 2 + 3 = 15; 31 times 2.5.
TEST(Scoring, UsabilityByOddAndEvenItems) {
  const auto scores = scores_in(answered(form_of("system", sus_answers, 1, 5), sus_answers));
  ASSERT_EQ(scores.size(), 1U);
  EXPECT_DOUBLE_EQ(*scores.at("SUS usability"), 77.5);
}

TEST(Scoring, AMissingItemLeavesOutTheScoresThatCountIt) {
  Items fewer = ssq_answers;
  fewer.erase(fewer.begin() + 6);  // sweating, which only nausea counts
  const auto scores = scores_in(answered(form_of("after", ssq_answers, 0, 3), fewer));
  EXPECT_FALSE(scores.at("SSQ nausea"));
  EXPECT_FALSE(scores.at("SSQ total"));
  EXPECT_DOUBLE_EQ(*scores.at("SSQ oculomotor"), 68.22);
  EXPECT_DOUBLE_EQ(*scores.at("SSQ disorientation"), 83.52);
}

TEST(Scoring, OtherQuestionnairesAreNotScored) {
  EXPECT_TRUE(scores_in(answered(form_of("load", tlx_answers, 0, 100), tlx_answers)).empty());
  Items fewer = tlx_answers;
  fewer.pop_back();
  EXPECT_TRUE(scores_in(answered(form_of("load", fewer, 0, 20), fewer)).empty());
  study::Questionnaire in_words = form_of("load", tlx_answers, 0, 20);
  in_words.questions[0].kind = study::QuestionKind::text;
  EXPECT_TRUE(scores_in(answered(in_words, tlx_answers)).empty());
}

TEST(Scoring, OtherQuestionsMayStandBesideTheItems) {
  study::Questionnaire form = form_of("load", tlx_answers, 0, 20);
  form.questions.push_back({.id = "remarks", .kind = study::QuestionKind::text});
  EXPECT_EQ(scores_in(answered(form, tlx_answers)).count("NASA-TLX raw_load"), 1U);
}

TEST(Scoring, EachTimeThatItIsAskedHasItsOwnScores) {
  study::StudyRecords records = answered(form_of("load", tlx_answers, 0, 20), tlx_answers);
  for (const auto& [item, answer] : tlx_answers) {
    add_answer(records, "P1", "load", item, 20.0, 3);
  }
  const std::vector<ScoreRow> rows = score_questionnaires(records);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].step, 0);
  EXPECT_DOUBLE_EQ(*rows[0].value, 35.0);
  EXPECT_EQ(rows[1].step, 3);
  EXPECT_DOUBLE_EQ(*rows[1].value, 100.0);
}

}  // namespace
}  // namespace foveola::analysis
