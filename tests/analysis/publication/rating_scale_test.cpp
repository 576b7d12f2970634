// The words of the rating's points come from the study's own protocol, wherever they are printed.
#include "analysis/publication/rating_scale.h"

#include <filesystem>
#include <map>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/publication/analyze_study.h"
#include "analysis/publication/html.h"
#include "analysis/publication/latex_tables.h"
#include "analysis/publication/report_parts.h"
#include "renderer/base/csv.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "tests/analysis/made_up_study.h"

namespace fs = std::filesystem;

namespace foveola::analysis {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::ThrowsMessage;

/// A protocol with a rating `artifacts` of these labels, and more of its keys.
std::string protocol_with(const std::vector<std::string>& labels, const std::string& keys = "") {
  std::string text = "[[rating]]\nid = \"artifacts\"\ntext = \"?\"\n" + keys;
  if (!labels.empty()) {
    text += "labels = " + nlohmann::json(labels).dump() + "\n";
  }
  return text;
}

study::StudyRecords study_with(const std::string& protocol_text) {
  study::StudyRecords records = complete_study(3);
  records.protocol_text = protocol_text;
  return records;
}

RatingScale scale_of(const std::string& protocol_text) {
  return rating_scale_of(study_with(protocol_text), {"P1", "P2", "P3"});
}

TEST(RatingScale, HasTheProtocolsLabels) {
  const RatingScale ends = scale_of(protocol_with({"keine", "überall"}));
  EXPECT_TRUE(ends.is_analysed());
  EXPECT_EQ(points_in_words(ends), "1 keine to 5 überall");
  EXPECT_EQ(points_in_brackets(ends), "1 (keine) to 5 (überall)");
  const RatingScale every = scale_of(protocol_with({"a", "b", "c", "d", "e"}));
  EXPECT_EQ(points_in_words(every), "1 (a), 2 (b), 3 (c), 4 (d), 5 (e)");
  EXPECT_EQ(points_in_brackets(every), points_in_words(every));
  EXPECT_EQ(points_in_words(scale_of(protocol_with({}))), "1 to 5");
  EXPECT_EQ(notes_on(every), "");
}

TEST(RatingScale, IsThePublishedOneIfTheProtocolHasNoneOfItsOwn) {
  EXPECT_EQ(points_in_words(scale_of("")), "1 none to 5 not discernible at all");
  EXPECT_EQ(points_in_words(scale_of(read_file(fs::path(FOVEOLA_DATA_DIR).parent_path() /
                                               "protocols/koskela2018.toml"))),
            "1 none to 5 not discernible at all");
}

TEST(RatingScale, IsNotTakenForFivePointsIfItHasOthers) {
  const RatingScale hundred = scale_of(protocol_with({}, "minimum = 0\nmaximum = 100\n"));
  EXPECT_FALSE(hundred.is_analysed());
  EXPECT_THAT(notes_on(hundred), HasSubstr("in the record only"));
  const RatingScale none = scale_of("[[rating]]\nid = \"comfort\"\ntext = \"?\"\n");
  EXPECT_FALSE(none.is_analysed());
  EXPECT_THAT(notes_on(none), HasSubstr("no such rating"));
  EXPECT_EQ(points_in_words(none), "1 to 5");
}

TEST(RatingScale, SaysWhichWordsSessionsByAnAmendedProtocolHad) {
  study::StudyRecords records = study_with(protocol_with({"none", "all"}));
  const auto amend = [&](const std::string& participant, const std::vector<std::string>& labels) {
    records.amended.push_back({participant, {.text = protocol_with(labels)}});
  };
  amend("P1", {"keine", "alle"});
  amend("P1", {"keine", "alle"});
  amend("P2", {"keine", "alle"});
  amend("P3", {"none", "all"});            // other words were amended
  amend("P9", {"never", "not analysed"});  // did not complete the session
  const AnalysisSet set = select_for_analysis(records);
  EXPECT_EQ(notes_on(set.rating_scale),
            " In 2 analysed sessions, by an amended protocol, the points were 1 (keine) to 5 "
            "(alle).");
  EXPECT_EQ(points_in_words(set.rating_scale), "1 none to 5 all");
}

TEST(RatingScale, OfAProtocolThatIsNoneIsAnErrorWithItsPlace) {
  EXPECT_THAT([] { (void)scale_of("[[rating]]\nid = 3\n"); },
              ThrowsMessage<Error>(HasSubstr("the study's protocol:2:")));
}

/// Every file in which words stand, by its path in the folder.
std::map<std::string, std::string> texts_in(const fs::path& folder) {
  std::map<std::string, std::string> texts;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string kind = entry.path().extension().string();
    if (entry.is_regular_file() && kind != ".png" && kind != ".pdf" && kind != ".svg") {
      texts[fs::relative(entry.path(), folder).string()] = read_file(entry.path());
    }
  }
  return texts;
}

