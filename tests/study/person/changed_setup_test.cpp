// Which differences of equipment have to be accepted before a session.
#include "study/person/changed_setup.h"

#include "renderer/base/error.h"
#include "tests/matchers.h"

namespace foveola::study {
namespace {

const std::string before =
    R"({"display":{"framebuffer":[640,480]},"machine":{"threads":4},"speed":1,)"
    R"("preflight":{"speeds":[{"samples_per_second":1000}]}})";
const std::string now = R"({"display":{"framebuffer":[320,240]},"machine":{"threads":2},"speed":1,)"
                        R"("preflight":{"speeds":[{"samples_per_second":100}]}})";
const std::vector<SessionSetup> sessions = {
    {"P0", "simulated", {R"({"display":{"framebuffer":[1,1]}})"}},
    {"P1", "human", {"{}", before}},
    {"P2", "human", {before}}};

TEST(ChangedSetup, OfASessionThatIsContinuedIsRefusedButForItsSpeed) {
  const SetupChanges changes = setup_changes(sessions, "P1", now, {});
  EXPECT_THAT(changes.demanded,
              ElementsAre("pixels 320 x 240 (before: 640 x 480)", "threads 2 (before: 4)"));
  EXPECT_THAT(changes.others, ElementsAre("samples a second 100 (before: 1000)"));
  EXPECT_THROW(require_same_setup(changes, "P1"), Error);
  EXPECT_THAT(setup_changes(sessions, "P1", before, {}).demanded, IsEmpty());
}

TEST(ChangedSetup, AmongPeopleIsWarnedOfOnce) {
  const SetupChanges changes = setup_changes(sessions, "P3", now, {});
  EXPECT_THAT(changes.demanded, IsEmpty());
  EXPECT_THAT(changes.others, ElementsAre("pixels 320 x 240 (P1: 640 x 480)", "threads 2 (P1: 4)",
                                          "samples a second 100 (P1: 1000)"));
}

TEST(ChangedSetup, AmongPeopleIsRefusedWhereTheProtocolAsksForTheSame) {
  EXPECT_THAT(setup_changes(sessions, "P3", now, {.same_display = true}).demanded,
              ElementsAre("pixels 320 x 240 (P1: 640 x 480)"));
  EXPECT_THAT(setup_changes(sessions, "P3", now, {.same_machine = true}).demanded,
              ElementsAre("threads 2 (P1: 4)", "samples a second 100 (P1: 1000)"));
}

}  // namespace
}  // namespace foveola::study
