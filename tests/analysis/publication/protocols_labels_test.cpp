// The words of a rating's points come from the study's own protocol, wherever they are printed.
#include <filesystem>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analysis/publication/analyze_study.h"
#include "analysis/tables/html.h"
#include "renderer/base/files/files.h"
#include "renderer/base/text/csv.h"
#include "tests/analysis/made_up_study.h"
#include "tests/matchers.h"
#include "tests/temporary_folder.h"

namespace fs = std::filesystem;

namespace foveola::analysis {
namespace {

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
class ProtocolsLabels : public testing::Test {
 protected:
  void analyse_with(const std::vector<std::string>& labels) {
    study::StudyRecords records = complete_study(3);
    records.measures[artifacts_index].question.labels = labels;
    records.measures[artifacts_index].question.text = "Artefakte?";
    analyse(records);
  }

  void analyse(const study::StudyRecords& records) {
    output_ = analyze_records(records, {}, scratch_ / "out", {.writes_bids = true});
    texts_ = texts_in(scratch_ / "out");
  }

  const test::TemporaryFolder scratch_;
  AnalysisOutput output_;
  std::map<std::string, std::string> texts_;
};

TEST_F(ProtocolsLabels, AreInEveryFileAndOnTheTerminal) {
  const std::string low = "keine & 0 % <b>";
  const std::string high = "über_all \"日本\", #1 {x} $y$ ~ ^ \\";
  analyse_with({low, high});
  const std::string words = fmt::format("1 {} to 5 {}", low, high);
  EXPECT_THAT(output_.summary, HasSubstr("Ratings: artifacts, " + words));
  EXPECT_THAT(texts_.at("report.html"),
              AllOf(HasSubstr("“Artefakte?” " + escape_html(words) + "."),
                    HasSubstr("“Artefakte?” (artifacts: " + escape_html(words) + ")"),
                    Not(HasSubstr("<b>"))));
  EXPECT_THAT(texts_.at("ratings-artifacts.tex"),
              HasSubstr("1 keine \\& 0 \\% \\textless{}b\\textgreater{} to 5 über\\_all "
                        "``日本'', \\#1 \\{x\\} \\$y\\$ \\~{} \\^{} \\textbackslash{}"));
  const std::string described = "Artefakte? Answers: " + words;
  bool is_in_codebook = false;
  for (const CsvRow& row : parse_csv(texts_.at("codebook.csv"), "codebook")) {
    is_in_codebook = is_in_codebook || (row.at(1) == "artifacts_rating" && row.at(4) == described);
  }
  EXPECT_TRUE(is_in_codebook);
  EXPECT_THAT(texts_.at("OUTPUTS.md"),
              HasSubstr("- `artifacts_rating` (integer, points): " + described + ".\n"));
  const auto bids = nlohmann::json::parse(texts_.at("bids/task-preview_beh.json"));
  EXPECT_EQ(bids.at("artifacts_rating").at("Description"), described);
  const auto shared = nlohmann::json::parse(texts_.at("psych-ds/dataset_description.json"));
  std::map<std::string, std::string> variables;
  for (const nlohmann::json& variable : shared.at("variableMeasured")) {
    variables[variable.at("name")] = variable.at("description");
  }
  EXPECT_EQ(variables.at("artifacts_rating"), described);
  EXPECT_EQ(variables.at("artifacts_rating.aula.od"), described + "; scene aula, method od");
}

TEST_F(ProtocolsLabels, AreNowhereThePublishedOnesIfTheProtocolHasOthers) {
  analyse_with({"a", "b", "c", "d", "e"});
  for (const auto& [name, text] : texts_) {
    EXPECT_THAT(text, Not(HasSubstr("discernible"))) << name;
    EXPECT_THAT(text, Not(HasSubstr("1 none"))) << name;
    EXPECT_THAT(text, Not(HasSubstr("1 (none)"))) << name;
  }
  EXPECT_THAT(output_.summary, Not(HasSubstr("discernible")));
  EXPECT_THAT(texts_.at("rating_counts.csv"), HasSubstr("artifacts,od,1,a,"));
}

TEST_F(ProtocolsLabels, CannotSteerTheTerminal) {
  analyse_with({"a\x1b[31m", "b\nc"});
  EXPECT_THAT(output_.summary, HasSubstr("1 a?[31m to 5 b c"));
}

TEST_F(ProtocolsLabels, OfAmendedSessionsAreSaidToo) {
  study::StudyRecords records = complete_study(3);
  records.amended.push_back(
      {"P2",
       {.sha256 = "0a1b",
        .changed = {"rating"},
        .text = "[[rating]]\nid = \"artifacts\"\ntext = \"?\"\nlabels = [\"keine\", \"alle\"]\n"}});
  analyse(records);
  const std::string sentence =
      "In 1 analysed session, by an amended protocol, the points were 1 keine to 5 alle";
  for (const char* file : {"report.html", "codebook.csv", "OUTPUTS.md", "ratings-artifacts.tex",
                           "bids/task-preview_beh.json", "psych-ds/dataset_description.json"}) {
    EXPECT_THAT(texts_.at(file), HasSubstr(sentence)) << file;
  }
}

}  // namespace
}  // namespace foveola::analysis
