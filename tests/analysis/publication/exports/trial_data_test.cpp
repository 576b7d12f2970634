#include "analysis/dataset/trial_data.h"

#include <algorithm>
#include <set>
#include <string>

#include <nlohmann/json.hpp>

#include "analysis/dataset/answer_data.h"
#include "analysis/publication/exports/data_files.h"
#include "analysis/publication/report/printed_results.h"
#include "analysis/tables/table_formats.h"
#include "renderer/base/text/csv.h"
#include "tests/analysis/made_up_study.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

using study::TrialKind;
using study::TrialRow;

/// All rows, timings that do not count among them.
std::vector<CsvRow> long_rows(const study::StudyRecords& records) {
  const Dataset set = select_for_analysis(records);
  const ColumnsOf<std::size_t> trials = trial_columns(records, set);
  std::string text = csv_heading(columns_in(trials));
  for (std::size_t i = 0; i < records.trials.size(); ++i) {
    text += csv_row(row_of(trials, i));
  }
  return parse_csv(text, "long");
}

std::vector<CsvRow> wide_rows(const study::StudyRecords& records) {
  const Dataset set = select_for_analysis(records);
  const ColumnsOf<std::size_t> participants = participant_columns(records, set);
  std::string text = csv_heading(columns_in(participants));
  for (std::size_t i = 0; i < set.participants.size(); ++i) {
    text += csv_row(row_of(participants, i));
  }
  return parse_csv(text, "wide");
}

const CsvRow& row_of(const std::vector<CsvRow>& rows, const std::string& participant,
                     const std::string& scene, const std::string& method) {
  return *std::find_if(rows.begin(), rows.end(), [&](const CsvRow& row) {
    return row[0] == participant && row[5] == scene && row[6] == method;
  });
}

TEST(TrialData, TheLongTableHasARowForEveryRecordedTrial) {
  const study::StudyRecords records = golden_study_records();
  const std::vector<CsvRow> rows = long_rows(records);
  ASSERT_EQ(rows.size(), 1U + records.trials.size());
  EXPECT_THAT(rows, Each(SizeIs(rows[0].size())));
  EXPECT_THAT(
      rows[0],
      ElementsAre("participant", "participant_kind", "session_state", "status", "status_reason",
                  "scene", "method", "trial", "trial_kind", "trial_position", "method_position",
                  "attempt", "object", "outcome", "outline_s", "outline_censored", "material_s",
                  "material_censored", "artifacts_rating", "gaze_time_seconds",
                  "gaze_on_object_seconds", "gaze_on_object_percent", "gaze_elsewhere_percent",
                  "gaze_lost_percent", "fixations", "mean_fixation_seconds", "fixations_on_object",
                  "outline_gaze_from_object_deg", "outline_object_from_middle_deg",
                  "outline_object_in_view", "material_gaze_from_object_deg",
                  "material_object_from_middle_deg", "material_object_in_view", "record"));
  EXPECT_THAT(rows[1], ElementsAre("P01", "human", "completed", "analysed", "", "aula", "od", "0",
                                   "test", "0", "0", "1", "the chair", "rated", "8.0041", "FALSE",
                                   "12.0567", "FALSE", "2", "", "", "", "", "", "", "", "", "", "",
                                   "", "", "", "", "none"));
}

TEST(TrialData, RightCensoredTimesAreBoundsAndMissingOnesAreEmpty) {
  const std::vector<CsvRow> rows = long_rows(golden_study_records());
  const CsvRow& ran_out = row_of(rows, "P03", "aula", "od");
  EXPECT_EQ(ran_out.at(14), "60");
  EXPECT_EQ(ran_out.at(15), "TRUE");
  const CsvRow& missing = row_of(rows, "P04", "barn", "fv");
  EXPECT_EQ(missing.at(16), "");
  EXPECT_EQ(missing.at(17), "");
}

TEST(TrialData, StatusSaysWhyATrialIsNotAnalysed) {
  study::StudyRecords records = complete_study(6);
  records.sessions[1].state = "rating";
  records.sessions[2].kind = "pilot";
  records.sessions[3].state = "excluded";
  records.sessions[3].reason = "fell asleep";
  records.sessions[4].state = "withdrawn";
  records.sessions[5].state = "refused";
  TrialRow row = records.trials.front();
  row.counts = false;
  records.add_trial(row, {{}, {}, {}});
  row.counts = true;
  row.kind = TrialKind::practice;
  records.add_trial(row, {{}, {}, {}});
  row.kind = TrialKind::catch_trial;
  records.add_trial(row, {{}, {}, {}});
  const std::vector<CsvRow> rows = long_rows(records);
  const auto status = [&](std::size_t trial) {
    return std::vector<std::string>{rows.at(1 + trial).at(3), rows.at(1 + trial).at(4)};
  };
  EXPECT_THAT(status(0), ElementsAre("analysed", ""));
  EXPECT_THAT(status(6), ElementsAre("interrupted", "session interrupted: in its state rating"));
  EXPECT_THAT(status(12), ElementsAre("other kind",
                                      "pilot session; only human sessions are "
                                      "analysed together"));
  EXPECT_THAT(status(18), ElementsAre("excluded", "session excluded: fell asleep"));
  EXPECT_THAT(status(24), ElementsAre("withdrawn", "session withdrawn"));
  EXPECT_THAT(status(30), ElementsAre("refused", "session refused"));
  EXPECT_THAT(status(36), ElementsAre("timed again", ""));
  EXPECT_THAT(status(37), ElementsAre("practice", ""));
  EXPECT_THAT(status(38), ElementsAre("catch", ""));
  EXPECT_EQ(rows.at(1 + 38).at(9), "");
}

