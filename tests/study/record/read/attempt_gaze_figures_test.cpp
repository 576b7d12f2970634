#include "study/record/read/attempt_gaze_figures.h"

#include "tests/matchers.h"
#include "tests/study/record/small_study.h"

namespace foveola::study {
namespace {

constexpr double radius_deg = 4.0;
constexpr double tolerance_deg = 1e-3;

Vec3 direction_at(double azimuth_deg, double elevation_deg = 0.0) {
  return direction_from(
      {.azimuth_rad = radians(azimuth_deg), .elevation_rad = radians(elevation_deg)});
}

/// Presented 5 ms after its polling, with a valid gaze, straight ahead of the head unless changed.
FrameRow frame_at(int presented_ms, double head_azimuth_deg = 0.0) {
  return {.time = ms(presented_ms - 5),
          .presented = ms(presented_ms),
          .head_azimuth_rad = static_cast<float>(radians(head_azimuth_deg)),
          .gaze = direction_at(head_azimuth_deg),
          .gaze_valid = true,
          .gaze_age = ms(3)};
}

/// Ten frames a hundredth of a second apart from 1 s on, whose gaze is straight ahead, where the
/// object is; a mark a tenth of a second after the first.
WatchedAttempt ten_frames() {
  WatchedAttempt attempt;
  for (int i = 0; i < 10; ++i) {
    attempt.frames.push_back(frame_at(1000 + 10 * i));
  }
  attempt.marks = {{.mark = "outline", .time = ms(1100)}};
  attempt.object = SeenObject{.direction = direction_at(0.0), .radius_deg = radius_deg};
  attempt.view = FieldOfView{.horizontal_deg = 90.0, .vertical_deg = 60.0};
  return attempt;
}

/// What is known of a mark upon one frame, whose head is straight ahead, with the object there.
GazeAtMark mark_with_object_at(const Vec3& direction, const std::optional<FieldOfView>& view) {
  WatchedAttempt attempt = ten_frames();
  attempt.object->direction = direction;
  attempt.view = view;
  return attempt_gaze_figures(attempt).marks.at(0);
}

TEST(AttemptGazeFigures, TheGazeIsOnTheObjectUpToItsRadiusAndTheMargin) {
  WatchedAttempt attempt = ten_frames();
  for (const std::size_t i : {2U, 3U, 4U}) {
    attempt.frames[i].gaze = direction_at(20.0);
  }
  attempt.frames[0].gaze = direction_at(0.0, radius_deg + gaze_margin_deg - 0.05);
  attempt.frames[1].gaze = direction_at(0.0, radius_deg + gaze_margin_deg + 0.05);
  const GazeTimes times = attempt_gaze_figures(attempt).times.value();
  EXPECT_NEAR(times.all_s, 0.1, 1e-12);
  EXPECT_NEAR(times.on_object_s.value(), 0.06, 1e-12);
  EXPECT_NEAR(times.elsewhere_s.value(), 0.04, 1e-12);
  EXPECT_EQ(times.without_gaze_s, 0.0);
}

TEST(AttemptGazeFigures, AGazeThatIsInvalidHeldOrOldIsNone) {
  WatchedAttempt attempt = ten_frames();
  attempt.frames[1].gaze_valid = false;
  attempt.frames[4].gaze_held = true;
  attempt.frames[7].gaze_age = ms(601);
  attempt.frames[9].gaze_valid = false;
  const AttemptGazeFigures figures = attempt_gaze_figures(attempt);
  EXPECT_NEAR(figures.times->without_gaze_s, 0.04, 1e-12);
  EXPECT_NEAR(figures.times->on_object_s.value(), 0.06, 1e-12);
  EXPECT_FALSE(figures.marks.at(0).gaze_from_object_deg);
  EXPECT_NEAR(figures.marks.at(0).object_from_middle_deg.value(), 0.0, tolerance_deg);
}

TEST(AttemptGazeFigures, TheTimeEndsWithTheLastMarkUntilWhichTheLastFrameStands) {
  WatchedAttempt attempt = ten_frames();
  attempt.marks[0].time = ms(1290);
  EXPECT_NEAR(attempt_gaze_figures(attempt).times->on_object_s.value(), 0.29, 1e-12);
  attempt.marks = {{.mark = "outline", .time = ms(1015)}, {.mark = "material", .time = ms(1045)}};
  attempt.frames[4].gaze = direction_at(90.0);
  attempt.frames[5].gaze = direction_at(90.0);
  const GazeTimes times = attempt_gaze_figures(attempt).times.value();
  EXPECT_NEAR(times.all_s, 0.045, 1e-12);
  EXPECT_NEAR(times.elsewhere_s.value(), 0.005, 1e-12);
}

TEST(AttemptGazeFigures, ACensoredMarkEndsTheTimeAndSaysNothingElse) {
  WatchedAttempt attempt = ten_frames();
  attempt.marks.push_back({.mark = "material", .time = ms(2000), .censored = true});
  const AttemptGazeFigures figures = attempt_gaze_figures(attempt);
  EXPECT_NEAR(figures.times->all_s, 1.0, 1e-12);
  ASSERT_THAT(figures.marks, SizeIs(1));
  EXPECT_EQ(figures.marks[0].mark, "outline");
}

TEST(AttemptGazeFigures, WithoutFramesUntilAMarkNothingIsKnown) {
  WatchedAttempt attempt = ten_frames();
  attempt.marks[0].time = ms(999);
  EXPECT_FALSE(attempt_gaze_figures(attempt).times);
  EXPECT_FALSE(attempt_gaze_figures(attempt).marks.at(0).object_from_middle_deg);
  attempt.marks.clear();
  EXPECT_FALSE(attempt_gaze_figures(attempt).times);
  EXPECT_THAT(attempt_gaze_figures(attempt).marks, IsEmpty());
  attempt = ten_frames();
  attempt.frames.clear();
  EXPECT_FALSE(attempt_gaze_figures(attempt).times);
  EXPECT_FALSE(attempt_gaze_figures(attempt).fixations);
  EXPECT_FALSE(attempt_gaze_figures(attempt).marks.at(0).object_in_view);
}

TEST(AttemptGazeFigures, AMarkIsUponTheFrameThatWasOnTheDisplay) {
  WatchedAttempt attempt = ten_frames();
  attempt.frames[5] = frame_at(1050, 30.0);
  attempt.frames[5].gaze = direction_at(10.0);
  const auto at = [&](int time_ms) {
    attempt.marks[0].time = ms(time_ms);
    return attempt_gaze_figures(attempt).marks.at(0);
  };
  EXPECT_NEAR(at(1049).object_from_middle_deg.value(), 0.0, tolerance_deg);
  EXPECT_NEAR(at(1050).object_from_middle_deg.value(), 30.0, tolerance_deg);
  EXPECT_NEAR(at(1059).gaze_from_object_deg.value(), 10.0, tolerance_deg);
  EXPECT_NEAR(at(1060).gaze_from_object_deg.value(), 0.0, tolerance_deg);
}

TEST(AttemptGazeFigures, TheViewEndsAtHalfItsFieldOnEachSide) {
  const FieldOfView view{.horizontal_deg = 90.0, .vertical_deg = 60.0};
  const auto in_view = [&](double azimuth_deg, double elevation_deg) {
    return mark_with_object_at(direction_at(azimuth_deg, elevation_deg), view).object_in_view;
  };
  EXPECT_EQ(in_view(44.9, 0.0), true);
  EXPECT_EQ(in_view(45.1, 0.0), false);
  EXPECT_EQ(in_view(-44.9, 0.0), true);
  EXPECT_EQ(in_view(-45.1, 0.0), false);
  EXPECT_EQ(in_view(0.0, 29.9), true);
  EXPECT_EQ(in_view(0.0, 30.1), false);
  EXPECT_EQ(in_view(0.0, -30.1), false);
}

TEST(AttemptGazeFigures, AnObjectBehindTheHeadIsOutOfEveryView) {
  const GazeAtMark mark = mark_with_object_at(
      direction_at(180.0), FieldOfView{.horizontal_deg = 170.0, .vertical_deg = 170.0});
  EXPECT_EQ(mark.object_in_view, false);
  EXPECT_NEAR(mark.object_from_middle_deg.value(), 180.0, tolerance_deg);
  EXPECT_NEAR(mark.gaze_from_object_deg.value(), 180.0, tolerance_deg);
  EXPECT_FALSE(mark_with_object_at(direction_at(30.0), std::nullopt).object_in_view)
      << "not known without a view";
}

// The edge of a view of 90 degrees lies at distance 1, and is seen at 1 + k1 = 1.5: at 56.3
// degrees.
TEST(AttemptGazeFigures, ALensWidensTheView) {
  FieldOfView view{.horizontal_deg = 90.0, .vertical_deg = 90.0};
  EXPECT_EQ(mark_with_object_at(direction_at(56.0), view).object_in_view, false);
  view.lens.k1 = 0.5F;
  EXPECT_EQ(mark_with_object_at(direction_at(56.0), view).object_in_view, true);
  EXPECT_EQ(mark_with_object_at(direction_at(56.6), view).object_in_view, false);
}

TEST(AttemptGazeFigures, AzimuthsGoOnBehindTheHead) {
  WatchedAttempt attempt = ten_frames();
  attempt.object->direction = direction_at(-179.0);
  for (FrameRow& frame : attempt.frames) {
    frame.head_azimuth_rad = static_cast<float>(radians(178.0));
    frame.gaze = direction_at(179.5);
  }
  const AttemptGazeFigures figures = attempt_gaze_figures(attempt);
  EXPECT_NEAR(figures.times->on_object_s.value(), 0.1, 1e-12);
  EXPECT_NEAR(figures.marks.at(0).object_from_middle_deg.value(), 3.0, tolerance_deg);
  EXPECT_NEAR(figures.marks.at(0).gaze_from_object_deg.value(), 1.5, tolerance_deg);
  EXPECT_EQ(figures.marks.at(0).object_in_view, true);
}

/// Samples a hundredth of a second apart: up to 1090 ms a fixation 30 degrees to the left of the
/// head, until 1110 ms a saccade, then a fixation straight ahead.
std::vector<GazeSample> two_fixations(int first_ms, int last_ms) {
  std::vector<GazeSample> samples;
  for (int time = first_ms; time <= last_ms; time += 10) {
    const double azimuth_deg = time <= 1090 ? -30.0 : time <= 1110 ? -15.0 : 0.0;
    const bool is_saccade = time > 1090 && time <= 1110;
    samples.push_back({.time = ms(time),
                       .direction = direction_at(azimuth_deg),
                       .valid = true,
                       .mark = is_saccade ? GazeMark::saccade : GazeMark::fixation});
  }
  return samples;
}

/// The head looks 30 degrees to the right of the object.
WatchedAttempt with_two_fixations() {
  WatchedAttempt attempt = ten_frames();
  for (FrameRow& frame : attempt.frames) {
    frame.head_azimuth_rad = static_cast<float>(radians(30.0));
  }
  attempt.marks[0].time = ms(1200);
  attempt.samples = two_fixations(1000, 1200);
  return attempt;
}

// The first lasts from 1000 to 1100 ms, the second from 1120 to 1200.
TEST(AttemptGazeFigures, FixationsAreOnTheObjectInTheWorld) {
  const FixationFigures fixations = attempt_gaze_figures(with_two_fixations()).fixations.value();
  EXPECT_EQ(fixations.count, 2U);
  EXPECT_NEAR(fixations.mean_duration_s.value(), 0.09, 1e-12);
  EXPECT_EQ(fixations.on_object, 1U);
}

TEST(AttemptGazeFigures, OnlyTheTimeFromFirstFrameToLastMarkHasFixations) {
  WatchedAttempt attempt = with_two_fixations();
  attempt.samples = two_fixations(900, 1500);
  const FixationFigures fixations = attempt_gaze_figures(attempt).fixations.value();
  EXPECT_EQ(fixations.count, 2U);
  EXPECT_NEAR(fixations.mean_duration_s.value(), 0.09, 1e-12);
  attempt.marks[0].time = ms(1105);
  EXPECT_EQ(attempt_gaze_figures(attempt).fixations->count, 1U);
}

TEST(AttemptGazeFigures, InvalidSamplesOfAFixationSayNothingOfItsPlace) {
  WatchedAttempt attempt = with_two_fixations();
  for (const std::size_t i : {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U}) {
    attempt.samples[i].valid = false;
    attempt.samples[i].direction = direction_at(90.0);
  }
  EXPECT_EQ(attempt_gaze_figures(attempt).fixations->on_object, 1U);
  attempt.samples[0].valid = false;
  attempt.samples[9].valid = false;
  EXPECT_EQ(attempt_gaze_figures(attempt).fixations->on_object, 0U);
}

TEST(AttemptGazeFigures, SamplesWithoutMarksHaveNoFixations) {
  WatchedAttempt attempt = with_two_fixations();
  for (GazeSample& sample : attempt.samples) {
    sample.mark = GazeMark::none;
  }
  EXPECT_FALSE(attempt_gaze_figures(attempt).fixations);
  for (GazeSample& sample : attempt.samples) {
    sample.mark = GazeMark::blink;
  }
  const FixationFigures blinks = attempt_gaze_figures(attempt).fixations.value();
  EXPECT_EQ(blinks.count, 0U);
  EXPECT_FALSE(blinks.mean_duration_s);
  attempt.samples.clear();
  EXPECT_FALSE(attempt_gaze_figures(attempt).fixations);
}

TEST(AttemptGazeFigures, WithoutTheObjectOnlyTheLossIsKnown) {
  WatchedAttempt attempt = with_two_fixations();
  attempt.object.reset();
  attempt.frames[3].gaze_valid = false;
  const AttemptGazeFigures figures = attempt_gaze_figures(attempt);
  EXPECT_NEAR(figures.times->all_s, 0.2, 1e-12);
  EXPECT_NEAR(figures.times->without_gaze_s, 0.01, 1e-12);
  EXPECT_FALSE(figures.times->on_object_s);
  EXPECT_FALSE(figures.times->elsewhere_s);
  EXPECT_FALSE(figures.marks.at(0).gaze_from_object_deg);
  EXPECT_FALSE(figures.marks.at(0).object_from_middle_deg);
  EXPECT_FALSE(figures.marks.at(0).object_in_view);
  EXPECT_EQ(figures.fixations->count, 2U);
  EXPECT_FALSE(figures.fixations->on_object);
}

}  // namespace
}  // namespace foveola::study
