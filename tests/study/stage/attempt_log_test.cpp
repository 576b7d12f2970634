#include "study/stage/attempt_log.h"

#include "study/record/read/recorded_gaze.h"
#include "study/record/write/recorders.h"
#include "tests/matchers.h"
#include "tests/study/record/small_study.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

class AttemptLogTest : public testing::Test {
 protected:
  AttemptLogTest() {
    session_.begin();
    session_.choose_and_start(ms(20));
  }

  TemporaryFolder folder_;
  fs::path path_ = folder_ / "study.sqlite";
  StudyStore store_{path_, small_protocol()};
  PlayedSession session_{store_, facts_of("P01"), small_plan()};
  StoreRecorder recorder_{store_, session_.id()};
};

// 70 frames and 120 samples a second for two minutes, one saccade in them.
TEST_F(AttemptLogTest, EverySampleAndFrameIsKeptInOrder) {
  AttemptLog log(recorder_, {});
  constexpr int frame_count = 120 * 70;
  constexpr int samples_before_saccade = 6000;
  int samples = 0;
  for (int frame = 0; frame < frame_count; ++frame) {
    std::vector<GazeSample> arrived;
    for (; samples * 70 < (frame + 1) * 120; ++samples) {
      const bool is_after = samples > samples_before_saccade;
      arrived.push_back({.time = samples * Nanoseconds(8'333'333),
                         .direction = is_after ? Vec3(0.0F, 0.6F, -0.8F) : Vec3(0.0F, 0.0F, -1.0F),
                         .valid = true});
    }
    log.add({.time = frame * Nanoseconds(14'285'714)}, arrived);
  }
  EXPECT_EQ(log.frames(), static_cast<std::uint64_t>(frame_count));
  log.finish(EquirectFilm(2, 1));
  const std::vector<GazeSample> kept = read_gaze(path_, "P01", 0);
  ASSERT_EQ(kept.size(), static_cast<std::size_t>(samples));
  for (int i = 0; i < samples; ++i) {
    ASSERT_EQ(kept[i].time, i * Nanoseconds(8'333'333));
    ASSERT_EQ(kept[i].mark,
              i == samples_before_saccade + 1 ? GazeMark::saccade : GazeMark::fixation)
        << i;
  }
  EXPECT_EQ(query(path_, "SELECT sum(frame_count) FROM frame_chunk"), std::to_string(frame_count));
  EXPECT_EQ(query(path_,
                  "SELECT count(*) FROM frame_chunk AS a, frame_chunk AS b"
                  " WHERE b.first_frame = a.first_frame + a.frame_count"),
            "2");
  EXPECT_EQ(query(path_,
                  "SELECT sum(sample_count) = (SELECT max(first_sample + sample_count)"
                  " FROM gaze_chunk) FROM gaze_chunk"),
            "1");
}

// What a replay needs is in it to the last bit.
TEST_F(AttemptLogTest, AFrameIsKeptAsItWasUsed) {
  const FrameReport report{.time = ms(7),
                           .head = {.azimuth_rad = 1.0 / 3.0, .elevation_rad = -0.1},
                           .head_roll_rad = 0.75,
                           .gaze = {0.6F, 0.0F, -0.8F},
                           .gaze_valid = true,
                           .gaze_held = true,
                           .gaze_age = ms(3),
                           .samples = 4'000'000'000};
  const FrameRow row = frame_row(report);
  EXPECT_EQ(row.time, ms(7));
  const AzimuthElevation kept{.azimuth_rad = row.head_azimuth_rad,
                              .elevation_rad = row.head_elevation_rad};
  EXPECT_EQ(head_orientation(kept, row.head_roll_rad), head_orientation(report.head, 0.75));
  EXPECT_EQ(row.gaze, report.gaze);
  EXPECT_TRUE(row.gaze_valid && row.gaze_held);
  EXPECT_EQ(row.gaze_age, ms(3));
  EXPECT_EQ(row.samples, 4'000'000'000U);
}

TEST_F(AttemptLogTest, WithoutFramesNothingIsKept) {
  AttemptLog log(recorder_, {});
  log.finish(EquirectFilm(2, 1));
  EXPECT_EQ(query(path_,
                  "SELECT (SELECT count(*) FROM frame_chunk) +"
                  " (SELECT count(*) FROM gaze_chunk) + (SELECT count(*) FROM film_hash)"),
            "0");
}

}  // namespace
}  // namespace foveola::study
