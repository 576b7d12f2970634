// That showing frames in a headset takes no new memory: a program of its own, whose `operator new`
// counts.
#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include <dlfcn.h>
#include <execinfo.h>
#include <gtest/gtest.h>

#include "renderer/headset/headset_motion.h"
#include "tests/openxr/scripted_headset.h"
#include "tests/renderer/headset/worn_headset.h"
#include "tests/x_server.h"

namespace foveola {
namespace {

std::atomic<bool> is_counting = false;
std::atomic<int> allocations = 0;
thread_local bool is_tests_thread = false;
thread_local bool is_looking = false;  ///< which may take memory itself

const char* file_of(const void* code) {
  Dl_info info{};
  return ::dladdr(code, &info) != 0 && info.dli_fname != nullptr ? info.dli_fname : "";
}

/// Whether it is this program that wants memory, perhaps by the standard library, and neither a
/// driver nor the headset's runtime, whose own calls of the standard library come by here, too.
bool is_asked_for_by_this_program() {
  constexpr int deepest = 64;
  void* calls[deepest];
  const int count = ::backtrace(calls, deepest);
  const std::string this_program = file_of(reinterpret_cast<void*>(&is_asked_for_by_this_program));
  return std::all_of(calls, calls + count, [&](const void* call) {
    const std::string_view file = file_of(call);
    return file == this_program || file.find("/libstdc++.so") != std::string_view::npos ||
           file.find("/libc.so") != std::string_view::npos;
  });
}

void count_allocation() {
  if (is_counting && !is_tests_thread && !std::exchange(is_looking, true)) {
    allocations += is_asked_for_by_this_program() ? 1 : 0;
    is_looking = false;
  }
}

class HeadsetAllocations : public ::testing::Test {
 protected:
  HeadsetAllocations() {
    is_tests_thread = true;
    void* calls[1];
    ::backtrace(calls, 1);  // the first call takes memory itself
  }

  /// So many by the headset's thread in the next frames, in which this thread does `act`.
  template <typename Act>
  int allocations_while(const Act& act) {
    constexpr int frames = 30;
    HeadsetEyes eyes(worn_.presenter().motion(), true);
    std::vector<GazeSample> samples;
    const auto watch = [&](std::int64_t until) {
      while (headset_.newest_frame() < until) {
        eyes.poll(worn_.now(), samples);
        act();
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
      }
    };
    watch(headset_.newest_frame() + frames);
    allocations = 0;
    is_counting = true;
    watch(headset_.newest_frame() + frames);
    is_counting = false;
    EXPECT_GT(samples.size(), frames);
    return allocations;
  }

  test::XServer server_;
  test::ScriptedHeadset headset_{
      R"({"refresh_hz": 60, "head": [{"time": 0}, {"time": 100, "yaw_deg": 3000}],
          "gaze": [{"time": 0, "yaw_deg": -10}],
          "eyes": [{"recommended_px": [120, 100]}, {"recommended_px": [120, 100]}]})",
      test::ScriptedHeadset::Validation::off};
  test::WornHeadset worn_;
};

TEST_F(HeadsetAllocations, AreNoneWhileAFrameStays) {
  worn_.show();
  EXPECT_EQ(allocations_while([] {}), 0);
}

TEST_F(HeadsetAllocations, AreNoneWhileFramesCome) {
  EXPECT_EQ(allocations_while([&] { worn_.show(); }), 0);
}

// Otherwise the tests above could not fail.
TEST_F(HeadsetAllocations, AreCounted) {
  is_counting = true;
  std::jthread([] { const auto made = std::make_unique<std::string>(100, 'x'); }).join();
  is_counting = false;
  EXPECT_GE(allocations, 1);
}

}  // namespace
}  // namespace foveola

void* operator new(std::size_t size) {
  foveola::count_allocation();
  if (void* const memory = std::malloc(size)) {
    return memory;
  }
  throw std::bad_alloc();
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t /*size*/) noexcept { std::free(memory); }
