#include "tests/scenes/http_server.h"

#include <stdexcept>
#include <string_view>
#include <utility>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace foveola::test {
namespace {

std::string read_request(int connection) {
  std::string request;
  char buffer[1024];
  while (request.find("\r\n\r\n") == std::string::npos) {
    const ssize_t count = ::recv(connection, buffer, sizeof buffer, 0);
    if (count <= 0) {
      break;
    }
    request.append(buffer, static_cast<std::size_t>(count));
  }
  return request;
}

void send_all(int connection, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::send(connection, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count <= 0) {
      return;  // the client has hung up
    }
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

std::string with_head(const std::string& first_line, const std::string& fields,
                      const std::string& body) {
  return "HTTP/1.1 " + first_line + "\r\nConnection: close\r\n" + fields + "\r\n" + body;
}

std::string length(const std::string& body) {
  return "Content-Length: " + std::to_string(body.size()) + "\r\n";
}

}  // namespace

HttpServer::HttpServer(Answer answer)
    : answer_(std::move(answer)), socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  if (::bind(socket_, reinterpret_cast<sockaddr*>(&address), size) != 0 ||
      ::listen(socket_, 8) != 0 ||
      ::getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size) != 0) {
    throw std::runtime_error("no local server");
  }
  port_ = ntohs(address.sin_port);
  thread_ = std::thread([this] { serve(); });
}

HttpServer::~HttpServer() {
  ::shutdown(socket_, SHUT_RDWR);  // wakes accept
  thread_.join();
  ::close(socket_);
}

std::string HttpServer::address(const std::string& path) const {
  return "http://127.0.0.1:" + std::to_string(port_) + path;
}

void HttpServer::serve() {
  for (;;) {
    const int connection = ::accept(socket_, nullptr, nullptr);
    if (connection < 0) {
      return;
    }
    const std::string request = read_request(connection);
    ++requests_;
    send_all(connection, answer_(request));
    ::close(connection);
  }
}

std::string ok(const std::string& body) { return with_head("200 OK", length(body), body); }

std::string rest(const std::string& body, std::size_t from) {
  const std::string part = body.substr(from);
  return with_head("206 Partial Content",
                   length(part) + "Content-Range: bytes " + std::to_string(from) + "-" +
                       std::to_string(body.size() - 1) + "/" + std::to_string(body.size()) + "\r\n",
                   part);
}

std::string cut(const std::string& body, std::size_t count) {
  return with_head("200 OK", length(body), body.substr(0, count));
}

std::string status(const std::string& line) { return with_head(line, length(""), ""); }

std::string redirect(const std::string& address) {
  return with_head("302 Found", length("") + "Location: " + address + "\r\n", "");
}

std::size_t first_byte_wanted(const std::string& request) {
  const std::string field = "Range: bytes=";
  const std::size_t at = request.find(field);
  return at == std::string::npos ? 0 : std::stoul(request.substr(at + field.size()));
}

}  // namespace foveola::test
