#include "renderer/gaze/open_gaze/tcp_connection.h"

#include <cerrno>
#include <cstring>
#include <memory>

#include <fmt/format.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <unistd.h>

#include "renderer/base/error.h"

namespace foveola {

std::vector<TcpAddress> resolve(const std::string& host, std::uint16_t port) {
  addrinfo hints{};
  hints.ai_family = AF_UNSPEC;
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int failure = ::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found);
  if (failure != 0) {
    throw Error(fmt::format("{}:{}", host, port),
                fmt::format("no such host: {}", ::gai_strerror(failure)),
                "give the name or the number of the tracker's computer");
  }
  const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> owner(found, &::freeaddrinfo);
  std::vector<TcpAddress> addresses;
  for (const addrinfo* entry = found; entry != nullptr; entry = entry->ai_next) {
    TcpAddress& address = addresses.emplace_back();
    address.size = entry->ai_addrlen;
    std::memcpy(&address.bytes, entry->ai_addr, entry->ai_addrlen);
  }
  return addresses;
}

TcpConnection::TcpConnection(const TcpAddress& address)
    : socket_(::socket(address.bytes.ss_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)) {
  // wait_for_connection reports the result: even a refusal may come later.
  const auto* const bytes = reinterpret_cast<const sockaddr*>(&address.bytes);
  if (::connect(socket_, bytes, address.size) == 0 || errno == EINPROGRESS) {
    const int yes = 1;
    ::setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
  }
}

TcpConnection::~TcpConnection() {
  if (socket_ >= 0) {
    ::close(socket_);
  }
}

TcpConnection::Wait TcpConnection::wait_for_connection(std::chrono::milliseconds patience) const {
  const Wait wait = wait_for(POLLOUT, patience);
  int failure = 0;
  socklen_t size = sizeof failure;
  if (wait == Wait::ready &&
      (::getsockopt(socket_, SOL_SOCKET, SO_ERROR, &failure, &size) != 0 || failure != 0)) {
    return Wait::closed;
  }
  return wait;
}

TcpConnection::Wait TcpConnection::wait_for_bytes(std::chrono::milliseconds patience) const {
  return wait_for(POLLIN, patience);
}

TcpConnection::Wait TcpConnection::wait_for(short events,
                                            std::chrono::milliseconds patience) const {
  if (socket_ < 0) {
    return Wait::closed;  // the process has no more sockets, and poll would ignore this one
  }
  pollfd state{.fd = socket_, .events = events, .revents = 0};
  const int count = ::poll(&state, 1, static_cast<int>(patience.count()));
  if (count == 0 || (count < 0 && errno == EINTR)) {
    return Wait::not_yet;
  }
  return count > 0 && (state.revents & events) != 0 ? Wait::ready : Wait::closed;
}

bool TcpConnection::send(std::string_view bytes) const {
  return ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL) ==
         static_cast<ssize_t>(bytes.size());
}

TcpConnection::Received TcpConnection::receive(std::span<char> buffer) const {
  const ssize_t count = ::recv(socket_, buffer.data(), buffer.size(), 0);
  if (count > 0) {
    return {.bytes = {buffer.data(), static_cast<std::size_t>(count)}};
  }
  const bool is_empty = count < 0 && (errno == EAGAIN || errno == EINTR);
  return {.is_closed = !is_empty};
}

}  // namespace foveola
