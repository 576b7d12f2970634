#include "renderer/base/load_watched.h"

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <mutex>

#include "renderer/base/print.h"

namespace foveola {
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
