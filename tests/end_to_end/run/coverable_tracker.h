// An eye tracker that speaks the Open Gaze API, and that a test can cover and uncover.
#pragma once

#include <atomic>
#include <cstdint>
#include <thread>

#include "tests/renderer/gaze/tracker_server.h"

namespace foveola::test {

/// Sees an eye that looks straight ahead in a SeatedParticipant's window, 60 times a second, for
/// whoever is connected; several programs may come one after another.
class CoverableTracker {
 public:
  CoverableTracker();
  ~CoverableTracker();
  CoverableTracker(const CoverableTracker&) = delete;
  CoverableTracker& operator=(const CoverableTracker&) = delete;

  std::uint16_t port() const { return server_.port(); }
  /// From now on it stays connected and sends nothing. A program that is not sent anything for two
  /// seconds connects anew.
  void cover() { is_covered_ = true; }
  void uncover() { is_covered_ = false; }

 private:
  void serve(const std::stop_token& stop);

  TrackerServer server_;  ///< the thread's, but for its port
  std::atomic<bool> is_covered_ = false;
  std::jthread thread_;
};

}  // namespace foveola::test
