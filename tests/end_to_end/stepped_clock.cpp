// Preloaded into a program: a computer whose clock is set, and which sleeps, when a test says so.
// The file $STEPPED_CLOCK holds a stepped_clock.h's numbers.
#include "tests/end_to_end/stepped_clock.h"

#include <cstdlib>
#include <ctime>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

using foveola::test::ClockSteps;

/// Null if there is no such file.
const volatile ClockSteps* mapped_steps() {
  const char* const path = std::getenv("STEPPED_CLOCK");
  const int file = path != nullptr ? ::open(path, O_RDONLY | O_CLOEXEC) : -1;
  if (file < 0) {
    return nullptr;
  }
  const void* const memory = ::mmap(nullptr, sizeof(ClockSteps), PROT_READ, MAP_SHARED, file, 0);
  ::close(file);
  return memory != MAP_FAILED ? static_cast<const volatile ClockSteps*>(memory) : nullptr;
}

}  // namespace

extern "C" int clock_gettime(clockid_t clock, timespec* time) noexcept {
  static const volatile ClockSteps* const steps = mapped_steps();
  const auto result = static_cast<int>(::syscall(SYS_clock_gettime, clock, time));
  if (steps != nullptr && (clock == CLOCK_REALTIME || clock == CLOCK_BOOTTIME)) {
    time->tv_sec += steps->asleep_s + (clock == CLOCK_REALTIME ? steps->set_by_s : 0);
  }
  return result;
}
