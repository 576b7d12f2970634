#include "renderer/film/item_pool.h"

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

struct Item {
  std::array<std::uint64_t, 12> words;
};

bool is_zeros(const Item& item) { return item.words == std::array<std::uint64_t, 12>{}; }

/// Takes so many items, checks that they are zeros, and fills them.
std::vector<Item*> take_and_fill(ItemPool<Item>& pool, int count) {
  ItemPool<Item>::Taker taker(pool);
  std::vector<Item*> items;
  for (int i = 0; i < count; ++i) {
    items.push_back(taker.take());
    EXPECT_TRUE(is_zeros(*items.back()));
    items.back()->words.fill(~std::uint64_t{0});
  }
  return items;
}

TEST(ItemPool, ItemsAreZerosAlsoTheSecondTime) {
  HugePages pages;
  ItemPool<Item> pool(pages);
  constexpr int more_than_a_chunk = 30'000;
  std::vector<Item*> first = take_and_fill(pool, 100);
  pool.clear();
  const std::vector<Item*> again = take_and_fill(pool, more_than_a_chunk);
  EXPECT_EQ(std::vector<Item*>(again.begin(), again.begin() + 100), first) << "the same memory";
  EXPECT_EQ(std::set<Item*>(again.begin(), again.end()).size(), again.size());
}

TEST(ItemPool, ThreadsGetItemsOfTheirOwn) {
  HugePages pages;
  ItemPool<Item> pool(pages);
  std::vector<std::vector<Item*>> taken(4);
  {
    std::vector<std::jthread> threads;
    for (std::vector<Item*>& items : taken) {
      threads.emplace_back([&] {
        for (int round = 0; round < 50; ++round) {
          const std::vector<Item*> some = take_and_fill(pool, 100 + round);
          items.insert(items.end(), some.begin(), some.end());
        }
      });
    }
  }
  std::set<Item*> all;
  std::size_t count = 0;
  for (const std::vector<Item*>& items : taken) {
    all.insert(items.begin(), items.end());
    count += items.size();
  }
  EXPECT_EQ(all.size(), count);
}

// However often somebody takes a few, all lie side by side: 20 000 of 96 bytes in one huge page.
TEST(ItemPool, WhatATakerLeavesIsTakenNext) {
  HugePages pages;
  ItemPool<Item> pool(pages);
  std::set<std::uintptr_t> pages_of_items;
  for (int round = 0; round < 20'000; ++round) {
    for (const Item* item : take_and_fill(pool, 1)) {
      pages_of_items.insert(reinterpret_cast<std::uintptr_t>(item) / huge_page);
    }
  }
  EXPECT_EQ(pages_of_items.size(), 1U);
}

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
  test::wait_until("pages that are ready", [&] { return pages.ready() == HugePages::max_ready; });
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
  for (HugePage& page : take(pages, HugePages::max_ready + 1)) {
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
  for (const HugePage& page : take(pages, HugePages::max_ready)) {
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
    EXPECT_EQ(pages.ready(), HugePages::max_ready);
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
