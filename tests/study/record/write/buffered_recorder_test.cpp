#include "study/record/write/recorders.h"
#include "tests/matchers.h"
#include "tests/study/record/small_study.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

/// The beginning of a session, with frames and gaze.
void happen(SessionRecorder& recorder) {
  const Procedure procedure = procedure_of(small_protocol(), small_plan());
  SessionState state;
  const auto feed = [&](Nanoseconds time, const Event& event) {
    const std::optional<Transition> next = step(procedure, state, event);
    ASSERT_TRUE(next);
    recorder.record(
        EventEntry{.time = time, .event = event, .before = state, .after = next->state});
    state = next->state;
  };
  feed(ms(0), SessionStarted{});
  feed(ms(1), QuestionnaireAnswered{.questionnaire = "background",
                                    .answers = {{.question = "age", .value = 30.0}}});
  feed(ms(2), ObjectChosen{"vase"});
  feed(ms(3), TrialStarted{});
  feed(ms(4), FirstFramePresented{ms(4)});
  recorder.record(FrameChunk{.attempt = {}, .first = 0, .frames = plausible_frames(5)});
  recorder.record(GazeChunk{.attempt = {}, .first = 0, .samples = plausible_gaze(7)});
  recorder.record(FilmEntry{.attempt = {}, .hash = {.frame = 4, .sha256 = std::string(64, 'a')}});
  feed(ms(900), Marked{ms(900)});
}

class BufferedRecorderTest : public testing::Test {
 protected:
  /// All that is recorded but for what is drawn or dated.
  std::vector<std::string> content() const {
    std::vector<std::string> rows;
    for (const char* sql :
         {"SELECT sequence || time_ns || type || payload FROM event ORDER BY sequence",
          "SELECT hex(data) FROM frame_chunk", "SELECT hex(data) FROM gaze_chunk",
          "SELECT frame || film_sha256 FROM film_hash", "SELECT kind || time_ns FROM mark",
          "SELECT participant || state FROM session"}) {
      for (const std::string& row : query_column(path_, sql)) {
        rows.push_back(row);
      }
    }
    return rows;
  }

  TemporaryFolder folder_;
  fs::path path_ = folder_ / "study.sqlite";
};

TEST_F(BufferedRecorderTest, ABufferedSessionIsTheOneThatIsWrittenAtOnce) {
  {
    StudyStore store(path_, small_protocol());
    StoreRecorder recorder(store, store.begin_session(facts_of("P001"), small_plan()));
    happen(recorder);
  }
  const std::vector<std::string> at_once = content();
  EXPECT_GT(at_once.size(), 10U);
  fs::remove(path_);
  {
    StudyStore store(path_, small_protocol());
    BufferedRecorder buffer;
    happen(buffer);
    EXPECT_EQ(query(path_, "SELECT count(*) FROM session"), "0");
    buffer.write(store, facts_of("P001"), small_plan());
  }
  EXPECT_EQ(content(), at_once);
}

TEST_F(BufferedRecorderTest, ASessionIsWrittenWholeOrNotAtAll) {
  StudyStore store(path_, small_protocol());
  BufferedRecorder buffer;
  happen(buffer);
  buffer.record(
      FilmEntry{.attempt = {},
                .hash = {.frame = 4, .sha256 = std::string(64, 'b')}});  // there is one already
  EXPECT_ANY_THROW(buffer.write(store, facts_of("P001"), small_plan()));
  EXPECT_EQ(query(path_, "SELECT count(*) FROM session"), "0");
  EXPECT_EQ(query(path_, "SELECT count(*) FROM event"), "0");
  BufferedRecorder good;
  happen(good);
  good.write(store, facts_of("P001"), small_plan());
  EXPECT_EQ(query(path_, "SELECT count(*) FROM session"), "1") << "and the store goes on";
}

}  // namespace
}  // namespace foveola::study
