#include "analysis/publication/bids.h"

#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/analysis/made_up_study.h"

namespace foveola::analysis {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::vector<TextFile> bids_of(const study::StudyRecords& records) {
  return bids_files(tabulate_study(records), records.background);
}

std::string content_of(const std::vector<TextFile>& files, const std::string& name) {
  const auto found = std::find_if(files.begin(), files.end(),
                                  [&](const TextFile& file) { return file.name == name; });
  return found == files.end() ? "" : found->content;
}

TEST(Bids, EveryParticipantHasAFileOfTrialsInTheirOrder) {
  study::StudyRecords records = complete_study(2);
  trial_of(records, "P2", "barn", "fv").scene_position = 0;
  trial_of(records, "P2", "aula", "od").scene_position = 1;
  const std::string text =
      content_of(bids_of(records), "bids/sub-P2/beh/sub-P2_task-preview_beh.tsv");
  EXPECT_THAT(text, StartsWith("scene\tmethod\ttrial_position\t"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 7);
  EXPECT_LT(text.find("\nbarn\tfv\t"), text.find("\naula\tod\t"));
}

TEST(Bids, WhatIsMissingIsNotAvailable) {
  const std::vector<TextFile> files = bids_of(golden_study_records());
  EXPECT_THAT(content_of(files, "bids/sub-P02/beh/sub-P02_task-preview_beh.tsv"),
              HasSubstr("aula\tvp\t0\t0\t0\tn/a\tn/a\tn/a\tn/a\tn/a\n"));
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
  EXPECT_TRUE(people["background_virtual_reality"].contains("Description"));
}

TEST(Bids, SaysWhoTookPart) {
  study::StudyRecords records = complete_study(2);
  for (study::SessionRow& session : records.sessions) {
    session.kind = "simulated";
  }
  const std::vector<TextFile> files = bids_of(records);
  EXPECT_THAT(content_of(files, "bids/dataset_description.json"), HasSubstr("(Simulated data)"));
  EXPECT_THAT(content_of(files, "bids/participants.tsv"), HasSubstr("sub-P1\tP1\tsimulated\t"));
}

TEST(Bids, CodesThatCannotBeLabelsStayApart) {
  study::StudyRecords records = complete_study(3);
  const auto rename = [&](const std::string& from, const std::string& to) {
    for (study::SessionRow& row : records.sessions) {
      row.participant = row.participant == from ? to : row.participant;
    }
    for (study::TrialRow& row : records.trials) {
      row.participant = row.participant == from ? to : row.participant;
    }
  };
  rename("P2", "P-1");
  rename("P3", "../\t");
  std::set<std::string> names;
  for (const TextFile& file : bids_of(records)) {
    EXPECT_THAT(file.name, testing::Not(HasSubstr("..")));
    names.insert(file.name);
  }
  EXPECT_EQ(names.size(), 5U + 3U);
  EXPECT_TRUE(names.contains("bids/sub-P1n2/beh/sub-P1n2_task-preview_beh.tsv"));
}

}  // namespace
}  // namespace foveola::analysis
