#include "tests/end_to_end/run/coverable_tracker.h"

#include <chrono>
#include <stdexcept>

#include "renderer/gaze/open_gaze/tcp_connection.h"

namespace foveola::test {
namespace {

constexpr std::chrono::milliseconds period{16};

}  // namespace

CoverableTracker::CoverableTracker()
    : thread_([this](const std::stop_token& stop) {
        while (!stop.stop_requested()) {
          try {
            serve(stop);
          } catch (const std::runtime_error&) {
            // Nobody has come, or the program has hung up: the next one may come.
          }
        }
      }) {}

CoverableTracker::~CoverableTracker() {
  thread_.request_stop();
  const TcpConnection end_of_waiting(resolve("127.0.0.1", port()).front());
  thread_.join();
}

void CoverableTracker::serve(const std::stop_token& stop) {
  server_.accept();
  if (stop.stop_requested()) {
    return;
  }
  server_.receive_until("\"ENABLE_SEND_DATA\" STATE=\"1\" />\r\n");
  while (!stop.stop_requested()) {
    if (!is_covered_) {
      // The middle of a window of 640 x 480 in the corner of a screen of 1280 x 1024.
      server_.send("<REC BPOGX=\"0.25\" BPOGY=\"0.234375\" BPOGV=\"1\" />\r\n");
    }
    std::this_thread::sleep_for(period);
  }
}

}  // namespace foveola::test
