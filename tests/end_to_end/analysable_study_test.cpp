// A study that could not be analysed is not begun, and what comes out in the record only is said
// before anybody takes part.
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/files.h"
#include "tests/end_to_end/hall.h"

namespace foveola::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::string third_mark = "[[mark]]\nid = \"third\"\ninstruction = \"Now.\"\n";

class AnalysableStudy : public testing::Test, protected Hall {
 protected:
  AnalysableStudy() { std::filesystem::create_directory(own_folder()); }

  std::filesystem::path own_folder() const { return folder / "own"; }
  std::string path_of(const char* name) const { return (own_folder() / name).string(); }

  /// The hall's, with two methods to compare.
  void write_protocol(const std::string& tables) const {
    const std::string one = "methods = [\"od\"]";
    std::string text = hall_protocol() + tables;
    text.replace(text.find(one), one.size(), "methods = [\"od\", \"fv\"]");
    write_file(path_of("p.toml"), text);
  }

  ProgramResult check() const { return run({"study", "check", path_of("p.toml")}); }
  ProgramResult simulate(const std::vector<std::string>& options = {}) const {
    std::vector<std::string> command = {
        "study",          "simulate", path_of("p.toml"), "--db", path_of("study.sqlite"),
        "--participants", "2",        "--predicted"};
    command.insert(command.end(), options.begin(), options.end());
    return run(command);
  }
  ProgramResult run_person() const {
    return run({"study", "run", path_of("p.toml"), "--db", path_of("study.sqlite"), "--participant",
                "P1", "--pilot"});
  }

  /// By every command that begins a study, which leaves nothing.
  void expect_refused(const std::string& tables, const std::string& says) const {
    SCOPED_TRACE(tables);
    write_protocol(tables);
    expect_one_line(check(), 1, says);
    expect_one_line(run_person(), 1, says);
    expect_one_line(simulate(), 1, says);
    std::vector<std::string> left;
    for (const auto& entry : std::filesystem::directory_iterator(own_folder())) {
      left.push_back(entry.path().filename().string());
    }
    EXPECT_THAT(left, ElementsAre("p.toml"));
  }
};

TEST_F(AnalysableStudy, ArtifactsOnAnotherScaleAreRefused) {
  const std::string rating = "[[rating]]\nid = \"artifacts\"\ntext = \"?\"\n";
  expect_refused(rating + "minimum = 0\nmaximum = 100\n",
                 "the rating artifacts is a scale from 0 to 100");
  expect_refused(rating + "maximum = 7\n", "the rating artifacts is a scale from 1 to 7");
  expect_refused(rating +
                     "kind = \"choice\"\noptions = [{ label = \"no\", value = 0 }, "
                     "{ label = \"a bit\", value = 0.5 }]\n",
                 "the rating artifacts is a choice");
}

TEST_F(AnalysableStudy, PlansForWhatIsNotAnalysedAreRefused) {
  const std::string comfort = "[[rating]]\nid = \"comfort\"\ntext = \"?\"\n";
  expect_refused(comfort + "[[analysis.primary]]\nmeasure = \"comfort\"\nmethod = \"fv\"\n",
                 "a comparison of comfort is planned");
  expect_refused(comfort + "[analysis]\nequivalence_margins = { comfort = 1 }\n",
                 "an equivalence of comfort is planned");
}

TEST_F(AnalysableStudy, WhatComesOutInTheRecordOnlyIsWarnedOf) {
  write_protocol("[[mark]]\nid = \"outline\"\ninstruction = \"Now.\"\n" + third_mark +
                 "[[rating]]\nid = \"comfort\"\ntext = \"?\"\n"
                 "[[questionnaire]]\nid = \"load\"\nfile = \"./load.toml\"\n");
  write_file(path_of("load.toml"), "title = \"Load\"\n[[question]]\nid = \"load\"\ntext = \"?\"\n");
  const ProgramResult checked = check();
  EXPECT_EQ(checked.exit_code, 0);
  EXPECT_EQ(std::count(checked.errors.begin(), checked.errors.end(), '\n'), 3) << checked.errors;
  for (const char* what : {"the mark third", "the rating comfort", "the questionnaire load"}) {
    EXPECT_THAT(checked.errors, HasSubstr(std::string("no tables of ") + what));
  }
}

TEST_F(AnalysableStudy, AProtocolWhoseMeasuresAllComeOutIsNotWarnedOf) {
  write_protocol("");
  EXPECT_THAT(check().errors, IsEmpty());
}

TEST_F(AnalysableStudy, SimulatedParticipantsRefuseWhatTheyCannotJudge) {
  write_protocol("[[mark]]\nid = \"outline\"\ninstruction = \"Now.\"\n" + third_mark);
  expect_one_line(simulate(), 1, "cannot judge the mark third");
  EXPECT_FALSE(std::filesystem::exists(path_of("study.sqlite")));
  const ProgramResult drawn = simulate({"--inject", "order:1"});
  EXPECT_EQ(drawn.exit_code, 0) << drawn.errors;
  EXPECT_THAT(drawn.errors, HasSubstr("warning: "));
  write_protocol("[[rating]]\nid = \"comfort\"\ntext = \"?\"\n");
  expect_one_line(simulate(), 1, "cannot judge the rating comfort");
}

TEST_F(AnalysableStudy, LabelsAreTheProtocolsFromTheProtocolToTheReport) {
  write_protocol(
      "[[rating]]\nid = \"artifacts\"\ntext = \"?\"\nlabels = [\"keine & <b>\", \"überall\"]\n");
  ASSERT_EQ(simulate({"--inject", "order:1"}).exit_code, 0);
  const ProgramResult analysed =
      run_foveola({"analyze", path_of("study.sqlite"), "-o", path_of("out")});
  ASSERT_EQ(analysed.exit_code, 0) << analysed.errors;
  EXPECT_THAT(analysed.output,
              AllOf(HasSubstr("1 keine & <b> to 5 überall"), Not(HasSubstr("not discernible"))));
  EXPECT_THAT(read_file(own_folder() / "out/report.html"),
              AllOf(HasSubstr("1 (keine &amp; &lt;b&gt;) to 5 (überall)"),
                    Not(HasSubstr("not discernible"))));
}

}  // namespace
}  // namespace foveola::test
