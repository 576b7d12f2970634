#include "scenes/download.h"

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include <curl/curl.h>
#include <fmt/format.h>

#include "renderer/base/error.h"

namespace fs = std::filesystem;

namespace foveola::scenes {
namespace {

constexpr long max_redirections = 10;
constexpr long connect_timeout_s = 30;
constexpr long stalled_s = 30;  ///< without a byte

const char* const continue_later = "run the command again to continue";

std::uint64_t size_of(const fs::path& file) {
  std::error_code missing;
  const std::uintmax_t size = fs::file_size(file, missing);
  return missing ? 0 : size;
}

/// Empties the file in place, as it may be locked.
void empty(const fs::path& file) {
  std::error_code is_no_file;
  fs::resize_file(file, 0, is_no_file);
}

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
  void operator()(CURL* curl) const { curl_easy_cleanup(curl); }
};

std::unique_ptr<std::FILE, Close> open_to_append(const fs::path& file) {
  std::unique_ptr<std::FILE, Close> opened(std::fopen(file.c_str(), "ab"));
  if (!opened) {
    throw Error(file.string(), "cannot be written: " + std::generic_category().message(errno),
                "check the folder's permissions and the free space");
  }
  return opened;
}

/// libcurl's initialisation of the whole process, which libcurl counts.
struct CurlLibrary {
  CurlLibrary() { curl_global_init(CURL_GLOBAL_DEFAULT); }
  ~CurlLibrary() { curl_global_cleanup(); }
  CurlLibrary(const CurlLibrary&) = delete;
  CurlLibrary& operator=(const CurlLibrary&) = delete;
};

class Transfer {
 public:
  Transfer(const std::string& address, const fs::path& file, std::uint64_t size_bytes,
           const std::function<void(double)>& progress, const std::stop_token& stop)
      : file_(open_to_append(file)),
        received_(size_of(file)),
        size_bytes_(size_bytes),
        progress_(progress),
        stop_(stop),
        curl_(curl_easy_init()) {
    if (!curl_) {
      throw Error(address, "cannot be downloaded: libcurl does not start", {});
    }
    set(CURLOPT_URL, address.c_str());
    set(CURLOPT_PROTOCOLS_STR, "http,https");
    set(CURLOPT_REDIR_PROTOCOLS_STR, "http,https");
    set(CURLOPT_FOLLOWLOCATION, 1L);
    set(CURLOPT_MAXREDIRS, max_redirections);
    set(CURLOPT_FAILONERROR, 1L);
    set(CURLOPT_CONNECTTIMEOUT, connect_timeout_s);
    set(CURLOPT_LOW_SPEED_LIMIT, 1L);
    set(CURLOPT_LOW_SPEED_TIME, stalled_s);
    set(CURLOPT_NOSIGNAL, 1L);
    set(CURLOPT_ERRORBUFFER, message_);
    set(CURLOPT_RESUME_FROM_LARGE, static_cast<curl_off_t>(received_));
    set(CURLOPT_WRITEFUNCTION, write_callback);
    set(CURLOPT_WRITEDATA, this);
    set(CURLOPT_NOPROGRESS, 0L);
    set(CURLOPT_XFERINFOFUNCTION, progress_callback);
    set(CURLOPT_XFERINFODATA, this);
  }

  CURLcode run() {
    const CURLcode code = curl_easy_perform(curl_.get());
    if (std::fflush(file_.get()) != 0 && write_error_ == 0) {
      write_error_ = errno;
    }
    return code;
  }

  /// Status of the server's answer; 0 if there was none.
  long http_status() const {
    long status = 0;
    curl_easy_getinfo(curl_.get(), CURLINFO_RESPONSE_CODE, &status);
    return status;
  }
  std::string message(CURLcode code) const {
    return message_[0] != '\0' ? message_ : curl_easy_strerror(code);
  }
  std::uint64_t received() const { return received_; }
  std::uint64_t size_bytes() const { return size_bytes_; }
  int write_error() const { return write_error_; }
  bool is_too_long() const { return is_too_long_; }

