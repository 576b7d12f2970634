#include "renderer/gaze/sample_queue.h"

#include <gtest/gtest.h>

namespace foveola {
namespace {

std::vector<GazeSample> numbered(int first, int count) {
  std::vector<GazeSample> samples;
  for (int i = 0; i < count; ++i) {
    samples.push_back({.time = Nanoseconds(first + i)});
  }
  return samples;
}

TEST(SampleQueue, GivesAllInOrderOnce) {
  SampleQueue queue;
  queue.push(numbered(1, 2));
  queue.push(numbered(3, 1));
  std::vector<GazeSample> arrived = numbered(0, 1);
  queue.take(arrived);
  ASSERT_EQ(arrived.size(), 4U);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(arrived[i].time, Nanoseconds(i));
  }
  queue.take(arrived);
  EXPECT_EQ(arrived.size(), 4U);
}

TEST(SampleQueue, KeepsTheNewestWhileNobodyTakesThem) {
  constexpr int count = 1'000'000;
  SampleQueue queue;
  for (int i = 0; i < count; ++i) {
    queue.push(numbered(i, 1));
  }
  std::vector<GazeSample> arrived;
  queue.take(arrived);
  ASSERT_LE(arrived.size(), SampleQueue::capacity);
  ASSERT_GE(arrived.size(), SampleQueue::capacity / 2);
  for (std::size_t i = 0; i < arrived.size(); ++i) {
    ASSERT_EQ(arrived[arrived.size() - 1 - i].time, Nanoseconds(count - 1 - static_cast<int>(i)));
  }
}

}  // namespace
}  // namespace foveola
