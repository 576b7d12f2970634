// A TCP connection to a program that may be slow, silent or gone: no call blocks for longer than it
// may.
#pragma once

#include <chrono>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <sys/socket.h>

namespace foveola {

struct TcpAddress {
  sockaddr_storage bytes{};
  socklen_t size = 0;
};

/// All addresses of a host, which is given by its name or number; at least one. To look it up may
/// take seconds. Throws Error if it is unknown.
std::vector<TcpAddress> resolve(const std::string& host, std::uint16_t port);

/// For use by one thread; ends with its scope.
class TcpConnection {
 public:
  enum class Wait { ready, not_yet, closed };

  /// Begins to connect.
  explicit TcpConnection(const TcpAddress& address);
  ~TcpConnection();
  TcpConnection(const TcpConnection&) = delete;
  TcpConnection& operator=(const TcpConnection&) = delete;

  /// Until the connection is made (ready) or refused (closed).
  Wait wait_for_connection(std::chrono::milliseconds patience) const;
  /// Until there is something to receive, be it the end.
  Wait wait_for_bytes(std::chrono::milliseconds patience) const;

  /// Sends a few hundred bytes, which a new connection takes at once; returns whether it took all.
  bool send(std::string_view bytes) const;
  /// What has arrived, at the front of `buffer`. closed: the other side has hung up, or it failed.
  struct Received {
    std::string_view bytes;
    bool is_closed = false;
  };
  Received receive(std::span<char> buffer) const;

 private:
  Wait wait_for(short events, std::chrono::milliseconds patience) const;

  int socket_ = -1;
};

}  // namespace foveola
