#include "renderer/base/toml/toml_keys.h"

#include <array>

#include "renderer/base/toml/toml_file.h"
#include "renderer/base/toml/toml_reader.h"
#include "tests/matchers.h"

namespace foveola {
namespace {

/// Reads such a file; whether a size is required depends on the word.
void read_file_with(const char* content, int default_count, TomlKeys& keys) {
  constexpr std::array words{Word<int>{"one", 1}, Word<int>{"two", 2}};
  const toml::table table = parse_toml("a.toml", content, "");
  TomlReader reader("a.toml", table, "", &keys);
  std::string title = reader.require_text("title");
  int count = default_count;
  reader.read(reader.present_name("count", "number"), count, 0, 9);
  TomlReader inner = reader.table("inner");
  int word = 2;
  inner.read("word", word, words);
  if (word == 1) {
    inner.require("size");
  }
  double size = 0.5;
  inner.read("size", size, 0.0, 1.0);
  inner.reject_unknown_keys();
  reader.reject_unknown_keys();
}

TEST(TomlKeys, SayWhatWasAskedFor) {
  TomlKeys asked;
  read_file_with("title = \"a\"\n", 3, asked);
  const std::vector<TomlKey> keys = asked.keys();
  ASSERT_EQ(keys.size(), 5U);
  EXPECT_EQ(keys[0].key, "title");
  EXPECT_TRUE(keys[0].is_required);
  EXPECT_EQ(keys[1].key, "count");
  EXPECT_THAT(keys[1].types, ElementsAre("whole number"));
  EXPECT_EQ(keys[1].minimum, 0.0);
  EXPECT_EQ(keys[1].maximum, 9.0);
  EXPECT_EQ(keys[1].default_text, "3");
  EXPECT_EQ(keys[1].former, "number");
  EXPECT_FALSE(keys[1].is_required);
  EXPECT_THAT(keys[2].types, ElementsAre("table"));
  EXPECT_EQ(keys[3].table, "inner");
  EXPECT_THAT(keys[3].words, ElementsAre("one", "two"));
  EXPECT_EQ(keys[3].default_text, "two");
  EXPECT_EQ(keys[4].default_text, "0.5");
}

TEST(TomlKeys, WhatDependsOnOtherKeysIsTold) {
  TomlKeys asked;
  read_file_with("title = \"a\"\n", 3, asked);
  read_file_with("title = \"a\"\ninner = { word = \"one\", size = 1 }\n", 4, asked);
  const std::vector<TomlKey> keys = asked.keys();
  EXPECT_TRUE(keys.at(1).default_varies);
  EXPECT_EQ(keys.at(1).default_text, std::nullopt);
  EXPECT_FALSE(keys.at(4).is_required);
  EXPECT_TRUE(keys.at(4).is_sometimes_required);
  EXPECT_EQ(keys.at(4).default_text, "0.5") << "where it is not required";
}

}  // namespace
}  // namespace foveola