TEST(TrialData, EveryMeasureOfTheProtocolHasItsColumns) {
  study::StudyRecords records = complete_study(1);
  records.measures[material_index].question.id = "third";
  study::Question& rating = records.measures[artifacts_index].question;
  rating = {.id = "remarks", .text = "Remarks?", .kind = study::QuestionKind::text};
  const std::uint32_t odd = word_in(records, "odd, \"very\"");
  change_values(records, "remarks",
                [&](Value& value) { value = {.state = Value::State::in_words, .words = odd}; });
  const std::vector<CsvRow> rows = long_rows(records);
  EXPECT_EQ(rows.at(0).at(16), "third_s");
  EXPECT_EQ(rows.at(0).at(18), "remarks_rating");
  EXPECT_EQ(rows.at(1).at(18), "odd, \"very\"");
  const Dataset set = select_for_analysis(records);
  const Column remarks = trial_columns(records, set).at(18).column;
  EXPECT_EQ(remarks.type, ColumnType::text);
  EXPECT_EQ(remarks.description, "Remarks? Answers: in words");
}

// csv.DictReader and pandas keep the last of two columns of one name.
TEST(TrialData, NoIdOfAMarkMakesAColumnOfThisName) {
  study::StudyRecords records = complete_study(1);
  const Dataset set = select_for_analysis(records);
  for (const Column& own : columns_in(trial_columns(records, set))) {
    if (own.name.starts_with("material_")) {
      continue;  // the other mark's
    }
    for (std::size_t end = own.name.find('_'); end != std::string::npos;
         end = own.name.find('_', end + 1)) {
      records.measures[outline_index].question.id = own.name.substr(0, end);
      EXPECT_NO_THROW((void)long_rows(records)) << own.name;
    }
  }
  for (const char* of_gaze : {"gaze_time", "gaze_on_object", "mean_fixation"}) {
    records.measures[outline_index].question.id = of_gaze;
    const CsvRow heading = long_rows(records).front();
    EXPECT_EQ(std::count(heading.begin(), heading.end(), std::string(of_gaze) + "_s"), 1);
  }
}

TEST(TrialData, TheWideTableHasARowForEveryParticipant) {
  const std::vector<CsvRow> rows = wide_rows(golden_study_records());
  ASSERT_EQ(rows.size(), 9U);
  EXPECT_THAT(rows, Each(SizeIs(3 + 3 * 3 * 5 + 3)));
  EXPECT_EQ(rows[0][3], "outline_s.aula.od");
  EXPECT_EQ(rows[0].back(), "background.virtual_reality");
  EXPECT_EQ(rows[1].back(), "3");
}

study::StudyRecords study_with_forms() {
  study::StudyRecords records = complete_study(2);
  study::Questionnaire form;
  form.id = "mood";
  form.questions = {
      {.id = "ease", .text = "At ease?", .minimum = 1, .maximum = 2, .labels = {"no", "yes"}},
      {.id = "remarks", .text = "Remarks?", .kind = study::QuestionKind::text},
      {.id = "noise",
       .text = "Noise?",
       .kind = study::QuestionKind::choice,
       .options = {{"a little", 0.5}, {"much", 2.0}}}};
  records.protocol.questionnaires = {form};
  records.answers.clear();
  add_answer(records, "P1", "mood", "ease", 2.0);
  add_answer_in_words(records, "P1", "mood", "remarks", "none, \"really\"", 4);
  add_answer(records, "P2", "mood", "noise", 0.5);
  add_answer(records, "P2", "unknown", "thing", 7.0);
  return records;
}

std::vector<CsvRow> answer_rows(const study::StudyRecords& records) {
  const Dataset set = select_for_analysis(records);
  const ColumnsOf<study::AnswerRow> answers = answer_columns(records, set);
  std::string text = csv_heading(columns_in(answers));
  for (const study::AnswerRow& answer : records.answers) {
    text += csv_row(row_of(answers, answer));
  }
  return parse_csv(text, "answers");
}

TEST(TrialData, AnswersOfSessionsThatAreNotAnalysedSayWhy) {
  study::StudyRecords records = study_with_forms();
  records.sessions[1].state = "withdrawn";
  const std::vector<CsvRow> rows = answer_rows(records);
  EXPECT_EQ(rows.at(1).at(2), "analysed");
  EXPECT_EQ(rows.at(3).at(2), "withdrawn");
  EXPECT_EQ(rows.at(3).at(3), "session withdrawn");
}

