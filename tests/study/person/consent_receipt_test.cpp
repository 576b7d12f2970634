#include "study/person/consent_receipt.h"

#include <gmock/gmock.h>

namespace foveola::study {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(ConsentReceipt, SaysWhatWasAgreedToAndWhen) {
  Protocol protocol;
  protocol.title = "A study of halls";
  protocol.name = "halls";
  protocol.sha256 = "abc";
  protocol.texts["consent"] = "You will look at halls.";
  const std::vector<LoggedEvent> events = {{.event = SessionStarted{}, .utc = "then"},
                                           {.event = ConsentGiven{}, .utc = "2026-11-27T10:00Z"}};
  EXPECT_THAT(consent_receipt(protocol, "P07", events).value(),
              AllOf(HasSubstr("A study of halls"), HasSubstr("You will look at halls."),
                    HasSubstr("participant P07 at 2026-11-27T10:00Z"), HasSubstr("abc")));
  EXPECT_FALSE(consent_receipt(protocol, "P07", {events.front()}));
}

}  // namespace
}  // namespace foveola::study
