// A tracker's program as far as a client sees it: a TCP server whose every step a test decides.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace foveola::test {

/// Each wait gives up after five minutes with std::runtime_error.
class TrackerServer {
 public:
  enum class Begin { now, later };
  /// At a port that is free. later: it keeps the port, and refuses whoever comes until it listens.
  explicit TrackerServer(Begin begin = Begin::now);
  ~TrackerServer();
  TrackerServer(const TrackerServer&) = delete;
  TrackerServer& operator=(const TrackerServer&) = delete;

  std::uint16_t port() const { return port_; }
  void listen() const;
  /// Waits for a client, in place of the one before.
  void accept();
  /// What the client has sent, up to and with `end`.
  std::string receive_until(std::string_view end) const;
  /// Sends to the client, at once.
  void send(std::string_view bytes) const;
  void hang_up();

 private:
  int listener_;
  int client_ = -1;
  std::uint16_t port_ = 0;
};

}  // namespace foveola::test
