#include "analysis/publication/exports/bids.h"

#include <algorithm>
#include <set>

#include <nlohmann/json.hpp>

#include "analysis/dataset/answer_data.h"
#include "analysis/dataset/trial_data.h"
#include "tests/analysis/made_up_study.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

std::vector<TextFile> bids_of(const study::StudyRecords& records) {
  const StudyTables tables = tabulate_study(records);
  return bids_files(tables, records, trial_columns(records, tables.set),
                    participant_answer_columns(records, tables.set));
}

std::string content_of(const std::vector<TextFile>& files, const std::string& name) {
  const auto found = std::find_if(files.begin(), files.end(),
                                  [&](const TextFile& file) { return file.name == name; });
  return found == files.end() ? "" : found->content;
}

/// The fields of gaze and object in a trial of two marks without frames.
const std::string without_gaze =
    "n/a\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\t";

TEST(Bids, EveryParticipantHasAFileOfTrialsInTheirOrder) {
  study::StudyRecords records = complete_study(2);
  records.trials[6].scene_position = 1;  // the record has the rows in the order of the plan
  const std::string text =
      content_of(bids_of(records), "bids/sub-P2/beh/sub-P2_task-preview_beh.tsv");
  EXPECT_THAT(
      text,
      StartsWith("status\tstatus_reason\tscene\tmethod\ttrial\ttrial_kind\ttrial_position\t"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 7);
  EXPECT_LT(text.find("\nanalysed\tn/a\taula\tod\t0\ttest\t3\t"), text.find("\taula\tvp\t"));
}

TEST(Bids, PracticeAndCatchTrialsAreThereAndEarlierTimingsAreNot) {
  study::StudyRecords records = complete_study(1);
  study::TrialRow row = records.trials.front();
  row.counts = false;
  records.add_trial(row, {measured(99.5), {}, {}});
  row.counts = true;
  row.kind = study::TrialKind::practice;
  records.add_trial(row, {measured(88.5), {}, {}});
  row.kind = study::TrialKind::catch_trial;
  records.add_trial(row, {right_censored(8), {}, {}});
  const std::string text =
      content_of(bids_of(records), "bids/sub-P1/beh/sub-P1_task-preview_beh.tsv");
  EXPECT_EQ(text.find("99.5"), std::string::npos);
  EXPECT_THAT(text,
              HasSubstr("\npractice\tn/a\taula\tod\t0\tpractice\tn/a\tn/a\t1\tthe chair\trated\t"
                        "88.5\tfalse\tn/a\tn/a\tn/a\t" +
                        without_gaze + "none\n"));
  EXPECT_THAT(text,
              HasSubstr("\ncatch\tn/a\taula\tod\t0\tcatch\tn/a\tn/a\t1\tthe chair\trated\t8\ttrue\t"
                        "n/a\tn/a\tn/a\t" +
                        without_gaze + "none\n"));
}

TEST(Bids, WhatIsMissingIsNotAvailable) {
  study::StudyRecords records = golden_study_records();
  study::TrialRow row = records.trials.front();
  row.attempt = 0;
  row.object = 0;
  row.outcome = 0;
  keep_trials(records, [](const study::TrialRow& trial) {
    return trial.session > 0 || trial.scene > 0 || trial.method > 0;
  });
  records.add_trial(row, {{}, {}, {}});
  EXPECT_THAT(content_of(bids_of(records), "bids/sub-P01/beh/sub-P01_task-preview_beh.tsv"),
              HasSubstr("aula\tod\t0\ttest\t0\t0\t0\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\tn/a\t" +
                        without_gaze + "none\n"));
}

TEST(Bids, SidecarsAreJsonAndDescribeEveryColumn) {
  const std::vector<TextFile> files = bids_of(golden_study_records());
  const nlohmann::json columns =
      nlohmann::json::parse(content_of(files, "bids/task-preview_beh.json"));
  EXPECT_EQ(columns["outline_s"]["Units"], "s");
  const std::string text = content_of(files, "bids/sub-P01/beh/sub-P01_task-preview_beh.tsv");
  const auto tabs =
      std::count(text.begin(), text.begin() + static_cast<long>(text.find('\n')), '\t');
  EXPECT_EQ(columns.size(), static_cast<std::size_t>(tabs) + 2);  // and TaskName
  EXPECT_EQ(
      nlohmann::json::parse(content_of(files, "bids/dataset_description.json"))["BIDSVersion"],
      "1.11.1");
  const nlohmann::json people = nlohmann::json::parse(content_of(files, "bids/participants.json"));
  EXPECT_EQ(people["participant_kind"]["Levels"].size(), 3U);
  EXPECT_TRUE(people["background.virtual_reality"].contains("Description"));
}

TEST(Bids, ColumnsOfQuestionnairesStayApartFromOursAndFromEachOther) {
  study::StudyRecords records = complete_study(1);
  add_answer(records, "P1", "participant", "code", 1.0);
  add_answer(records, "P1", "a_b", "c", 2.0);
  add_answer(records, "P1", "a", "b_c", 3.0);
  const std::string people = content_of(bids_of(records), "bids/participants.tsv");
  for (const char* column : {"participant_code\t", "participant.code", "a_b.c", "a.b_c"}) {
    EXPECT_THAT(people.substr(0, people.find('\n')), HasSubstr(column));
  }
}

TEST(Bids, CodesThatCannotBeLabelsStayApart) {
  study::StudyRecords records = complete_study(3);
  records.sessions[1].participant = "P-1";
  records.sessions[2].participant = "../\t";
  std::set<std::string> names;
  for (const TextFile& file : bids_of(records)) {
    EXPECT_THAT(file.name, Not(HasSubstr("..")));
    names.insert(file.name);
  }
  EXPECT_EQ(names.size(), 5U + 3U);
  EXPECT_TRUE(names.contains("bids/sub-P1n2/beh/sub-P1n2_task-preview_beh.tsv"));
}

// APFS and NTFS take sub-P001 and sub-p001 for one folder. BIDS: a label has a letter or digit.
TEST(Bids, LabelsDifferInMoreThanLetterCaseAndAreNotEmpty) {
  study::StudyRecords records = complete_study(3);
  records.sessions[0].participant = "P001";
  records.sessions[1].participant = "p001";
  records.sessions[2].participant = "_";
  EXPECT_THAT(bids_labels(select_for_analysis(records)), ElementsAre("P001", "x", "p001n2"));
}

}  // namespace
}  // namespace foveola::analysis
