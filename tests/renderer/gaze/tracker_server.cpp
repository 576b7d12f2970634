#include "tests/renderer/gaze/tracker_server.h"

#include <stdexcept>

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace foveola::test {
namespace {

void wait_for_input(int socket, const char* what) {
  constexpr int patience_ms = 300'000;
  pollfd state{.fd = socket, .events = POLLIN, .revents = 0};
  if (::poll(&state, 1, patience_ms) <= 0) {
    throw std::runtime_error(what);
  }
}

}  // namespace

TrackerServer::TrackerServer(Begin begin)
    : listener_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  if (::bind(listener_, reinterpret_cast<sockaddr*>(&address), size) != 0 ||
      ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size) != 0) {
    throw std::runtime_error("no local server");
  }
  port_ = ntohs(address.sin_port);
  if (begin == Begin::now) {
    listen();
  }
}

TrackerServer::~TrackerServer() {
  hang_up();
  ::close(listener_);
}

void TrackerServer::listen() const {
  if (::listen(listener_, 8) != 0) {
    throw std::runtime_error("no local server");
  }
}

void TrackerServer::accept() {
  hang_up();
  wait_for_input(listener_, "no client has come");
  client_ = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
  const int yes = 1;
  ::setsockopt(client_, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
}

std::string TrackerServer::receive_until(std::string_view end) const {
  std::string received;
  while (!received.ends_with(end)) {
    char byte = 0;
    wait_for_input(client_, "the client says nothing");
    if (::recv(client_, &byte, 1, 0) != 1) {
      throw std::runtime_error("the client has hung up");
    }
    received += byte;
  }
  return received;
}

void TrackerServer::send(std::string_view bytes) const {
  if (::send(client_, bytes.data(), bytes.size(), MSG_NOSIGNAL) !=
      static_cast<ssize_t>(bytes.size())) {
    throw std::runtime_error("the client takes no bytes");
  }
}

void TrackerServer::hang_up() {
  if (client_ >= 0) {
    ::close(client_);
    client_ = -1;
  }
}

}  // namespace foveola::test
