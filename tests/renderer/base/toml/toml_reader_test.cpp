#include "renderer/base/toml/toml_reader.h"

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "renderer/base/toml/toml_file.h"
#include "tests/error_of.h"
#include "tests/matchers.h"
#include "tests/temporary_folder.h"

namespace foveola {
namespace {

using Read = std::function<void(TomlReader&)>;

/// What reading a file of this content complains of; empty if of nothing.
std::string complaint(const std::string& content, const Read& read) {
  return test::error_of([&] {
    const toml::table table = parse_toml("a.toml", content, "look at an example");
    TomlReader reader("a.toml", table, "");
    read(reader);
    reader.reject_unknown_keys();
  });
}

/// content, and a part of what is complained of
using Refused = std::pair<std::string, std::string>;

void expect_refused(const Read& read, const std::vector<Refused>& refused) {
  for (const auto& [content, what] : refused) {
    EXPECT_THAT(complaint(content, read), HasSubstr(what)) << content.substr(0, 100);
  }
}

void read_nothing(TomlReader& /*reader*/) {}

TEST(TomlReader, ReadsWhatIsThereAndLeavesTheRestAlone) {
  bool flag = true;
  int count = 3;
  Vec2 size(0.0F);
  Vec3 place(1.0F, 2.0F, 3.0F);
  const auto read = [&](TomlReader& reader) {
    reader.read("flag", flag);
    reader.read("count", count, 0, 9);
    reader.read("size", size, 0.0, 9.0);
    reader.read("place", place, -9.0, 9.0);
  };
  EXPECT_EQ(complaint("", read), "");
  EXPECT_TRUE(flag);
  EXPECT_EQ(place, Vec3(1.0F, 2.0F, 3.0F));
  EXPECT_EQ(complaint("flag = false\nsize = [1, 2.5]\nplace = [-1, 0.5, 9]\n", read), "");
  EXPECT_FALSE(flag);
  EXPECT_EQ(count, 3);
  EXPECT_EQ(size, Vec2(1.0F, 2.5F));
  EXPECT_EQ(place, Vec3(-1.0F, 0.5F, 9.0F));
}

TEST(TomlReader, SaysWhereAVectorIsWrong) {
  Vec3 place(0.0F);
  expect_refused([&](TomlReader& reader) { reader.read("place", place, 0.0, 1.0); },
                 {{"\nplace = [0, 1]\n", "a.toml:2:9: place must be a list of 3 numbers"},
                  {"place = [0, 1, 1.5]\n", "a.toml:1:16: place is out of range"},
                  {"place = [0, nan, 1]\n", "a.toml:1:13"},
                  {"place = [0, true, 1]\n", "a.toml:1:13"},
                  {"place = 1\n", "a.toml:1:9"}});
}

TEST(TomlReader, TextsMayBeAbsentAndComeWithTheirPlaces) {
  std::vector<TomlReader::Text> texts;
  const auto read = [&](TomlReader& reader) { texts = reader.texts("names"); };
  EXPECT_EQ(complaint("", read), "");
  EXPECT_TRUE(texts.empty());
  EXPECT_EQ(complaint("names = [\"a\", \"b\"]\n", read), "");
  ASSERT_EQ(texts.size(), 2U);
  EXPECT_EQ(texts[1].value, "b");
  EXPECT_EQ(texts[1].source.begin.column, 15U);
  EXPECT_THAT(complaint("names = []\n", read), HasSubstr("a.toml:1:9"));
  EXPECT_THAT(complaint("names = [\"a\", \"a\"]\n", read), HasSubstr("a.toml:1:15"));
}

TEST(TomlReader, AWordStandsForItsValue) {
  constexpr std::array words{Word<int>{"one", 1}, Word<int>{"two", 2}};
  int number = 0;
  const auto read = [&](TomlReader& reader) { reader.read("count", number, words); };
  EXPECT_EQ(complaint("", read), "");
  EXPECT_EQ(number, 0);
  EXPECT_EQ(complaint("count = \"two\"\n", read), "");
  EXPECT_EQ(number, 2);
  EXPECT_THAT(complaint("count = \"three\"\n", read),
              AllOf(HasSubstr("a.toml:1:9"), HasSubstr("three"), HasSubstr("one, two")));
  EXPECT_THAT(complaint("count = 2\n", read), HasSubstr("a.toml:1:9"));
}

TEST(TomlNames, AreThoseOfTheTomlFilesInOrder) {
  const test::TemporaryFolder folder;
  folder.write("b.toml", "");
  folder.write("a.toml", "");
  folder.write("c.txt", "");
  EXPECT_THAT(toml_names_in(folder.path()), ElementsAre("a", "b"));
  EXPECT_THROW(toml_names_in(folder / "none"), Error);
}

TEST(TomlReader, KeysOfTablesAreNamedWithTheirTable) {
  bool flag = false;
  const auto read = [&](TomlReader& reader) {
    TomlReader inner = reader.table("inner");
    inner.read("flag", flag);
    inner.require("size");
    inner.reject_unknown_keys();
  };
  EXPECT_THAT(complaint("[inner]\nflag = 1\nsize = 1\n", read),
              AllOf(HasSubstr("a.toml:2:8"), HasSubstr("inner.flag must be true or false")));
  EXPECT_THAT(complaint("[inner]\nflag = true\n", read), HasSubstr("inner.size is missing"));
  EXPECT_THAT(complaint("[inner]\nsize = 1\n", read), HasSubstr("'inner.size'"))
      << "required, but nothing read it";
}

/// "a.a.a" of so many parts.
std::string key_of(std::size_t parts) {
  std::string key = "a";
  for (std::size_t i = 1; i < parts; ++i) {
    key += ".a";
  }
  return key;
}

TEST(TomlReader, DeepKeysAreRefusedBeforeTheyAreRead) {
  for (const std::size_t parts : {17U, 50'000U}) {
    expect_refused(read_nothing,
                   {{"b = 1\n" + key_of(parts) + " = 1\n", "a.toml:2:32: a key of over 16 parts"},
                    {"[" + key_of(parts) + "]\n", "a.toml:1:33"},
                    {"b = {" + key_of(parts) + " = 1}\n", "a.toml:1:37"},
                    {"\"b\" . 'b'." + key_of(parts) + " = 1\n", "a key of over 16 parts"}});
  }
  expect_refused(read_nothing, {{key_of(16) + " = 1\n", "unknown key"}});
}

TEST(TomlReader, DeepValuesAreRefusedBeforeTheyAreRead) {
  for (const std::size_t depth : {17U, 50'000U}) {
    std::string begin;
    for (std::size_t i = 0; i < depth; ++i) {
      begin += "{" + key_of(16) + " = ";
    }
    // toml++ alone goes 16 times as deep as it counts.
    expect_refused(
        read_nothing,
        {{"b = 1\na = " + std::string(depth, '[') + std::string(depth, ']') + "\n",
          "a.toml:2:21: lists or tables nested over 16 deep; look at"},
         {"a = " + begin + "1" + std::string(depth, '}') + "\n", "nested over 16 deep"}});
  }
  std::string side_by_side = "[[a]]\n";
  for (int i = 0; i < 100; ++i) {
    side_by_side += "b" + std::to_string(i) + " = [{}, [1]] # [[[[\n";
  }
  expect_refused(read_nothing, {{"a = [[[[[[[[[[[[[[[[]]]]]]]]]]]]]]]]\n", "unknown key"},
                                {side_by_side, "unknown key"}});
}

TEST(TomlReader, DotsThatAreOfNoKeyAreNotCounted) {
  const std::string dots(100, '.');
  const auto read = [](TomlReader& reader) {
    std::string text;
    Vec3 place(0.0F);
    for (const char* key : {"a", "b", "c", "d"}) {
      reader.read(key, text);
    }
    reader.read("place", place, 0.0, 9.0);
  };
  EXPECT_EQ(complaint("# " + dots + "\na = \"\\\"" + dots + "\"\nb = '" + dots +
                          "\\'\nc = \"\"\"\n" + dots + "\"" + dots + "\n\"\"\"\nd = '''" + dots +
                          "'''\nplace = [" + "1.5, 2.5, 3.5] # " + dots + "\n",
                      read),
            "");
}

TEST(TomlReader, EndlessFilesAndListsAreRefused) {
  EXPECT_THAT(complaint("# " + std::string(4'000'000, 'a'), read_nothing),
              HasSubstr("has over 4000000 bytes"));
  std::string names = "\"n0\"";
  std::string tables;
  for (int i = 1; i < 1000; ++i) {
    names += ", \"n" + std::to_string(i) + "\"";
    tables += "[[table]]\n";
  }
  const auto read_texts = [](TomlReader& reader) { reader.texts("names"); };
  const auto read_tables = [](TomlReader& reader) { reader.tables("table"); };
  EXPECT_EQ(complaint("names = [" + names + "]\n", read_texts), "");
  EXPECT_THAT(complaint("names = [" + names + ", \"last\"]\n", read_texts),
              AllOf(HasSubstr("a.toml:1:9"), HasSubstr("names has 1001 entries")));
  EXPECT_EQ(complaint(tables, read_tables), "");
  EXPECT_THAT(complaint(tables + tables, read_tables), HasSubstr("table has 1998 entries"));
}

TEST(TomlFile, OfEndlessContentIsRefusedBeforeAllOfItIsRead) {
  const test::TemporaryFolder folder;
  folder.write("a.toml", "a = 1\n");
  EXPECT_EQ(read_toml_file(folder / "a.toml"), "a = 1\n");
  std::filesystem::resize_file(folder.write("large.toml", ""), std::uintmax_t{1} << 40);
  EXPECT_THAT(
      [&] { read_toml_file(folder / "large.toml"); },
      ThrowsMessage<Error>(HasSubstr(
          "large.toml: has over 4000000 bytes, the maximum that is read; name a TOML file")));
  EXPECT_THAT([&] { read_toml_file(folder.path()); },
              ThrowsMessage<Error>(HasSubstr("is a folder")));
}

TEST(TomlReader, SaysWhereTheFileIsNoToml) {
  EXPECT_THAT(complaint("a = 1\nb = \n", read_nothing),
              AllOf(HasSubstr("a.toml:2:"), HasSubstr("look at an example")));
}

}  // namespace
}  // namespace foveola