/// What analyses print of the rating's scale, in every format.
class PrintedScale : public testing::Test {
 protected:
  void analyse(const std::vector<std::string>& labels) {
    output_ = analyze_records(study_with(protocol_with(labels)), {}, scratch_ / "out",
                              {.bids = true, .unverified = false});
    texts_ = texts_in(scratch_ / "out");
  }

  ScratchFolder scratch_;
  AnalysisOutput output_;
  std::map<std::string, std::string> texts_;
};

TEST_F(PrintedScale, IsTheProtocolsInEveryFileAndOnTheTerminal) {
  const std::string low = "keine & 0 % <b>";
  const std::string high = "über_all \"日本\", #1 {x} $y$ ~ ^ \\";
  analyse({low, high});
  const std::string words = fmt::format("1 {} to 5 {}", low, high);
  const std::string brackets = fmt::format("1 ({}) to 5 ({})", low, high);
  EXPECT_THAT(output_.summary, HasSubstr("Artifacts in other areas, " + words + "\n"));
  EXPECT_THAT(texts_.at("report.html"),
              AllOf(HasSubstr("Number of answers " + escape_html(brackets) + "."),
                    HasSubstr("the share of each answer, " + escape_html(words) + ","),
                    HasSubstr("artifacts in other areas from " + escape_html(brackets) + "."),
                    Not(HasSubstr("<b>"))));
  EXPECT_THAT(texts_.at("figure6_artifact_ratings.tex"),
              HasSubstr("1 (keine \\& 0 \\% \\textless{}b\\textgreater{}) to 5 (über\\_all "
                        "''日本'', \\#1 \\{x\\} \\$y\\$ \\~{} \\^{} \\textbackslash{})."));
  const std::string described = "Artifacts in other areas, " + words;
  EXPECT_EQ(parse_csv(texts_.at("codebook.csv"), "codebook").back().at(3), described);
  const auto bids = nlohmann::json::parse(texts_.at("bids/task-preview_beh.json"));
  EXPECT_EQ(bids.at("artifacts_rating").at("Description"), described);
  const auto shared = nlohmann::json::parse(texts_.at("psych-ds/dataset_description.json"));
  EXPECT_EQ(shared.at("variableMeasured").at(11).at("description"), described);
  EXPECT_EQ(shared.at("variableMeasured").at(12 + 4).at("description"),
            described + "; scene aula, method od");
}

TEST_F(PrintedScale, IsNowhereThePublishedOneIfTheProtocolHasAnother) {
  analyse({"a", "b", "c", "d", "e"});
  for (const auto& [name, text] : texts_) {
    EXPECT_THAT(text, Not(HasSubstr("discernible"))) << name;
    EXPECT_THAT(text, Not(HasSubstr("1 none"))) << name;
    EXPECT_THAT(text, Not(HasSubstr("1 (none)"))) << name;
  }
  EXPECT_THAT(output_.summary, Not(HasSubstr("discernible")));
}

TEST_F(PrintedScale, CannotSteerTheTerminal) {
  analyse({"a\x1b[31m", "b\nc"});
  EXPECT_THAT(output_.summary, HasSubstr("1 a?[31m to 5 b?c\n"));
}

}  // namespace
}  // namespace foveola::analysis