TEST(TrialData, EveryAnswerHasARowWithTheProtocolsLabel) {
  const std::vector<CsvRow> rows = answer_rows(study_with_forms());
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_THAT(rows[0],
              ElementsAre("participant", "session_state", "status", "status_reason",
                          "questionnaire", "step", "question", "number", "text", "question_text",
                          "scale", "response_s", "participant_kind", "record"));
  EXPECT_THAT(rows[1], ElementsAre("P1", "completed", "analysed", "", "mood", "0", "ease", "2",
                                   "yes", "At ease?", "1 no to 2 yes", "", "human", "none"));
  EXPECT_THAT(rows[2],
              ElementsAre("P1", "completed", "analysed", "", "mood", "4", "remarks", "",
                          "none, \"really\"", "Remarks?", "in words", "", "human", "none"));
  EXPECT_THAT(rows[3],
              ElementsAre("P2", "completed", "analysed", "", "mood", "0", "noise", "0.5",
                          "a little", "Noise?", "0.5 (a little), 2 (much)", "", "human", "none"));
  EXPECT_THAT(rows[4], ElementsAre("P2", "completed", "analysed", "", "unknown", "0", "thing", "7",
                                   "", "", "", "", "human", "none"));
}

TEST(TrialData, QuestionsInNumbersAreDescribed) {
  const study::StudyRecords records = study_with_forms();
  const std::vector<CsvRow> rows =
      parse_csv(csv_of(answers_by_question(records, select_for_analysis(records))), "answers");
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_THAT(rows[1],
              ElementsAre("mood", "ease", "1 no to 2 yes", "1", "2", "", "2", "1", "human"));
  EXPECT_EQ(rows[2].at(1), "noise");
  EXPECT_EQ(rows[2].at(4), "0.5");
  EXPECT_EQ(rows[3].at(0), "unknown");
}

TEST(TrialData, ScoresSayWhetherTheirSessionIsAnalysed) {
  study::StudyRecords records = complete_study(1);
  records.sessions.push_back({"P2", "simulated", "completed", {}, {}});
  records.sessions.push_back({"P3", "human", "excluded", {}, "slept"});
  study::Questionnaire form;
  form.id = "load";
  for (const char* item : {"mental_demand", "physical_demand", "temporal_demand", "performance",
                           "effort", "frustration"}) {
    form.questions.push_back({.id = item, .minimum = 0, .maximum = 20});
    for (const char* participant : {"P1", "P2", "P3"}) {
      add_answer(records, participant, "load", item, participant[1] == '1' ? 10.0 : 20.0);
    }
  }
  records.protocol.questionnaires = {form};
  const Table scores = questionnaire_scores(records, select_for_analysis(records));
  const std::vector<CsvRow> rows = parse_csv(csv_of(scores), "scores");
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_THAT(rows[1],
              ElementsAre("P1", "analysed", "load", "0", "NASA-TLX", "raw_load", "50", "human"));
  EXPECT_THAT(rows[2], ElementsAre("P2", "other kind", "load", "0", "NASA-TLX", "raw_load", "100",
                                   "simulated"));
  EXPECT_EQ(rows[3].at(1), "excluded");
  // Means in print are of the analysed ones.
  const PrintedTable printed = printed_scores(scores);
  ASSERT_EQ(printed.rows.size(), 1U);
  EXPECT_THAT(printed.rows[0],
              ElementsAre("load (step 0), raw_load", "NASA-TLX", "1", "50.0", "–", "50.0"));
}

TEST(TrialData, PsychDsDescribesItsVariables) {
  study::StudyRecords records = of_kind(complete_study(2), "simulated");
  records.protocol.name = "my study/2";
  const StudyTables tables = tabulate_study(records);
  const std::vector<Column> trials = columns_in(trial_columns(records, tables.set));
  const std::vector<Column> participants = columns_in(participant_columns(records, tables.set));
  const PsychDs shared = psych_ds(tables, trials, participants);
  const nlohmann::json json = nlohmann::json::parse(shared.description.content);
  EXPECT_EQ(json["@type"], "Dataset");
  std::set<std::string> described;
  for (const nlohmann::json& variable : json["variableMeasured"]) {
    EXPECT_TRUE(described.insert(variable["name"]).second) << variable["name"];
    EXPECT_FALSE(variable["description"].get<std::string>().empty()) << variable["name"];
  }
  std::set<std::string> columns;
  for (const std::vector<Column>& of_file : {trials, participants}) {
    for (const Column& column : of_file) {
      columns.insert(column.name);
    }
  }
  EXPECT_EQ(described, columns);
  EXPECT_TRUE(columns.contains("material_s.barn.fv"));
  EXPECT_TRUE(columns.contains("background.graphics_3d"));
  EXPECT_THAT(json["description"].get<std::string>(), HasSubstr("Simulated data"));
  EXPECT_EQ(shared.trials_name, "psych-ds/data/study-mystudy2_type-trials_data.csv");
}

}  // namespace
}  // namespace foveola::analysis
