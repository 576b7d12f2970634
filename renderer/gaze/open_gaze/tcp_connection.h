// A TCP connection to a program that may be slow, silent or gone: no call blocks beyond its limit.
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

/// All addresses of a host name or number; at least one. May take seconds. Throws Error if the host
/// is unknown.
std::vector<TcpAddress> resolve(const std::string& host, std::uint16_t port);

/// For one thread; closed at the end of its scope.
class TcpConnection {
 public:
  enum class Wait { ready, not_yet, closed };

  /// Begins to connect.
  explicit TcpConnection(const TcpAddress& address);
  ~TcpConnection();
  TcpConnection(const TcpConnection&) = delete;
  TcpConnection& operator=(const TcpConnection&) = delete;

  /// Waits until the connection is made (ready) or refused (closed).
  Wait wait_for_connection(std::chrono::milliseconds patience) const;
  /// Waits until there is data to receive, or the end.
  Wait wait_for_bytes(std::chrono::milliseconds patience) const;

  /// Sends a few hundred bytes, which a new connection accepts; returns whether it took all.
  bool send(std::string_view bytes) const;
  /// The received bytes, at the front of `buffer`. closed: the connection ended or failed.
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
