#include "renderer/gaze/open_gaze/open_gaze_tracker.h"

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <netdb.h>

#include "renderer/base/error.h"
#include "tests/renderer/gaze/gaze_expectations.h"
#include "tests/renderer/gaze/tracker_server.h"
#include "tests/waiting.h"

namespace foveola {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using test::TrackerServer;
using test::wait_until;

// Its right edge is 45 degrees off, and its lower edge as well.
constexpr Screen square{
    .width_m = 1.0, .height_m = 1.0, .horizontal_fov_deg = 90.0, .vertical_fov_deg = 90.0};

/// The best point of gaze, valid.
std::string record(double x, double y, int count = 1) {
  return fmt::format("<REC CNT=\"{}\" BPOGX=\"{}\" BPOGY=\"{}\" BPOGV=\"1\" />\r\n", count, x, y);
}

std::string timed_record(double time_s) {
  return fmt::format("<REC TIME=\"{}\" BPOGX=\"0.5\" BPOGY=\"0.5\" BPOGV=\"1\" />\r\n", time_s);
}

bool is_near(const Vec3& direction, const Vec3& expected) {
  return glm::distance(direction, glm::normalize(expected)) < 1e-6F;
}

OpenGazeDecoder decoder_with(const OpenGazeSettings& settings) { return {settings, {}}; }

TEST(OpenGazeDecoder, FractionsBecomeDirections) {
  OpenGazeDecoder decoder = decoder_with({.screen = square});
  const auto right = newest(decoder.decode(record(1.0, 0.5), seconds(1)));
  ASSERT_TRUE(right);
  EXPECT_TRUE(right->valid);
  EXPECT_TRUE(is_near(right->direction, {1.0F, 0.0F, -1.0F}));
  const auto corner = newest(decoder.decode(record(0.0, 1.0), seconds(1)));
  EXPECT_TRUE(is_near(corner->direction, {-1.0F, -1.0F, -1.0F}));
}

TEST(OpenGazeDecoder, OfSeveralRecordsAllInOrder) {
  OpenGazeDecoder decoder = decoder_with({.screen = square});
  const auto samples = decoder.decode(record(0.0, 0.5, 1) + record(1.0, 0.5, 2), seconds(1));
  ASSERT_EQ(samples.size(), 2U);
  EXPECT_TRUE(is_near(samples[0].direction, {-1.0F, 0.0F, -1.0F}));
  EXPECT_TRUE(is_near(samples[1].direction, {1.0F, 0.0F, -1.0F}));
  EXPECT_EQ(decoder.counters().records, 2U);
  EXPECT_FALSE(newest(decoder.decode("<ACK ID=\"X\" />\n", seconds(2))));
}

TEST(OpenGazeDecoder, WithoutATimeASampleIsFromItsArrivalLessTheLatency) {
  OpenGazeDecoder decoder = decoder_with({.screen = square, .latency = milliseconds(20)});
  EXPECT_EQ(newest(decoder.decode(record(0.5, 0.5), seconds(7)))->time, milliseconds(6980));
}

// The second record has waited for 8 ms on its way, and the third for 3.
TEST(OpenGazeDecoder, TheTrackersTimeTakesTheWaitingOut) {
  OpenGazeDecoder decoder = decoder_with({.screen = square, .latency = milliseconds(20)});
  const auto time = [&](double time_s, int arrival_ms) {
    return newest(decoder.decode(timed_record(time_s), milliseconds(arrival_ms)))->time;
  };
  EXPECT_EQ(time(100.0, 5000), milliseconds(4980));
  EXPECT_EQ(time(100.016, 5024), milliseconds(4996));
  EXPECT_EQ(time(100.032, 5035), milliseconds(5012));
}

// As some programs write them, to whom it may come twice, with commas, and in lines that end in CR.
TEST(OpenGazeDecoder, ARecordThatComesTwiceIsOneSample) {
  OpenGazeDecoder decoder = decoder_with({.screen = square});
  std::size_t samples = 0;
  for (int count = 1; count <= 60; ++count) {
    const std::string once = record(0.5, 0.5, count);
    samples += decoder.decode(once, seconds(count)).size();
    samples += decoder.decode(once, seconds(count)).size();
  }
  EXPECT_EQ(samples, 60U);
  EXPECT_EQ(decoder.counters().records, 60U);
  const std::string rests = "<REC BPOGX=\"0.5\" BPOGY=\"0.5\" BPOGV=\"1\" />\n";
  EXPECT_EQ(decoder.decode(rests + rests, seconds(61)).size(), 2U) << "an eye that rests";
}

TEST(OpenGazeDecoder, DecimalCommasAndLinesThatEndInCrAreRead) {
  OpenGazeDecoder decoder = decoder_with({.screen = square});
  const auto samples = decoder.decode(
      "<REC CNT=\"1\" TIME=\"1,5\" BPOGX=\"1,0\" BPOGY=\"0,5\" BPOGV=\"1\" />\r"
      "<REC CNT=\"2\" TIME=\"1,6\" BPOGX=\"0,0\" BPOGY=\"0,5\" BPOGV=\"1\" />\r",
      seconds(1));
  ASSERT_EQ(samples.size(), 2U);
  EXPECT_TRUE(samples[0].valid && samples[1].valid);
  EXPECT_TRUE(is_near(samples[0].direction, {1.0F, 0.0F, -1.0F}));
  EXPECT_TRUE(is_near(samples[1].direction, {-1.0F, 0.0F, -1.0F}));
  EXPECT_EQ(decoder.counters().garbage, 0U);
  EXPECT_EQ(decoder.counters().unreadable, 0U);
  decoder.decode("<REC CNT=\"3\" BPOGX=\"1.000,5\" BPOGY=\"0.5\" BPOGV=\"1\" />\r", seconds(2));
  EXPECT_EQ(decoder.counters().unreadable, 1U);
}

TEST(OpenGazeDecoder, CountsWhatComes) {
  OpenGazeDecoder decoder({.screen = square}, {.records = 10, .garbage = 20});
  for (const int count : {1, 2, 5, 6, 9, 3}) {
    newest(decoder.decode(record(0.5, 0.5, count), seconds(1)));
  }
  decoder.decode("nonsense\r\n<REC\r\n", seconds(2));
  const OpenGazeCounters counters = decoder.counters();
  EXPECT_EQ(counters.records, 16U);
  EXPECT_EQ(counters.garbage, 22U);
}

OpenGazeSettings settings_for(std::uint16_t port) {
  return {.address = {.port = port},
          .screen = square,
          .reconnect_after = milliseconds(20),
          .longest_silence = std::chrono::hours(1)};
}

void accept_and_answer_requests(TrackerServer& server) {
  server.accept();
  server.receive_until("<SET ID=\"ENABLE_SEND_DATA\" STATE=\"1\" />\r\n");
}

/// Whether the tracker delivers this gaze next.
bool comes_to_look_along(OpenGazeTracker& tracker, const Vec3& direction) {
  std::vector<GazeSample> arrived;
  wait_until("a gaze", [&] {
    tracker.poll(Nanoseconds(0), arrived);
    return !arrived.empty();
  });
  return arrived.front().valid && is_near(arrived.front().direction, direction);
}

TEST(OpenGazeTracker, AsksForDataAndDeliversIt) {
  TrackerServer server;
  OpenGazeTracker tracker(settings_for(server.port()));
  std::vector<GazeSample> arrived;
  tracker.poll(Nanoseconds(0), arrived);
  EXPECT_TRUE(arrived.empty());
  server.accept();
  EXPECT_EQ(server.receive_until("\"ENABLE_SEND_DATA\" STATE=\"1\" />\r\n"), open_gaze_requests());
  const Nanoseconds before = SteadyClock().now();
  server.send(record(1.0, 0.5) + record(0.0, 0.5, 2));
  wait_until("two gazes", [&] {
    tracker.poll(Nanoseconds(0), arrived);
    return arrived.size() >= 2;
  });
  ASSERT_EQ(arrived.size(), 2U);
  EXPECT_TRUE(is_near(arrived[0].direction, {1.0F, 0.0F, -1.0F}));
  EXPECT_TRUE(is_near(arrived[1].direction, {-1.0F, 0.0F, -1.0F}));
  EXPECT_GE(arrived[0].time, before);
  EXPECT_LE(arrived[1].time, SteadyClock().now());
  EXPECT_TRUE(tracker.counters().is_connected);
}

TEST(OpenGazeTracker, ComesBackAfterTheServerHungUp) {
  TrackerServer server;
  OpenGazeTracker tracker(settings_for(server.port()));
  accept_and_answer_requests(server);
  server.send(record(0.0, 0.5) + "<REC CNT=\"2\" BPO");
  EXPECT_TRUE(comes_to_look_along(tracker, {-1.0F, 0.0F, -1.0F}));
  accept_and_answer_requests(server);
  server.send(record(1.0, 0.5, 9));
  EXPECT_TRUE(comes_to_look_along(tracker, {1.0F, 0.0F, -1.0F}));
  const OpenGazeCounters counters = tracker.counters();
  EXPECT_EQ(counters.records, 2U);
  EXPECT_EQ(counters.garbage, 0U);  // half a line is no line
}

TEST(OpenGazeTracker, SaysWhenItIsNotConnected) {
  TrackerServer server;
  OpenGazeSettings settings = settings_for(server.port());
  settings.reconnect_after = std::chrono::hours(1);
  OpenGazeTracker tracker(settings);
  accept_and_answer_requests(server);
  wait_until("the connection", [&] { return tracker.counters().is_connected; });
  server.hang_up();
  wait_until("the connection to break", [&] { return !tracker.counters().is_connected; });
}

// A name can stand for several addresses: where localhost is ::1 first, it is at the second.
TEST(OpenGazeTracker, FindsTheServerByTheHostsName) {
  if (::gethostbyname("localhost") == nullptr) {
    GTEST_SKIP() << "this computer has no name for itself (/etc/hosts names no localhost)";
  }
  TrackerServer server;
  OpenGazeSettings settings = settings_for(server.port());
  settings.address.host = "localhost";
  const OpenGazeTracker tracker(settings);
  accept_and_answer_requests(server);
}

TEST(OpenGazeTracker, WaitsForAServerThatStartsLater) {
  TrackerServer server(TrackerServer::Begin::later);
  OpenGazeTracker tracker(settings_for(server.port()));
  std::this_thread::sleep_for(milliseconds(50));  // so that it is refused first, as a rule
  server.listen();
  accept_and_answer_requests(server);
  server.send(record(0.5, 0.0));
  EXPECT_TRUE(comes_to_look_along(tracker, {0.0F, 1.0F, -1.0F}));
}

TEST(OpenGazeTracker, GivesUpASilentServerForANewConnection) {
  TrackerServer server;
  OpenGazeSettings settings = settings_for(server.port());
  settings.longest_silence = milliseconds(60);
  OpenGazeTracker tracker(settings);
  server.accept();
  const auto is_connected = [&] { return tracker.counters().is_connected; };
  wait_until("the connection", is_connected);
  wait_until("the connection to be given up", [&] { return !is_connected(); });
  wait_until("another connection", is_connected);
}

// Would wait for an hour otherwise.
TEST(OpenGazeTracker, EndsWhateverItWaitsFor) {
  TrackerServer server;
  OpenGazeSettings settings = settings_for(server.port());
  settings.reconnect_after = std::chrono::hours(1);
  {
    const OpenGazeTracker listening(settings);
    accept_and_answer_requests(server);
  }
  {
    const OpenGazeTracker pausing(settings);
    server.accept();
    server.hang_up();
    std::this_thread::sleep_for(milliseconds(50));
  }
  const OpenGazeTracker just_begun(settings);
}

TEST(OpenGazeTracker, RefusesAHostThatCannotBe) {
  OpenGazeSettings settings = settings_for(4242);
  settings.address.host = std::string(300, 'x');
  EXPECT_THROW(OpenGazeTracker{settings}, Error);
}

}  // namespace
}  // namespace foveola