 private:
  template <typename Value>
  void set(CURLoption option, Value value) {
    curl_easy_setopt(curl_.get(), option, value);
  }

  static std::size_t write_callback(char* bytes, std::size_t, std::size_t count, void* transfer) {
    return static_cast<Transfer*>(transfer)->write(bytes, count);
  }
  /// A nonzero result ends the transfer.
  static int progress_callback(void* transfer, curl_off_t, curl_off_t, curl_off_t, curl_off_t) {
    return static_cast<Transfer*>(transfer)->stop_.stop_requested() ? 1 : 0;
  }

  /// Fewer bytes than given end the transfer.
  std::size_t write(const char* bytes, std::size_t count) {
    if (received_ + count > size_bytes_) {
      is_too_long_ = true;
      return 0;
    }
    if (std::fwrite(bytes, 1, count, file_.get()) != count || std::fflush(file_.get()) != 0) {
      write_error_ = errno;
      return 0;
    }
    received_ += count;
    progress_(static_cast<double>(received_) / static_cast<double>(size_bytes_));
    return count;
  }

  CurlLibrary library_;
  std::unique_ptr<std::FILE, Close> file_;
  std::uint64_t received_;
  std::uint64_t size_bytes_;
  const std::function<void(double)>& progress_;
  const std::stop_token& stop_;
  std::unique_ptr<CURL, Close> curl_;
  char message_[CURL_ERROR_SIZE] = {};
  int write_error_ = 0;
  bool is_too_long_ = false;
};

constexpr long range_not_satisfiable = 416;

/// Returns whether the file's content is not a beginning of the server's: the server cannot
/// continue, or has fewer bytes. libcurl reports the latter as success.
bool cannot_continue(CURLcode code, const Transfer& transfer) {
  return code == CURLE_RANGE_ERROR || transfer.http_status() == range_not_satisfiable;
}

void require_complete(const std::string& address, const fs::path& file, const Transfer& transfer,
                      CURLcode code) {
  if (transfer.is_too_long()) {
    empty(file);
    throw Error(address, "is larger than the descriptor says",
                "it is another file; download it by hand");
  }
  if (transfer.write_error() != 0) {
    throw Error(file.string(),
                "cannot be written: " + std::generic_category().message(transfer.write_error()),
                fmt::format("free space and {}", continue_later));
  }
  if (code == CURLE_ABORTED_BY_CALLBACK) {
    throw Error(address, fmt::format("stopped after {} bytes", transfer.received()),
                continue_later);
  }
  if (code == CURLE_HTTP_RETURNED_ERROR) {
    throw Error(address, fmt::format("the server answers {}", transfer.http_status()),
                "see the scene's origin in 'foveola scene list'");
  }
  if (code != CURLE_OK) {
    throw Error(address,
                fmt::format("{} ({} bytes are here)", transfer.message(code), transfer.received()),
                fmt::format("check the network or http_proxy and {}", continue_later));
  }
  if (transfer.received() < transfer.size_bytes()) {
    empty(file);
    throw Error(address, "is smaller than the descriptor says",
                "it is another file; download it by hand");
  }
}

}  // namespace

void download(const std::string& address, const fs::path& file, std::uint64_t size_bytes,
              const std::function<void(double)>& progress, const std::stop_token& stop) {
  if (size_of(file) > size_bytes) {
    empty(file);
  }
  if (size_of(file) == size_bytes) {
    return;
  }
  {
    Transfer transfer(address, file, size_bytes, progress, stop);
    const CURLcode code = transfer.run();
    if (!cannot_continue(code, transfer)) {
      require_complete(address, file, transfer, code);
      return;
    }
  }
  empty(file);
  Transfer transfer(address, file, size_bytes, progress, stop);
  require_complete(address, file, transfer, transfer.run());
}

}  // namespace foveola::scenes
