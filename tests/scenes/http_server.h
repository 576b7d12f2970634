// A web server of this process, whose every answer a test decides.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <thread>

namespace foveola::test {

/// The header of a request, and the bytes of the answer. Called by the server's own thread.
using Answer = std::function<std::string(const std::string& request)>;

class HttpServer {
 public:
  explicit HttpServer(Answer answer);
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  /// Of a document; path begins with a slash.
  std::string address(const std::string& path) const;
  int requests() const { return requests_; }

 private:
  void serve();

  Answer answer_;
  int socket_;
  std::uint16_t port_ = 0;
  std::atomic<int> requests_ = 0;
  std::thread thread_;
};

/// The whole document.
std::string ok(const std::string& body);
/// All but its first `from` bytes, as an answer to a request for these.
std::string rest(const std::string& body, std::size_t from);
/// Promises the whole document and hangs up after `count` bytes.
std::string cut(const std::string& body, std::size_t count);
/// No document, for instance "404 Not Found".
std::string status(const std::string& line);
std::string redirect(const std::string& address);

/// The first byte that a request asks for; 0 if it asks for all.
std::size_t first_byte_wanted(const std::string& request);

}  // namespace foveola::test
