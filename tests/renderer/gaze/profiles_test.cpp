#include "renderer/gaze/profiles.h"

#include <filesystem>
#include <initializer_list>
#include <string>
#include <utility>

#include <sys/stat.h>

#include "renderer/gaze/latency.h"
#include "tests/error_of.h"
#include "tests/matchers.h"
#include "tests/temporary_folder.h"

namespace foveola {
namespace {

using test::error_of;
using test::TemporaryFolder;

TEST(DisplayProfile, ThePublishedHeadset) {
  const DisplayProfile fove = read_display_profile("fove0");
  EXPECT_EQ(fove.name, "fove0");
  EXPECT_EQ(fove.kind, DisplayKind::headset);
  EXPECT_EQ(fove.width_px, 2560);
  EXPECT_EQ(fove.height_px, 1440);
  EXPECT_EQ(fove.refresh_rate_hz, 70.0);
  EXPECT_EQ(fove.horizontal_fov_deg, 100.0);
  EXPECT_FALSE(fove.lens);
  EXPECT_EQ(fove.scan_out.provenance, Provenance::assumed);
  EXPECT_NEAR(fove.scan_out.duration_s, 0.014, 1e-12);
  EXPECT_THAT(fove.toml, HasSubstr("title = \"FOVE 0\""));
}

// 24 inches of 16:9 at 0.6 m, by trigonometry: half the width is 12 x 16 / sqrt(337) inches.
TEST(DisplayProfile, TheDesktopsFieldOfViewIsThatOfItsSize) {
  const DisplayProfile desktop = read_display_profile("desktop");
  EXPECT_EQ(desktop.kind, DisplayKind::monitor);
  EXPECT_EQ(desktop.width_px, 1920);
  EXPECT_EQ(desktop.refresh_rate_hz, 60.0);
  EXPECT_EQ(desktop.viewing_distance_m, 0.6);
  EXPECT_NEAR(desktop.horizontal_fov_deg, 47.76, 0.02);
  EXPECT_NEAR(desktop.vertical_fov_deg, 27.98, 0.02);
}

TEST(DisplayProfile, TheScreenOfAMonitorHasItsSize) {
  const Screen screen = screen_of(read_display_profile("desktop"));
  EXPECT_EQ(screen.width_m, 0.5313);
  EXPECT_EQ(screen.height_m, 0.2989);
  EXPECT_NEAR(screen.horizontal_fov_deg, 47.76, 0.02);
}

TEST(DisplayProfile, TheScreenOfAHeadsetIsAMetreAhead) {
  const Screen screen = screen_of(read_display_profile("fove0"));
  EXPECT_NEAR(screen.width_m, 2.383507, 1e-6);  // 2 tan 50 degrees
  EXPECT_NEAR(screen.height_m, 2.383507, 1e-6);
  EXPECT_EQ(screen.horizontal_fov_deg, 100.0);
}

TEST(TrackerProfile, ThePublishedTracker) {
  const TrackerProfile fove = read_tracker_profile("fove0");
  EXPECT_EQ(fove.name, "fove0");
  EXPECT_EQ(fove.source, TrackerSource::simulated);
  EXPECT_EQ(fove.rate_hz, 120.0);
  EXPECT_NEAR(fove.exposure.duration_s, 0.008, 1e-15);
  EXPECT_NEAR(fove.transfer.duration_s, 0.002, 1e-15);
  EXPECT_NEAR(fove.processing.duration_s, 0.004, 1e-15);
  EXPECT_EQ(fove.simulated.rate_hz, 120.0);
  EXPECT_NEAR(fove.simulated.latency_s, 0.010, 1e-15);
  EXPECT_EQ(fove.simulated.bias_right_deg, 0.0);
}

// Koskela et al. 2018, figure 7, with frames of 14 ms.
TEST(TrackerProfile, WithTheHeadsetGivesThePublishedLatency) {
  const TrackerProfile fove = read_tracker_profile("fove0");
  const LatencyInputs inputs{.tracker_rate_hz = fove.rate_hz,
                             .exposure = fove.exposure,
                             .transfer = fove.transfer,
                             .processing = fove.processing,
                             .frame_interval = {.duration_s = 0.014},
                             .tracing = {.duration_s = 0.014},
                             .scan_out = read_display_profile("fove0").scan_out};
  EXPECT_NEAR(total_latency(latency_stages(inputs)).best_s, 0.038, 1e-15);
}

TEST(Profiles, OfEveryTrackerCanBeRead) {
  EXPECT_THAT(tracker_profile_names(),
              ElementsAre("fove0", "hid", "open-gaze", "openxr", "pointer", "simulated"));
  for (const std::string& name : tracker_profile_names()) {
    EXPECT_EQ(read_tracker_profile(name).name, name);
  }
  EXPECT_EQ(shortest_delay(read_tracker_profile("pointer")), Nanoseconds(0));
}

TEST(Profiles, OfAHeadsetByOpenXrLeaveItsViewsToItsRuntime) {
  const DisplayProfile display = read_display_profile("openxr");
  EXPECT_EQ(display.kind, DisplayKind::openxr);
  EXPECT_EQ(display.horizontal_fov_deg, 0.0);
  EXPECT_EQ(read_tracker_profile("openxr").source, TrackerSource::openxr);
}

TEST(Profiles, AnUnknownNameSaysWhichThereAre) {
  EXPECT_THAT(error_of([] { read_display_profile("projector"); }),
              AllOf(HasSubstr("'projector'"), HasSubstr("desktop, fove0")));
  EXPECT_THAT(error_of([] { read_display_profile("fove1"); }),
              AllOf(HasSubstr("'fove1'"), HasSubstr("did you mean 'fove0'?")));
  EXPECT_THAT(error_of([] { read_tracker_profile(""); }), HasSubstr("open-gaze"));
  EXPECT_THAT(error_of([] { read_tracker_profile("."); }), HasSubstr("open-gaze"));
  EXPECT_THAT(error_of([] { read_tracker_profile("./nowhere.toml"); }),
              HasSubstr("./nowhere.toml: no such file"));
}

const char* const headset = R"(title = "Mine"
kind = "headset"
width_px = 2000
height_px = 1000
refresh_rate_hz = 90
horizontal_fov_deg = 110
vertical_fov_deg = 95.5
lens = { axis = [0.56, 0.5], k1 = 0.22, k2 = 0.24 }
scan_out = { duration_ms = 3, provenance = "measured" }
)";

const char* const monitor = R"(title = "Mine"
kind = "monitor"
width_px = 1000
height_px = 500
refresh_rate_hz = 75.5
width_m = 0.6
height_m = 0.3
viewing_distance_m = 0.3
scan_out = { duration_ms = 13, provenance = "assumed" }
)";

