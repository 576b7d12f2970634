#include "renderer/base/files/digest.h"
#include "study/record/maintain/maintenance.h"
#include "study/record/read/study_records.h"
#include "study/record/setup/amendment_note.h"
#include "tests/study/record/study_file.h"

namespace foveola::study {
namespace {

Amendment amendment_of(const std::string& text, const std::vector<std::string>& changed) {
  return {.sha256 = sha256(std::string_view(text)), .changed = changed, .text = text};
}

Protocol small_protocol_of(const std::string& text) {
  Protocol protocol = small_protocol();
  protocol.text = text;
  protocol.sha256 = sha256(std::string_view(text));
  return protocol;
}

TEST(AmendmentNote, ComesBackAsItWas) {
  const Amendment amendment =
      amendment_of("title = \"new\"\n\nscenes = []\n", {"texts.ready", "title"});
  EXPECT_EQ(amendment_in(note_of(amendment)), amendment);
  const Amendment of_comments = amendment_of("# new\n", {});
  EXPECT_EQ(amendment_in(note_of(of_comments)), of_comments);
}

TEST(AmendmentNote, HoldsTheChangedFiles) {
  Amendment amendment = amendment_of("title = \"a\"\n", {"ssq.toml: question[0].text", "title"});
  amendment.files = {{"ssq.toml", "title = \"x; files: \"\nintro = '\u00fc'\n"}};
  EXPECT_EQ(amendment_in(note_of(amendment)), amendment);
}

TEST(AmendmentNote, AnotherNoteIsNone) {
  const std::string note = note_of(amendment_of("title = \"new\"\n", {"title"}));
  EXPECT_FALSE(amendment_in("the phone rang"));
  EXPECT_FALSE(amendment_in(note + "x")) << "another text than its hash is of";
  EXPECT_FALSE(amendment_in(note.substr(0, note.find('\n')))) << "without its text";
  EXPECT_FALSE(amendment_in("")) << "empty";
}

class AmendedStudy : public StudyFile {
 protected:
  void begin() const {
    StudyStore store(path_, small_protocol());
    EXPECT_FALSE(store.amendment());
    begun_session(store);
  }
};

TEST_F(AmendedStudy, OtherWordsAreTakenWhereThatIsAsked) {
  begin();
  std::string anew = small_protocol().text;
  const std::string title = "A small study";
  anew.replace(anew.find(title), title.size(), "Anew");
  const Protocol amended = small_protocol_of(anew);
  EXPECT_THAT(refusal([&] { const StudyStore store(path_, amended); }),
              AllOf(HasSubstr("another protocol"), HasSubstr("--amended-protocol")));
  {
    StudyStore store(path_, amended, OtherProtocol::take_as_amendment);
    EXPECT_EQ(store.amendment(), amendment_of(amended.text, {"title"}));
    PlayedSession session(store, facts_of("P02"), small_plan());
    session.happen(ms(0), SessionStarted{});
    session.happen(ms(0), NoteWritten{note_of(*store.amendment())});
    session.happen(ms(9), NoteWritten{note_of(*store.amendment())});
  }
  EXPECT_EQ(query(path_, "SELECT protocol_text FROM study"), small_protocol().text);
  const StudyRecords records = read_study(path_);
  EXPECT_THAT(records.amended,
              ElementsAre(AmendedSession{.participant = "P02",
                                         .amendment = amendment_of(amended.text, {"title"})}));
  EXPECT_THAT(verify_study(path_).faults, IsEmpty());
}

TEST_F(AmendedStudy, AQuestionnairesFileIsTakenWithOtherWords) {
  const auto with_file = [](const std::string& toml) {
    Protocol protocol = small_protocol();
    protocol.questionnaires[0].file = "you.toml";
    protocol.questionnaires[0].toml = toml;
    return protocol;
  };
  const std::string now = "title = \"You\"\n";
  {
    StudyStore store(path_, with_file("title = \"Yuo\"\n"));
  }
  EXPECT_THAT(
      refusal([&] { const StudyStore store(path_, with_file(now)); }),
      AllOf(HasSubstr("another questionnaire than you.toml"), HasSubstr("--amended-protocol")));
  {
    const StudyStore store(path_, with_file(now), OtherProtocol::take_as_amendment);
    Amendment expected = amendment_of(small_protocol().text, {"you.toml: title"});
    expected.files = {{"you.toml", now}};
    EXPECT_EQ(store.amendment(), expected);
  }
  EXPECT_THAT(refusal([&] {
                const StudyStore store(path_, with_file("[[question]]\nid = \"age\"\n"),
                                       OtherProtocol::take_as_amendment);
              }),
              HasSubstr("you.toml: question[0].id"));
}

TEST_F(AmendedStudy, AnotherDesignIsRefusedByItsKeys) {
  begin();
  const Protocol other = small_protocol_of(small_protocol().text + "[catch_trials]\ncount = 1\n");
  const auto before = folder_.content();
  EXPECT_THAT(
      refusal([&] { const StudyStore store(path_, other, OtherProtocol::take_as_amendment); }),
      AllOf(HasSubstr("another design than small.toml: catch_trials.count differ"),
            HasSubstr("only words and time-outs")));
  EXPECT_EQ(folder_.content(), before);
}

TEST_F(AmendedStudy, ANewStudyHasNothingToAmend) {
  const StudyStore store(path_, small_protocol(), OtherProtocol::take_as_amendment);
  EXPECT_FALSE(store.amendment());
}

}  // namespace
}  // namespace foveola::study
