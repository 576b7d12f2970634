#include "study/protocol/amendment.h"

#include "tests/matchers.h"
#include "tests/study/protocol/protocol_folder.h"

namespace foveola::study {
namespace {

const std::string begun_with = minimal + R"(
# a comment
phases = ["before", "trials"]
[timing]
mark_timeout_s = 60
[[mark]]
id = "outline"
instruction = "Press."
[[rating]]
id = "artifacts"
text = "How many?"
labels = ["none", "many"]
[[questionnaire]]
id = "before"
[[questionnaire.question]]
id = "gender"
text = "Which?"
kind = "choice"
options = [{ label = "a", value = 1 }, { label = "other" }]
[[override]]
scene = "room"
timing = { rating_s = 3 }
film = { width = 64 }
)";

/// The changes when `before` in the protocol is replaced by `after`.
ProtocolChanges changes_by(const std::string& before, const std::string& after) {
  std::string text = begun_with;
  const std::size_t found = text.find(before);
  EXPECT_NE(found, std::string::npos) << before;
  text.replace(found, before.size(), after);
  return changes_between(begun_with, text, "p.toml");
}

/// Of a change of words or time-outs alone.
std::vector<std::string> amended_by(const std::string& before, const std::string& after) {
  const ProtocolChanges changes = changes_by(before, after);
  EXPECT_THAT(changes.of_design, IsEmpty());
  return changes.of_words_and_times;
}

std::vector<std::string> redesigned_by(const std::string& before, const std::string& after) {
  return changes_by(before, after).of_design;
}

TEST(ProtocolChanges, CommentsAndSpacesAreNone) {
  EXPECT_THAT(amended_by("# a comment", "   # another\n"), IsEmpty());
}

TEST(ProtocolChanges, WordsMayChange) {
  EXPECT_THAT(amended_by("A small one", "Another"), ElementsAre("title"));
  EXPECT_THAT(amended_by("\"Press.\"", "\"Press a key.\""), ElementsAre("mark[0].instruction"));
  EXPECT_THAT(amended_by("How many?", "How few?"), ElementsAre("rating[0].text"));
  EXPECT_THAT(amended_by("\"many\"", "\"very many\""), ElementsAre("rating[0].labels[1]"));
  EXPECT_THAT(amended_by("Which?", "What?"), ElementsAre("questionnaire[0].question[0].text"));
  EXPECT_THAT(amended_by("[timing]", "[texts]\nready = \"Go!\"\n[timing]"),
              ElementsAre("texts.ready"));
  EXPECT_THAT(amended_by("phases", "language = \"fi\"\nphases"), ElementsAre("language"));
}

TEST(ProtocolChanges, WordsOfAQuestionnairesFileMayChange) {
  const std::string before = "title = \"You\"\n[[question]]\nid = \"age\"\ntext = \"Agge?\"\n";
  const auto changes = [&](const std::string& word, const std::string& other) {
    std::string after = before;
    after.replace(after.find(word), word.size(), other);
    return changes_of_questionnaire(before, after, "you.toml");
  };
  EXPECT_THAT(changes("Agge", "Age").of_words_and_times, ElementsAre("you.toml: question[0].text"));
  EXPECT_THAT(changes("Agge", "Age").of_design, IsEmpty());
  EXPECT_THAT(changes("You", "Us").of_words_and_times, ElementsAre("you.toml: title"));
  EXPECT_THAT(changes("\"age\"", "\"years\"").of_design, ElementsAre("you.toml: question[0].id"));
}

// What is asked for is then of another picture.
TEST(ProtocolChanges, WhetherThePictureConvergesWhileItIsRatedIsOfTheDesign) {
  EXPECT_THAT(redesigned_by("mark_timeout_s = 60", "mark_timeout_s = 60\nwhile_rating = \"held\""),
              ElementsAre("timing.while_rating"));
}

TEST(ProtocolChanges, TimeOutsMayChange) {
  EXPECT_THAT(amended_by("mark_timeout_s = 60", "mark_timeout_s = 90"),
              ElementsAre("timing.mark_timeout_s"));
  EXPECT_THAT(amended_by("rating_s = 3", "rating_s = 5"),
              ElementsAre("override[0].timing.rating_s"));
}

TEST(ProtocolChanges, WhatIsMeasuredIsOfTheDesign) {
  EXPECT_THAT(redesigned_by("name = \"small\"", "name = \"smaller\""), ElementsAre("name"));
  EXPECT_THAT(redesigned_by("\"room\"]", "\"hall\"]"), ElementsAre("scenes[1]"));
  EXPECT_THAT(redesigned_by("\"fv\"]", "\"fv\", \"vp\"]"), ElementsAre("methods[2]"));
  EXPECT_THAT(redesigned_by("\"outline\"", "\"shape\""), ElementsAre("mark[0].id"));
  EXPECT_THAT(redesigned_by("[timing]", "[tracker.filter]\nhold_s = 0.6\n[timing]"),
              ElementsAre("tracker.filter.hold_s"));
  EXPECT_THAT(redesigned_by("labels =", "maximum = 7\nlabels ="), ElementsAre("rating[0].maximum"));
  EXPECT_THAT(redesigned_by("width = 64", "width = 128"), ElementsAre("override[0].film.width"));
  EXPECT_THAT(redesigned_by("phases", "scene_order = \"latin\"\nphases"),
              ElementsAre("scene_order"));
  EXPECT_THAT(redesigned_by("phases", "practice = []\nphases"), ElementsAre("practice"))
      << "nothing in it, but it stands there";
}

TEST(ProtocolChanges, AnOptionsLabelIsAnAnswerUnlessItHasAValue) {
  EXPECT_THAT(amended_by("label = \"a\"", "label = \"b\""),
              ElementsAre("questionnaire[0].question[0].options[0].label"));
  EXPECT_THAT(redesigned_by("label = \"other\"", "label = \"another\""),
              ElementsAre("questionnaire[0].question[0].options[1].label"));
}

TEST(ProtocolChanges, ANewMarkIsNotOnlyItsWords) {
  const ProtocolChanges changes =
      changes_by("[[rating]]", "[[mark]]\nid = \"more\"\ninstruction = \"Again.\"\n[[rating]]");
  EXPECT_THAT(changes.of_design, ElementsAre("mark[1].id"));
}

}  // namespace
}  // namespace foveola::study
