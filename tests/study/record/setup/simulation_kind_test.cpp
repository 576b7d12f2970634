#include "study/record/setup/simulation_kind.h"

#include <limits>

#include "renderer/base/error.h"
#include "tests/matchers.h"

namespace foveola::study {
namespace {

const SimulationKind quick{
    .scale = 8.0, .predicted = true, .injected = "order:1.1", .people_sha256 = "abc"};

KnownSession session(SessionKind kind, const std::string& devices) {
  return {.participant = "P001", .kind = kind, .devices = devices};
}

TEST(SimulationKind, ComesBackFromTheRecord) {
  const std::optional<SimulationKind> kind = simulation_kind_in(devices_of(quick));
  ASSERT_TRUE(kind);
  EXPECT_EQ(kind->scale, 8.0);
  EXPECT_TRUE(kind->predicted);
  EXPECT_EQ(kind->injected, "order:1.1");
  EXPECT_EQ(kind->people_sha256, "abc");
  EXPECT_FALSE(simulation_kind_in("{}"));
  EXPECT_FALSE(simulation_kind_in(R"({"display": {}})"));
}

TEST(SimulationKind, HasASpeedOfItsOwnOnlyIfAsked) {
  EXPECT_FALSE(simulation_kind_in(devices_of(quick))->samples_per_second);
  SimulationKind slow = quick;
  slow.samples_per_second = 8e5;
  EXPECT_EQ(simulation_kind_in(devices_of(slow))->samples_per_second, 8e5);
  EXPECT_THAT(
      [&] {
        require_same_kind("study.sqlite", {session(SessionKind::simulated, devices_of(quick))},
                          slow);
      },
      ThrowsMessage<Error>(HasSubstr("samples_per_second: nothing, now 800000")));
}

TEST(SimulationKind, IsWhatItsSessionsSawOfTheProtocol) {
  Protocol protocol;
  protocol.film = {.width = 512, .height = 256};
  protocol.display.view_width = 64;
  protocol.display.view_height = 64;
  protocol.machine.samples_per_second = 7e6;
  EXPECT_EQ(simulated_protocol(protocol, {}).machine.samples_per_second, 7e6);
  const Protocol slow = simulated_protocol(protocol, {.scale = 4.0, .samples_per_second = 8e5});
  EXPECT_EQ(slow.machine.samples_per_second, 2e5);
  EXPECT_EQ(slow.film.width, 256);
  for (const double speed : {0.0, -1.0, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(simulated_protocol(protocol, {.samples_per_second = speed}), UsageError) << speed;
  }
}

TEST(SimulationKind, ReadsWhatEarlierVersionsRecorded) {
  const std::optional<SimulationKind> kind = simulation_kind_in(
      R"({"simulation": {"scale": 8.0, "predicted": true, "plant": "order:1.1", )"
      R"("people_sha256": "abc"}})");
  ASSERT_TRUE(kind);
  EXPECT_EQ(devices_of(*kind), devices_of(quick));
}

TEST(SimulationKind, OneFileHoldsOneKind) {
  const std::vector<KnownSession> sessions = {session(SessionKind::human, "{}"),
                                              session(SessionKind::simulated, devices_of(quick))};
  EXPECT_NO_THROW(require_same_kind("study.sqlite", sessions, quick));
  SimulationKind slow = quick;
  slow.scale = 1.0;
  EXPECT_THAT([&] { require_same_kind("study.sqlite", sessions, slow); },
              ThrowsMessage<Error>(AllOf(HasSubstr("study.sqlite"),
                                         HasSubstr("P001 was simulated in another way"),
                                         HasSubstr("simulation/scale: 8"), HasSubstr("now 1"))));
  SimulationKind rendered = quick;
  rendered.predicted = false;
  EXPECT_THROW(require_same_kind("study.sqlite", sessions, rendered), Error);
  SimulationKind timed = rendered;
  timed.real_time = true;
  EXPECT_THROW(require_same_kind("study.sqlite", sessions, timed), Error);
}

TEST(SimulationKind, WhatWindowsAndProgramsOfBeforeSayMakesNoOther) {
  SimulationKind timed = quick;
  timed.real_time = true;
  std::string in_a_window = devices_of(timed);
  in_a_window.insert(1, R"("display": {"refresh_rate_hz": 59.97}, )");
  EXPECT_TRUE(simulation_kind_in(in_a_window)->real_time);
  EXPECT_NO_THROW(
      require_same_kind("study.sqlite", {session(SessionKind::simulated, in_a_window)}, timed));
  const std::string before_real_time =
      R"({"simulation": {"scale": 8.0, "predicted": true, "injected": "order:1.1",)"
      R"( "people_sha256": "abc"}})";
  EXPECT_NO_THROW(require_same_kind("study.sqlite",
                                    {session(SessionKind::simulated, before_real_time)}, quick));
}

}  // namespace
}  // namespace foveola::study
