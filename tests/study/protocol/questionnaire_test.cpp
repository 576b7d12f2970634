// What an answer may be, and the questionnaires that come with Foveola.
#include "study/protocol/questionnaire.h"

#include <cmath>

#include "renderer/base/files/files.h"
#include "tests/matchers.h"
#include "tests/scenes/environment.h"
#include "tests/study/protocol/protocol_folder.h"

namespace foveola::study {
namespace {

using testing::Field;

const Question scale{.id = "q", .minimum = 1.0, .maximum = 5.0};
const Question number{.id = "q", .kind = QuestionKind::number, .minimum = 18.0, .maximum = 99.5};
const Question choice{.id = "q",
                      .kind = QuestionKind::choice,
                      .options = {{"yes", 1.0}, {"no", 0.0}, {"perhaps", {}}}};
const Question words{.id = "q", .kind = QuestionKind::text};

TEST(FaultOf, AScaleTakesItsPoints) {
  for (const double point : {1.0, 2.0, 3.0, 4.0, 5.0}) {
    EXPECT_EQ(fault_of(scale, point), "") << point;
  }
  EXPECT_THAT(fault_of(scale, 2.5), HasSubstr("whole"));
  EXPECT_THAT(fault_of(scale, 0.0), AllOf(HasSubstr("1"), HasSubstr("5")));
  EXPECT_THAT(fault_of(scale, 6.0), AllOf(HasSubstr("1"), HasSubstr("5")));
  EXPECT_NE(fault_of(scale, std::nan("")), "");
  EXPECT_THAT(fault_of(scale, "three"), HasSubstr("number"));
}

TEST(FaultOf, ANumberLiesInItsRange) {
  EXPECT_EQ(fault_of(number, 18.0), "");
  EXPECT_EQ(fault_of(number, 40.25), "");
  EXPECT_EQ(fault_of(number, 99.5), "");
  EXPECT_THAT(fault_of(number, 17.9), AllOf(HasSubstr("18"), HasSubstr("99.5")));
  EXPECT_NE(fault_of(number, HUGE_VAL), "");
  EXPECT_NE(fault_of(number, "40"), "");
}

TEST(FaultOf, AChoiceIsOneOfItsOptionsByValueOrElseByLabel) {
  EXPECT_EQ(fault_of(choice, 1.0), "");
  EXPECT_EQ(fault_of(choice, 0.0), "");
  EXPECT_EQ(fault_of(choice, "perhaps"), "");
  EXPECT_NE(fault_of(choice, "yes"), "") << "is recorded as 1";
  EXPECT_NE(fault_of(choice, 2.0), "");
}

TEST(FaultOf, OnlyARequiredQuestionNeedsAnAnswer) {
  for (Question question : {scale, number, choice, words}) {
    EXPECT_NE(fault_of(question, ""), "");
    question.required = false;
    EXPECT_EQ(fault_of(question, ""), "");
  }
  EXPECT_EQ(fault_of(words, "It flickered."), "");
  EXPECT_NE(fault_of(words, 3.0), "");
}

TEST(FaultOf, SpeaksTheProtocolsLanguage) {
  EXPECT_EQ(fault_of(number, 3.0, {{"fault_out_of_range", "{minimum}-{maximum}!"}}), "18-99.5!");
}

Questionnaire ready(const std::string& file) {
  const test::TemporaryFolder folder;
  const Protocol protocol = load_protocol(
      folder.write("p.toml",
                   "name = \"a\"\ntitle = \"b\"\nscenes = [\"s\"]\nmethods = [\"od\"]\n"
                   "[[questionnaire]]\nid = \"ready\"\nfile = \"" +
                       file + "\"\n"));
  return questionnaire_of(protocol, "ready");
}

// Kennedy et al. 1993: sixteen symptoms on four points. Hart, Staveland 1988: six scales of twenty
// steps. Brooke 1996: ten items on five points.
TEST(ReadyQuestionnaires, HaveTheItemsAndScalesOfTheirPapers) {
  struct Form {
    std::string file;
    std::string source;
    std::size_t items;
    double minimum;
    double maximum;
  };
  for (const Form& form :
       {Form{"ssq", "Kennedy", 16, 0.0, 3.0}, Form{"nasa-tlx", "Hart", 6, 0.0, 20.0},
        Form{"sus", "Brooke", 10, 1.0, 5.0}}) {
    const Questionnaire found = ready(form.file);
    EXPECT_EQ(found.file, form.file);
    EXPECT_THAT(found.source, HasSubstr(form.source));
    EXPECT_EQ(found.questions.size(), form.items) << form.file;
    EXPECT_THAT(found.questions, Each(Field(&Question::minimum, form.minimum)));
    EXPECT_THAT(found.questions, Each(Field(&Question::maximum, form.maximum)));
  }
  EXPECT_THAT(ready("ssq").questions,
              Each(Field(&Question::labels, ElementsAre("none", "slight", "moderate", "severe"))));
  EXPECT_THAT(ready("nasa-tlx").questions[3].labels, ElementsAre("Perfect", "Failure"));
}

using QuestionnairesOfFiles = ProtocolTables;

const std::string own = R"(title = "Mine"
source = "Me"
[[question]]
id = "one"
text = "One?"
)";

TEST_F(QuestionnairesOfFiles, LieInTheProtocolsFolder) {
  folder_.write("forms/mine.toml", own);
  const Protocol protocol =
      load("[[questionnaire]]\nid = \"a\"\nfile = \"forms/mine.toml\"\nintro = \"Please.\"\n");
  const Questionnaire& mine = questionnaire_of(protocol, "a");
  EXPECT_EQ(mine.title, "Mine");
  EXPECT_EQ(mine.intro, "Please.") << "the protocol's word over the file's";
  ASSERT_EQ(mine.questions.size(), 1U);
  EXPECT_EQ(mine.questions[0].id, "one");
  EXPECT_EQ(mine.toml, own);
}

// Sickness is asked before and after; the record keeps the file once.
TEST_F(QuestionnairesOfFiles, CanBeAskedTwiceUnderTwoNames) {
  const Protocol protocol = load(
      "phases = [\"before\", \"trials\", \"after\"]\n"
      "[[questionnaire]]\nid = \"before\"\nfile = \"ssq\"\n"
      "[[questionnaire]]\nid = \"after\"\nfile = \"ssq\"\n");
  EXPECT_EQ(questionnaire_of(protocol, "before").questions.size(), 16U);
  const std::vector<NamedProfile> named = named_profiles(protocol);
  ASSERT_EQ(named.size(), 1U);
  EXPECT_EQ(named[0].device, "questionnaire");
  EXPECT_EQ(named[0].name, "ssq");
  EXPECT_EQ(named[0].toml, questionnaire_of(protocol, "after").toml);
}

TEST_F(QuestionnairesOfFiles, ThatAreBadAreRefusedWithBothPlaces) {
  folder_.write("bad.toml", own + "colour = 3\n");
  EXPECT_THAT([&] { load("[[questionnaire]]\nid = \"a\"\nfile = \"bad.toml\"\n"); },
              ThrowsMessage<Error>(AllOf(HasSubstr(path_.string() + ":7:8: "),
                                         HasSubstr("bad.toml:6:1"), HasSubstr("question.colour"))));
}

/// The questionnaire "sus" in three places: beside the protocol, the user's, and Foveola's.
class QuestionnaireNames : public ProtocolTables {
 protected:
  static std::string called(const std::string& title) {
    return "title = \"" + title + "\"\n[[question]]\nid = \"a\"\ntext = \"?\"\nkind = \"text\"\n";
  }
  std::string title_of_sus() const {
    return load("[[questionnaire]]\nid = \"q\"\nfile = \"sus\"\n").questionnaires.at(0).title;
  }

