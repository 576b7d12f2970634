#include "renderer/base/files/digest.h"
#include "study/person/session_copies.h"
#include "study/record/setup/amendment_note.h"
#include "tests/matchers.h"

namespace foveola::study {
namespace {

constexpr const char* halls = "You will look at halls.";
constexpr const char* yards = "You will look at yards.";

std::string protocol_with(const std::string& consent) {
  return "name = \"halls\"\ntitle = \"A study of halls\"\n[texts]\nconsent = \"" + consent + "\"\n";
}

LoggedEvent amendment_to(const std::string& consent) {
  const std::string text = protocol_with(consent);
  return {
      .event = NoteWritten{note_of(
          {.sha256 = sha256(std::string_view(text)), .changed = {"texts.consent"}, .text = text})}};
}

LoggedEvent consent_at(const std::string& utc, const std::string& text) {
  const std::string digest = text.empty() ? "" : sha256(std::string_view(text));
  return {.event = ConsentGiven{.text_sha256 = digest, .language = "en"}, .utc = utc};
}

std::string receipt(const std::vector<LoggedEvent>& events) {
  return consent_receipt(protocol_with(halls), "P07", events).value_or("");
}

TEST(ConsentReceipt, SaysWhatWasAgreedToAndWhen) {
  EXPECT_THAT(receipt({{.event = SessionStarted{}}, consent_at("2026-11-27T10:00Z", halls)}),
              AllOf(HasSubstr("A study of halls"), HasSubstr(halls),
                    HasSubstr("participant P07 at 2026-11-27T10:00Z"),
                    HasSubstr(sha256(std::string_view(protocol_with(halls))))));
  EXPECT_EQ(receipt({{.event = SessionStarted{}}}), "");
}

TEST(ConsentReceipt, ATextThatWasNeverSeenIsNotInIt) {
  const std::vector<LoggedEvent> events = {consent_at("then", halls), amendment_to(yards)};
  EXPECT_THAT(receipt(events), AllOf(HasSubstr(halls), Not(HasSubstr(yards))));
}

TEST(ConsentReceipt, AConsentThatWasAskedForAnewIsInItToo) {
  const std::string both = receipt({consent_at("first", halls),
                                    amendment_to(yards),
                                    {.event = ConsentAsked{}},
                                    consent_at("second", yards)});
  EXPECT_LT(both.find(halls), both.find("at first"));
  EXPECT_LT(both.find("at first"), both.find(yards));
  EXPECT_LT(both.find(yards), both.find("at second"));
}

TEST(ConsentReceipt, OlderRecordsHaveTheTextOfTheLastAmendmentBefore) {
  EXPECT_THAT(receipt({consent_at("then", "")}), HasSubstr(halls));
  EXPECT_THAT(receipt({amendment_to(yards), consent_at("then", ""), amendment_to("Another.")}),
              AllOf(HasSubstr(yards), Not(HasSubstr(halls)), Not(HasSubstr("Another."))));
}

TEST(ConsentReceipt, TheTextIsTheOneOfTheDigestWhicheverNoteWasLast) {
  EXPECT_THAT(receipt({amendment_to(yards), consent_at("then", halls)}),
              AllOf(HasSubstr(halls), Not(HasSubstr(yards))));
  EXPECT_THAT(receipt({consent_at("then", yards)}),
              AllOf(HasSubstr("is not in the session's log"), Not(HasSubstr(halls))));
}

}  // namespace
}  // namespace foveola::study
