#include "renderer/window/preview_messages.h"

#include "tests/matchers.h"

namespace foveola {
namespace {

using std::chrono::seconds;

TEST(PreviewMessagesTest, GoAfterAWhile) {
  PreviewMessages messages;
  messages.tell(seconds(0), "picture");
  messages.tell(seconds(1), "lost the monitor", MessageStay::long_enough);
  EXPECT_THAT(messages.lines(seconds(3)), ElementsAre("picture", "lost the monitor"));
  EXPECT_THAT(messages.lines(seconds(5)), ElementsAre("lost the monitor"));
  EXPECT_THAT(messages.lines(seconds(17)), IsEmpty());
}

TEST(PreviewMessagesTest, ResultsWaitForAKey) {
  PreviewMessages messages;
  messages.tell(seconds(0), "accuracy", MessageStay::until_key);
  EXPECT_THAT(messages.lines(seconds(1000)), ElementsAre("accuracy"));
  messages.answer_key();
  EXPECT_THAT(messages.lines(seconds(1000)), IsEmpty());
}

TEST(PreviewMessagesTest, TheSameIsSaidOnceAndOnlyTheNewest) {
  PreviewMessages messages;
  messages.tell(seconds(0), "a");
  messages.tell(seconds(3), "a");
  EXPECT_THAT(messages.lines(seconds(6)), ElementsAre("a")) << "told anew, it stays longer";
  for (const char* const text : {"b", "c", "d", "e"}) {
    messages.tell(seconds(6), text);
  }
  EXPECT_THAT(messages.lines(seconds(6)), ElementsAre("b", "c", "d", "e"));
}

}  // namespace
}  // namespace foveola
