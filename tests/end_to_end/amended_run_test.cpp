// A study whose protocol is amended between two parts of a person's session.
#include <filesystem>

#include "renderer/base/files.h"
#include "study/record/maintenance.h"
#include "tests/end_to_end/seated_participant.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

const char* const keys = R"(
methods = ["od"]
phases = ["trials"]
)";
const char* const begun_with = "[timing]\nrating_s = 0.2\n";
const char* const amended = "[timing]\nrating_s = 0.3\n[texts]\nready = \"Turn to it.\"\n";

class AmendedRun : public ::testing::Test {
 protected:
  AmendedRun() {
    participant_.write_protocol(keys, begun_with);
    participant_.begin();
    quit();
  }

  void quit() {
    participant_.wait_for_page();
    participant_.quit();
  }

  std::string refusal(const std::vector<std::string>& options) {
    return participant_.run_besides("P1", options).errors;
  }

  SeatedParticipant participant_;
};

TEST_F(AmendedRun, OtherWordsAndTimeOutsAreTakenWhereThatIsSaid) {
  participant_.write_protocol(keys, amended);
  EXPECT_THAT(refusal({"--resume"}),
              AllOf(HasSubstr("another protocol"), HasSubstr("--amended-protocol")));

  participant_.begin({"--resume", "--amended-protocol"});
  participant_.program().wait_for("goes by an amended protocol");
  quit();
  const Rows notes = participant_.ask(
      "SELECT text FROM note WHERE text LIKE 'goes by an amended protocol%' ORDER BY sequence");
  ASSERT_THAT(notes, SizeIs(1));
  EXPECT_THAT(notes.front(), AllOf(HasSubstr("; changed: texts.ready, timing.rating_s\n"),
                                   HasSubstr("Turn to it."), HasSubstr("scenes = [\"hall\"]")))
      << "the keys and the whole text";
  EXPECT_THAT(participant_.status().output,
              AllOf(HasSubstr("P1 went by a protocol of SHA-256 "),
                    HasSubstr(": texts.ready, timing.rating_s changed")));
}

TEST(AmendedConsent, IsAskedForAnewAndBothAreInTheReceipt) {
  constexpr const char* with_consent = "\nmethods = [\"od\"]\nphases = [\"consent\", \"trials\"]\n";
  SeatedParticipant participant;
  const auto write_protocol = [&](const std::string& consent) {
    participant.write_protocol(with_consent, "[texts]\nconsent = \"" + consent + "\"\n");
  };
  const std::filesystem::path receipt = participant.folder() / "receipt.txt";
  const auto consent_and_quit = [&] {
    participant.wait_for_page();
    participant.type_all({"Return", "Down", "Return"});
    EXPECT_EQ(participant.wait_for_page(), "choosing_object");
    participant.quit();
  };
  write_protocol("You will look at halls.");
  participant.begin({"--receipt", receipt});
  participant.answer_page("Return");  // welcome
  consent_and_quit();
  const std::string first = read_file(receipt);
  EXPECT_THAT(first, HasSubstr("You will look at halls."));

  write_protocol("You will look at yards.");
  participant.begin({"--resume", "--amended-protocol", "--receipt", receipt});
  participant.program().wait_for("it is asked for anew");
  consent_and_quit();
  EXPECT_THAT(read_file(receipt),
              AllOf(HasSubstr("You will look at halls."), HasSubstr("You will look at yards.")));
  EXPECT_THAT(
      participant.ask("SELECT type FROM event ORDER BY sequence"),
      ElementsAre("session_started", "consent_given", "interrupted", "note_written", "note_written",
                  "consent_asked", "resumed", "consent_given", "interrupted"));
  EXPECT_THAT(participant.ask("SELECT count(DISTINCT json_extract(payload, '$.text_sha256')), "
                              "max(json_extract(payload, '$.language')) FROM event "
                              "WHERE type = 'consent_given'"),
              ElementsAre("2|en"));
  participant.expect_no_fault();

  participant.begin({"--resume", "--amended-protocol"});
  EXPECT_EQ(participant.wait_for_page(), "choosing_object") << "it was asked for once";
  participant.quit();
}

}  // namespace
}  // namespace foveola::test
