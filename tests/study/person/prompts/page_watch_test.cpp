#include "study/person/prompts/page_watch.h"

#include "tests/matchers.h"

namespace foveola::study {
namespace {

using namespace std::chrono_literals;

/// Shows frames of 10 ms from `from` on, on which nothing else is to come. Returns the numbers of
/// the pages whose pictures were due.
std::vector<int> show_frames(PageWatch& watch, int frames, Nanoseconds from = 0s) {
  std::vector<int> pictures;
  for (int i = 0; i < frames; ++i) {
    if (const auto number = watch.picture_due(true)) {
      pictures.push_back(*number);
    }
    watch.was_shown(from + i * 10ms);
  }
  return pictures;
}

TEST(PageWatch, EachPageBecomesAPictureOnceItStands) {
  PageWatch watch;
  EXPECT_THAT(show_frames(watch, 3), IsEmpty());
  EXPECT_THAT(show_frames(watch, 1), ElementsAre(1));
  EXPECT_THAT(show_frames(watch, 50), IsEmpty());
  watch.turn_page();
  EXPECT_THAT(show_frames(watch, 50), ElementsAre(2));
}

// Within an attempt the loop looks only after the page has come and was shown.
TEST(PageWatch, APageThatComesWithinOneFrameIsANewOne) {
  PageWatch watch;
  show_frames(watch, 20);
  watch.turn_page();
  watch.was_shown(1s);
  EXPECT_THAT(show_frames(watch, 3, 2s), ElementsAre(2));
}

TEST(PageWatch, APageThatIsLeftAtOnceBecomesNoPicture) {
  PageWatch watch;
  EXPECT_THAT(show_frames(watch, 3), IsEmpty());
  watch.turn_page();
  EXPECT_THAT(show_frames(watch, 4), ElementsAre(1)) << "pages are not left out";
}

TEST(PageWatch, WhileAnotherPageIsOnItsWayNoPictureIsTaken) {
  PageWatch watch;
  show_frames(watch, 3);
  EXPECT_FALSE(watch.picture_due(false));
  EXPECT_FALSE(watch.picture_due(true)) << "it stands anew";
}

TEST(PageWatch, APageHasOnePicture) {
  PageWatch watch;
  EXPECT_THAT(show_frames(watch, 10), ElementsAre(1));
  EXPECT_FALSE(watch.picture_due(false)) << "a note is on its way";
  EXPECT_THAT(show_frames(watch, 10), IsEmpty());
}

TEST(PageWatch, OnlyWhatCouldBeSeenCanBeAnswered) {
  PageWatch watch;
  EXPECT_FALSE(watch.was_seen_at(5s));
  watch.was_shown(1s);
  watch.was_shown(2s);
  EXPECT_FALSE(watch.was_seen_at(999ms));
  EXPECT_TRUE(watch.was_seen_at(1s));
  watch.turn_page();
  EXPECT_FALSE(watch.was_seen_at(3s)) << "the new page was not shown yet";
}

}  // namespace
}  // namespace foveola::study
