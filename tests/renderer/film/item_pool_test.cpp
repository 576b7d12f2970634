#include "renderer/film/item_pool.h"

#include <array>
#include <set>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace foveola
