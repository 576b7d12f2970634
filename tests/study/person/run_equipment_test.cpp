#include "study/person/run_equipment.h"

#include <gtest/gtest.h>

#include "renderer/base/error.h"

namespace foveola::study {
namespace {

TEST(SmallestFilm, IsThatOfTheCoarsestTrial) {
  const Protocol protocol = read_protocol(R"(
name = "a"
title = "A"
scenes = ["room", "hall"]
methods = ["od", "fv"]
film = { width = 2048, height = 1024 }
[[override]]
method = "fv"
film.width = 1000
[[override]]
scene = "hall"
method = "fv"
film = { width = 512, height = 128 }
[[override]]
scene = "room"
film.height = 64
)",
                                          "a.toml");
  EXPECT_EQ(smallest_film(protocol), IVec2(512, 128));
}

TEST(SmallestFilm, IsOfATrialAndNotOfSettingsThatNoTrialHas) {
  const Protocol protocol = read_protocol(R"(
name = "a"
title = "A"
scenes = ["room"]
methods = ["od", "fv"]
film = { width = 64, height = 32 }
[[override]]
scene = "room"
film = { width = 2048, height = 1024 }
)",
                                          "a.toml");
  EXPECT_EQ(smallest_film(protocol), IVec2(2048, 1024));
}

TEST(RunEquipment, APersonsSessionThatCountsHasAPersonsEye) {
  for (const TrackerSource source : {TrackerSource::simulated, TrackerSource::recorded}) {
    const TrackerProfile tracker{.name = "t", .source = source};
    EXPECT_THROW(require_real_gaze(tracker, SessionKind::human), Error);
    EXPECT_NO_THROW(require_real_gaze(tracker, SessionKind::pilot));
  }
  EXPECT_NO_THROW(require_real_gaze({.source = TrackerSource::hid}, SessionKind::human));
}

}  // namespace
}  // namespace foveola::study