const char* const tracker = R"(title = "Mine"
source = "open-gaze"
rate_hz = 150
exposure = { duration_ms = 1, provenance = "assumed" }
transfer = { duration_ms = 2, provenance = "measured" }
processing = { duration_ms = 3, provenance = "assumed" }

[open_gaze]
host = "tracker.example"
port = 4343
)";

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

DisplayProfile display_from(const std::string& content) {
  const TemporaryFolder folder;
  return read_display_profile(folder.write("mine.toml", content).string());
}

TrackerProfile tracker_from(const std::string& content) {
  const TemporaryFolder folder;
  return read_tracker_profile(folder.write("mine.toml", content).string());
}

TEST(Profiles, AreReadFromAPath) {
  const DisplayProfile mine = display_from(headset);
  EXPECT_EQ(mine.name, "mine");
  EXPECT_EQ(mine.title, "Mine");
  EXPECT_EQ(mine.vertical_fov_deg, 95.5);
  EXPECT_EQ(mine.lens, (RadialLens{.axis = {0.56F, 0.5F}, .k1 = 0.22F, .k2 = 0.24F}));
  EXPECT_EQ(mine.scan_out.provenance, Provenance::measured);
  EXPECT_EQ(mine.toml, headset);
  EXPECT_NEAR(display_from(monitor).horizontal_fov_deg, 90.0, 1e-12);

  const TrackerProfile other = tracker_from(tracker);
  EXPECT_EQ(other.open_gaze.host, "tracker.example");
  EXPECT_EQ(other.open_gaze.port, 4343);
  EXPECT_EQ(other.transfer.provenance, Provenance::measured);
}

std::string replay_of(const std::string& recording) {
  return "title = \"A replay\"\nsource = \"recorded\"\nrecording = \"" + recording + R"("
rate_hz = 120
exposure = { duration_ms = 8, provenance = "assumed" }
transfer = { duration_ms = 2, provenance = "assumed" }
processing = { duration_ms = 4, provenance = "assumed" }
)";
}

TEST(Profiles, ARecordingIsFoundFromTheProfilesFolder) {
  const TemporaryFolder folder;
  const auto recording = folder.write("recordings/gaze.csv", "");
  const auto file = folder.write("mine.toml", replay_of("recordings/gaze.csv"));
  const TrackerProfile profile = read_tracker_profile(file.string());
  EXPECT_EQ(profile.source, TrackerSource::recorded);
  EXPECT_EQ(profile.recording, std::filesystem::canonical(recording));
}

TEST(Profiles, ARecordingStaysInTheProfilesFolder) {
  const TemporaryFolder folder;
  folder.write("secret.csv", "");
  std::filesystem::create_directories(folder / "home");
  std::filesystem::create_symlink("../secret.csv", folder / "home/link.csv");
  ASSERT_EQ(::mkfifo((folder / "home/pipe.csv").c_str(), 0600), 0);
  const std::pair<const char*, const char*> refused[] = {
      {"/dev/zero", "is an absolute path"},
      {"../secret.csv", "is a path that leads out of the folder"},
      {"link.csv", "is a symbolic link that leads out of the folder"},
      {"pipe.csv", "is not a regular file"},
      {"absent.csv", "is a file that does not exist"}};
  for (const auto& [recording, what] : refused) {
    const std::string file = folder.write("home/mine.toml", replay_of(recording)).string();
    EXPECT_THAT([&] { read_tracker_profile(file); },
                ThrowsMessage<Error>(file + ": its recording '" + recording + "' " + what +
                                     "; put a copy into the folder of the profile"));
  }
}