 private:
  scenes::EnvironmentVariable data_home_{"XDG_DATA_HOME", folder_ / "data"};
};

TEST_F(QuestionnaireNames, AreLookedForInThreePlaces) {
  EXPECT_EQ(title_of_sus(), "The system");
  folder_.write("data/foveola/questionnaires/sus.toml", called("The user's"));
  EXPECT_EQ(title_of_sus(), "The user's");
  folder_.write("sus.toml", called("The study's"));
  EXPECT_EQ(title_of_sus(), "The study's");
}

TEST_F(QuestionnaireNames, OtherFilesBesideTheProtocolArePassedOver) {
  folder_.write("sus.toml", "title = \"A study of usability\"\n");
  EXPECT_EQ(title_of_sus(), "The system");
}

TEST_F(QuestionnaireNames, TheUsersOwnAreReadByTheirNames) {
  folder_.write("data/foveola/questionnaires/mine.toml", called("Mine"));
  EXPECT_EQ(load("[[questionnaire]]\nid = \"q\"\nfile = \"mine\"\n").questionnaires[0].title,
            "Mine");
  EXPECT_THAT([&] { load("[[questionnaire]]\nid = \"q\"\nfile = \"mime\"\n"); },
              ThrowsMessage<Error>(HasSubstr("did you mean 'mine'?")));
}

TEST_F(QuestionnaireNames, ProtocolsOfTheUserAreKnownByTheirNamesBeforeFoveolas) {
  EXPECT_EQ(find_protocol("demo").parent_path(), resource_folder() / "protocols");
  const fs::path mine = folder_.write("data/foveola/protocols/demo.toml", minimal);
  EXPECT_EQ(find_protocol("demo"), mine);
  EXPECT_THAT([] { find_protocol("koskela2081"); },
              ThrowsMessage<Error>(HasSubstr("did you mean 'koskela2018'?")));
}

}  // namespace
}  // namespace foveola::study
