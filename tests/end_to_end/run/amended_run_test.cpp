// A study whose protocol is amended between two parts of a person's session.
#include <filesystem>

#include "renderer/base/files/files.h"
#include "study/record/maintain/maintenance.h"
#include "tests/end_to_end/run/seated_participant.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

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
  EXPECT_EQ(std::filesystem::status(receipt).permissions(), std::filesystem::perms(0600));

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