struct Fault {
  const char* from;
  const char* to;
  const char* message;  ///< a part of it
};

/// Each fault by itself, in a profile that is right otherwise.
template <typename Profile>
void expect_refused(Profile (*read)(const std::string&), const std::string& right,
                    std::initializer_list<Fault> faults) {
  for (const Fault& fault : faults) {
    EXPECT_THAT(error_of([&] { read(with(right, fault.from, fault.to)); }),
                AllOf(HasSubstr("mine.toml:"), HasSubstr(fault.message)))
        << fault.to;
  }
}

TEST(Profiles, WhatIsWrongWithADisplayIsSaidWithItsPlace) {
  expect_refused(display_from, headset,
                 {{"title = \"Mine\"", "", "title is missing"},
                  {"\"headset\"", "\"helmet\"", "mine.toml:2:8"},
                  {"width_px = 2000", "width_px = 2001", "mine.toml:3:12: two views"},
                  {"width_px = 2000", "width_px = 2000.5", "mine.toml:3:12"},
                  {"height_px = 1000", "height_px = 0", "mine.toml:4:13"},
                  {"refresh_rate_hz = 90", "refresh_rate_hz = nan", "mine.toml:5:19"},
                  {"horizontal_fov_deg = 110", "horizontal_fov_deg = 180", "mine.toml:6:22"},
                  {"vertical_fov_deg = 95.5\n", "", "vertical_fov_deg is missing"},
                  {"k2 = 0.24", "k3 = 0.24", "lens.k2 is missing"},
                  {"[0.56, 0.5]", "[0.56, 1.5]", "mine.toml:8:24"},
                  {"duration_ms = 3, ", "", "scan_out.duration_ms is missing"},
                  {"\"measured\"", "\"guessed\"", "mine.toml:9:44"},
                  {"kind", "width_m = 0.5\nkind", "mine.toml:2:1: unknown key 'width_m'"}});
  expect_refused(
      display_from, monitor,
      {{"width_m = 0.6", "width_m = 0.2", "mine.toml:6:11: such a size has no square pixels"},
       {"viewing_distance_m = 0.3\n", "", "viewing_distance_m is missing"},
       {"kind", "horizontal_fov_deg = 90\nkind", "unknown key 'horizontal_fov_deg'"},
       {"kind", "lens = { k1 = 0, k2 = 0 }\nkind", "unknown key 'lens'"}});
}

TEST(Profiles, ADisplaySaysWhatItWasMeasuredToBe) {
  EXPECT_FALSE(display_from(monitor).measured);
  EXPECT_FALSE(display_from(monitor).timing_patch);
  const std::string tables = R"(
[measured]
date = "2026-11-02"
instrument = "a spot meter"
white_cd_m2 = 250.5
gamma = 2.2
[timing_patch]
corner = "top right"
size_px = 48
)";
  const DisplayProfile mine = display_from(monitor + tables);
  ASSERT_TRUE(mine.measured && mine.timing_patch);
  EXPECT_EQ(mine.measured->date, "2026-11-02");
  EXPECT_EQ(mine.measured->instrument, "a spot meter");
  EXPECT_EQ(mine.measured->white_cd_m2, 250.5);
  EXPECT_EQ(mine.measured->gamma, 2.2);
  EXPECT_FALSE(mine.measured->black_cd_m2 || mine.measured->refresh_rate_hz);
  EXPECT_EQ(mine.timing_patch->corner, WindowCorner::top_right);
  EXPECT_STREQ(name_of(mine.timing_patch->corner), "top right");
  EXPECT_EQ(mine.timing_patch->size_px, 48);
  expect_refused(display_from, monitor + tables,
                 {{"date = \"2026-11-02\"\n", "", "measured.date is missing"},
                  {"250.5", "-1", "measured.white_cd_m2"},
                  {"top right", "middle", "there is no corner 'middle'"},
                  {"48", "0", "timing_patch.size_px"}});
}

TEST(Profiles, WhatIsWrongWithATrackerIsSaidWithItsPlace) {
  expect_refused(tracker_from, tracker,
                 {{"\"open-gaze\"", "\"open gaze\"", "mine.toml:2:10"},
                  {"rate_hz = 150", "rate_hz = 0", "mine.toml:3:11"},
                  {"\"open-gaze\"", "\"recorded\"", "recording is missing or empty"},
                  {"transfer", "transport", "transfer is missing"},
                  {"duration_ms = 2", "duration_ms = 2000", "transfer.duration_ms"},
                  {"port = 4343", "port = 65536", "open_gaze.port"},
                  {"\"tracker.example\"", "\"\"", "open_gaze.host is empty"},
                  {"[open_gaze]", "[simulated]", "unknown key 'simulated'"}});
}

}  // namespace
}  // namespace foveola
