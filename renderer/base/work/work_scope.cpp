#include "renderer/base/work/work_scope.h"

#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "renderer/base/text/print.h"
#include "renderer/base/text/utf8.h"

namespace foveola {
namespace {

thread_local const WorkScope* current_scope = nullptr;

}  // namespace

WorkScope::WorkScope(std::stop_token stop, Report report)
    : stop_(std::move(stop)), report_(std::move(report)), member_(this) {}

WorkScope::~WorkScope() = default;

void WorkScope::report(const char* step, double fraction_done) const {
  if (report_) {
    report_(step, fraction_done);
  }
}

const WorkScope* WorkScope::current() { return current_scope; }

WorkScope::Member::Member(const WorkScope* scope) : before_(std::exchange(current_scope, scope)) {}

WorkScope::Member::~Member() { current_scope = before_; }

bool is_work_stopped() { return current_scope != nullptr && current_scope->is_stopped(); }

void throw_if_work_stopped() {
  if (is_work_stopped()) {
    throw WorkStopped();
  }
}

namespace {

/// Whether standard error is a terminal that moves its cursor.
bool obeys_escapes() {
  const char* const kind = std::getenv("TERM");
  return ::isatty(STDERR_FILENO) == 1 && (kind == nullptr || std::string_view(kind) != "dumb");
}

/// The beginning of the line that the terminal shows without breaking it.
std::string_view fitting(std::string_view line) {
  constexpr std::size_t default_columns = 80;
  winsize size{};
  const bool is_known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
  return line.substr(0, bytes_of_first(line, (is_known ? size.ws_col : default_columns) - 1));
}

}  // namespace

Progress::Progress(std::string label)
    : label_(std::move(label)),
      terminal_(obeys_escapes()),
      start_(std::chrono::steady_clock::now()),
      last_shown_(terminal_ ? std::chrono::steady_clock::time_point() : start_) {}

Progress::~Progress() {
  if (terminal_) {
    std::fputs("\r\033[K", stderr);
  }
}

void Progress::update(double fraction_done, const std::string& detail) {
  const auto now = std::chrono::steady_clock::now();
  const double elapsed_s = std::chrono::duration<double>(now - start_).count();
  const int tenth = static_cast<int>(fraction_done * 10.0);
  const auto since_shown = now - last_shown_;
  const bool is_due = terminal_ ? since_shown >= std::chrono::milliseconds(100)
                                : tenth > last_tenth_ || since_shown >= std::chrono::minutes(5);
  if (!is_due) {
    return;
  }
  last_shown_ = now;
  last_tenth_ = tenth;
  const std::string left =
      fraction_done > 0.0
          ? human_duration(elapsed_s * (1.0 - fraction_done) / fraction_done) + " left"
          : "";
  const std::string line =
      printable(fmt::format("{}  {:3.0f} %  {}  {}", label_, 100.0 * fraction_done, left, detail));
  std::fputs(terminal_ ? "\r" : "", stderr);
  print_escaped(stderr, terminal_ ? fitting(line) : line);
  std::fputs(terminal_ ? "\033[K" : "\n", stderr);
  std::fflush(stderr);
}

StepProgress::StepProgress(std::string label)
    : label_(std::move(label)), start_(std::chrono::steady_clock::now()) {}

void StepProgress::update(const std::string& step, double fraction_done) {
  constexpr std::chrono::seconds quiet{1};
  const std::scoped_lock lock(mutex_);
  if (step != step_) {
    line_.reset();
    line_.emplace(label_ + step);
    step_ = step;
  }
  if (std::chrono::steady_clock::now() - start_ > quiet) {
    line_->update(fraction_done);
  }
}

std::string human_duration(double duration_s) {
  if (duration_s < 1.0) {
    return fmt::format("{:.0f} ms", duration_s * 1e3);
  }
  const auto total_s = static_cast<long>(std::lround(duration_s));
  if (total_s < 60) {
    return fmt::format("{} s", total_s);
  }
  if (total_s < 3600) {
    return fmt::format("{} m {:02} s", total_s / 60, total_s % 60);
  }
  return fmt::format("{} h {:02} m", total_s / 3600, total_s % 3600 / 60);
}

namespace {

constexpr std::chrono::milliseconds longest_wait{200};

void exit_if_stuck(const std::stop_token& stop, const std::stop_token& loaded) {
  std::mutex mutex;
  std::condition_variable_any changed;
  const std::stop_callback wake(stop, [&] {
    const std::lock_guard lock(mutex);
    changed.notify_all();
  });
  std::unique_lock lock(mutex);
  changed.wait(lock, loaded, [&] { return stop.stop_requested(); });
  changed.wait_for(lock, loaded, longest_wait, [] { return false; });
  if (!loaded.stop_requested()) {
    print_load_stopped();
    std::_Exit(stopped_exit_code);
  }
}

}  // namespace

void print_load_stopped() {
  print_text(stderr, "foveola: stopped while a scene was loaded; nothing was begun\n");
}

StuckLoadExit::StuckLoadExit(const std::stop_token& stop)
    : watcher_([stop](const std::stop_token& loaded) { exit_if_stuck(stop, loaded); }) {}

}  // namespace foveola
