// The labels that a rating's points had in sessions by an amended protocol.
#include <nlohmann/json.hpp>

#include "analysis/dataset/wording.h"
#include "renderer/base/error.h"
#include "tests/analysis/made_up_study.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

/// Three people's study with these labels of the rating `artifacts`.
study::StudyRecords study_with(const std::vector<std::string>& labels) {
  study::StudyRecords records = complete_study(3);
  records.measures[artifacts_index].question.labels = labels;
  return records;
}

std::string text_with(const std::vector<std::string>& labels) {
  return "[[rating]]\nid = \"artifacts\"\ntext = \"?\"\nlabels = " + nlohmann::json(labels).dump() +
         "\n";
}

void amend(study::StudyRecords& records, const std::string& participant,
           const std::vector<std::string>& labels) {
  records.amended.push_back(
      {participant, {.sha256 = {}, .changed = {}, .text = text_with(labels)}});
}

TEST(AmendedLabels, AreThoseOfTheAnalysedSessions) {
  study::StudyRecords records = study_with({"none", "all"});
  amend(records, "P1", {"keine", "alle"});
  amend(records, "P1", {"keine", "alle"});
  amend(records, "P2", {"keine", "alle"});
  amend(records, "P3", {"none", "all"});            // other words were amended
  amend(records, "P9", {"never", "not analysed"});  // did not complete the session
  const Dataset set = select_for_analysis(records);
  ASSERT_EQ(set.amended_labels.size(), 1U);
  EXPECT_EQ(amendments_of_scale(set, artifacts_index),
            " In 2 analysed sessions, by an amended protocol, the points were 1 keine to 5 alle.");
  EXPECT_EQ(scale_with_amendments(set, artifacts_index),
            "1 none to 5 all. In 2 analysed sessions, by an amended protocol, the points were 1 "
            "keine to 5 alle.");
  EXPECT_EQ(amendments_of_scale(set, outline_index), "");
}

TEST(AmendedLabels, AreUsuallyNone) {
  const Dataset set = select_for_analysis(study_with({"a", "b", "c", "d", "e"}));
  EXPECT_EQ(scale_with_amendments(set, artifacts_index), "1 (a), 2 (b), 3 (c), 4 (d), 5 (e)");
}

TEST(AmendedLabels, OfAProtocolThatIsNoneAreAnErrorWithItsPlace) {
  study::StudyRecords records = study_with({"none", "all"});
  records.amended.push_back({"P1", {.sha256 = {}, .changed = {}, .text = "[[rating]]\nid = 3\n"}});
  EXPECT_THAT([&] { (void)select_for_analysis(records); },
              ThrowsMessage<Error>(HasSubstr("an amended protocol in the study's file:2:")));
}

}  // namespace
}  // namespace foveola::analysis
