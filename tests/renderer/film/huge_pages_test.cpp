#include "renderer/film/huge_pages.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <set>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <sys/mman.h>

#include "tests/waiting.h"

namespace foveola {
namespace {

constexpr std::size_t small_page = 4096;

bool is_zeros(const HugePage& page) {
  return std::all_of(page.get(), page.get() + huge_page,
                     [](std::byte byte) { return byte == std::byte{0}; });
}

/// Whether the system has given all of its memory.
bool is_there(const HugePage& page) {
  std::array<unsigned char, huge_page / small_page> pages{};
  EXPECT_EQ(::mincore(page.get(), huge_page, pages.data()), 0);
  return std::all_of(pages.begin(), pages.end(),
                     [](unsigned char flags) { return (flags & 1U) != 0; });
}

std::vector<HugePage> take(HugePages& from, std::size_t count) {
  std::vector<HugePage> pages;
  for (std::size_t i = 0; i < count; ++i) {
    pages.push_back(from.take());
  }
  return pages;
}

std::vector<HugePage> take_until_a_thread_helps(HugePages& from) {
  return take(from, HugePages::taken_without_thread + 1);
}

void wait_until_all_are_ready(const HugePages& pages) {
  test::wait_until("pages that are ready", [&] { return pages.ready() == HugePages::most_ready; });
}

/// The numbers of this process's threads. Joined threads may be there for a moment longer.
std::set<std::filesystem::path> threads() {
  const std::filesystem::directory_iterator tasks("/proc/self/task");
  return {begin(tasks), end(tasks)};
}

std::size_t threads_since(const std::set<std::filesystem::path>& before) {
  const std::set<std::filesystem::path> now = threads();
  return static_cast<std::size_t>(
      std::ranges::count_if(now, [&](const auto& thread) { return !before.contains(thread); }));
}

TEST(HugePages, WhatIsTakenIsZeros) {
  HugePages pages;
  std::set<std::uintptr_t> places;
  std::vector<HugePage> taken = take_until_a_thread_helps(pages);
  pages.make_ready();
  wait_until_all_are_ready(pages);
  for (HugePage& page : take(pages, HugePages::most_ready + 1)) {
    taken.push_back(std::move(page));
  }
  for (const HugePage& page : taken) {
    EXPECT_TRUE(is_zeros(page));
    std::fill(page.get(), page.get() + huge_page, std::byte{255});
    const auto address = reinterpret_cast<std::uintptr_t>(page.get());
    EXPECT_EQ(address % huge_page, 0U);
    EXPECT_TRUE(places.insert(address).second) << "taken twice";
  }
}

TEST(HugePages, MemoryOfThoseThatAreReadyIsThere) {
  HugePages pages;
  const std::vector<HugePage> before = take_until_a_thread_helps(pages);
  for (const HugePage& page : before) {
    EXPECT_FALSE(is_there(page));
  }
  pages.make_ready();
  wait_until_all_are_ready(pages);
  for (const HugePage& page : take(pages, HugePages::most_ready)) {
    EXPECT_TRUE(is_there(page));
  }
  EXPECT_FALSE(is_there(pages.take()));
}

TEST(HugePages, NoMoreAreReadyThanSaid) {
  HugePages pages;
  const std::vector<HugePage> taken = take_until_a_thread_helps(pages);
  pages.make_ready();
  wait_until_all_are_ready(pages);
  for (int i = 0; i < 5; ++i) {
    pages.make_ready();
    std::this_thread::sleep_for(std::chrono::milliseconds(10));  // time enough for a page
    EXPECT_EQ(pages.ready(), HugePages::most_ready);
  }
  EXPECT_TRUE(is_there(pages.take()));
  pages.make_ready();
  wait_until_all_are_ready(pages);
}

TEST(HugePages, AThreadStartsWhereMoreThanAFewAreTaken) {
  const std::set<std::filesystem::path> before = threads();
  {
    HugePages pages;
    std::vector<HugePage> taken = take(pages, HugePages::taken_without_thread);
    pages.make_ready();
    EXPECT_EQ(threads_since(before), 0U);
    taken.push_back(pages.take());
    EXPECT_EQ(threads_since(before), 0U);
    pages.make_ready();
    pages.make_ready();
    EXPECT_EQ(threads_since(before), 1U);
  }
  test::wait_until("the thread's end", [&] { return threads_since(before) == 0; });
}

TEST(HugePages, ManyThreadsTakeThemWhileOneMakesThem) {
  HugePages pages;
  std::vector<std::vector<HugePage>> taken(4);
  {
    std::vector<std::jthread> takers;
    for (std::vector<HugePage>& mine : taken) {
      takers.emplace_back([&] {
        for (int round = 0; round < 20; ++round) {
          mine.push_back(pages.take());
          pages.make_ready();
        }
      });
    }
  }
  std::set<const std::byte*> places;
  for (const std::vector<HugePage>& mine : taken) {
    for (const HugePage& page : mine) {
      page[0] = page[huge_page - 1] = std::byte{1};
      places.insert(page.get());
    }
  }
  EXPECT_EQ(places.size(), 80U);
}

}  // namespace
}  // namespace foveola
