#include "renderer/base/files/cache.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <vector>

#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "renderer/base/error.h"
#include "renderer/base/files/digest.h"
#include "renderer/base/files/files.h"
#include "tests/matchers.h"
#include "tests/temporary_folder.h"

namespace fs = std::filesystem;

namespace foveola {
namespace {

std::string with_flipped_bit(std::string content, std::size_t byte) {
  content[byte] = static_cast<char>(content[byte] ^ 0x10);
  return content;
}

TEST(Cache, FindsWhatWasKeptAndNothingElse) {
  const test::TemporaryFolder folder;
  const std::string content("a\0b\r\n\xff", 6);
  EXPECT_EQ(read_from_cache(folder / "x.bin"), std::nullopt);
  EXPECT_FALSE(is_cached(folder / "x.bin"));
  store_content(folder / "x.bin", content);
  EXPECT_TRUE(is_cached(folder / "x.bin"));
  EXPECT_THAT(read_from_cache(folder / "x.bin"), Optional(content));
  EXPECT_EQ(read_file(folder / "x.bin"), content) << "others can read it too";
  store_content(folder / "empty", "");
  EXPECT_THAT(read_from_cache(folder / "empty"), Optional(std::string()));
  EXPECT_FALSE(is_cached(folder.path()));
}

TEST(Cache, DigestsAreChecked) {
  const test::TemporaryFolder folder;
  store_content(folder / "x.bin", "abc");  // the example of FIPS 180-4
  EXPECT_EQ(read_file(folder / "x.bin.sha256"),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad  x.bin\n");
  EXPECT_THAT(folder.entries(), ElementsAre("x.bin", "x.bin.sha256"));
}

TEST(Cache, DamagedFilesAreMissingUntilTheyAreKeptAgain) {
  const test::TemporaryFolder folder;
  const fs::path file = folder / "x.bin";
  const fs::path digest = folder / "x.bin.sha256";
  const std::string content(1000, 'x');
  const auto expect_it_is_kept_again = [&](const std::string& damage) {
    EXPECT_FALSE(is_cached(file)) << damage;
    EXPECT_EQ(read_from_cache(file), std::nullopt) << damage;
    store_content(file, content);
    EXPECT_TRUE(is_cached(file)) << damage;
    EXPECT_THAT(read_from_cache(file), Optional(content)) << damage;
  };
  store_content(file, content);
  for (const std::size_t byte : {std::size_t{0}, std::size_t{512}, content.size() - 1}) {
    write_file(file, with_flipped_bit(content, byte));
    expect_it_is_kept_again("a bit flipped");
  }
  write_file(file, content.substr(0, content.size() - 1));
  expect_it_is_kept_again("cut by a byte");
  write_file(file, "");
  expect_it_is_kept_again("empty, as after a loss of power");
  write_file(digest, with_flipped_bit(read_file(digest), 7));
  expect_it_is_kept_again("a bit of the digest flipped");
  write_file(digest, read_file(digest).substr(0, 64));
  expect_it_is_kept_again("the digest cut");
  fs::remove(digest);
  expect_it_is_kept_again("killed before the digest was there, or kept by an older program");
  fs::remove(file);
  expect_it_is_kept_again("killed between the digest and the file");
  write_file(digest, fmt::format("{}  x.bin\n", sha256(std::string_view("another"))));
  expect_it_is_kept_again("another writer's digest, whose file did not come");
}

/// Others may have it open, and on a network folder a file that is replaced cannot be read on.
TEST(Cache, WhatIsThereAlreadyStays) {
  const test::TemporaryFolder folder;
  const auto inode = [&] {
    struct stat status{};
    ::stat((folder / "x").c_str(), &status);
    return status.st_ino;
  };
  store_content(folder / "x", "the same");
  const auto first = inode();
  store_content(folder / "x", "the same");
  EXPECT_EQ(inode(), first);
  store_content(folder / "x", "another");
  EXPECT_NE(inode(), first);
  EXPECT_THAT(read_from_cache(folder / "x"), Optional(std::string("another")));
  EXPECT_THAT(folder.entries(), ElementsAre("x", "x.sha256"));
}

TEST(Cache, AFolderThatCannotBeMadeIsNamed) {
  const test::TemporaryFolder folder;
  make_cache_folder(folder / "a" / "b");
  EXPECT_TRUE(fs::is_directory(folder / "a" / "b"));
  folder.write("taken", "a file");
  EXPECT_THAT([&] { make_cache_folder(folder / "taken" / "b"); },
              ThrowsMessage<Error>(HasSubstr("set XDG_CACHE_HOME")));
}

/// A file that shows whether it is whole: what it says of itself, as often as it says.
std::string self_similar(std::uint32_t key, std::uint32_t writer, std::uint32_t round) {
  const std::string line = fmt::format("key {} writer {} round {}\n", key, writer, round);
  std::string content = line;
  for (std::uint32_t i = 0; i < 200 * (1 + round % 5); ++i) {
    content += line;
  }
  return content;
}

bool is_whole(const std::string& content, std::uint32_t key) {
  std::uint32_t of_key = 0;
  std::uint32_t writer = 0;
  std::uint32_t round = 0;
  return std::sscanf(content.c_str(), "key %u writer %u round %u", &of_key, &writer, &round) == 3 &&
         of_key == key && content == self_similar(key, writer, round);
}

constexpr std::uint32_t keys = 3;

fs::path file_of(const fs::path& folder, std::uint32_t key) {
  return folder / fmt::format("{}.bin", key);
}

/// Reads and writes each key's file in each round. Returns false for one that is kept, but not
/// whole.
bool take_turns(const fs::path& folder, std::uint32_t writer, std::uint32_t rounds) {
  for (std::uint32_t round = 0; round < rounds; ++round) {
    for (std::uint32_t key = 0; key < keys; ++key) {
      const std::optional<std::string> found = read_from_cache(file_of(folder, key));
      if (found && !is_whole(*found, key)) {
        return false;
      }
      store_content(file_of(folder, key), self_similar(key, writer, round));
    }
  }
  return true;
}

/// Worse than a cache ever is: the writers of one file do not even agree on what is in it.
TEST(Cache, ManyProcessesFillItWhileOneIsKilled) {
  const test::TemporaryFolder folder;
  constexpr std::uint32_t rounds = 30;
  constexpr std::uint32_t without_end = 1'000'000;
  constexpr std::array<std::uint32_t, 4> rounds_of = {rounds, rounds, rounds, without_end};
  std::vector<pid_t> writers;
  for (std::uint32_t writer = 0; writer < rounds_of.size(); ++writer) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      ::_exit(take_turns(folder.path(), writer, rounds_of[writer]) ? 0 : 1);
    }
    writers.push_back(child);
  }
  EXPECT_TRUE(take_turns(folder.path(), rounds_of.size(), rounds));
  ::kill(writers.back(), SIGKILL);
  for (std::size_t i = 0; i < writers.size(); ++i) {
    int status = 0;
    ASSERT_EQ(::waitpid(writers[i], &status, 0), writers[i]);
    if (i + 1 < writers.size()) {
      EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "writer " << i;
    } else {
      EXPECT_TRUE(WIFSIGNALED(status)) << "it was to be killed";
    }
  }
  for (std::uint32_t key = 0; key < keys; ++key) {
    store_content(file_of(folder.path(), key), self_similar(key, 9, 1));
    EXPECT_THAT(read_from_cache(file_of(folder.path(), key)), Optional(self_similar(key, 9, 1)));
  }
  for (const std::string& name : folder.entries()) {
    EXPECT_TRUE(name.starts_with('.') || name.ends_with(".bin") || name.ends_with(".bin.sha256"))
        << name;
  }
}

/// A writer that dies at any moment leaves nothing that is taken for a file.
TEST(Cache, AWriterThatIsKilledWhileItWritesLeavesNone) {
  const test::TemporaryFolder folder;
  const fs::path file = folder / "x.bin";
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    store_file(file, [](const fs::path& temporary) {
      write_file(temporary, "half of it");
      ::raise(SIGKILL);
    });
    ::_exit(0);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_THAT(folder.entries(), ElementsAre(MatchesRegex("\\.x\\..*\\.partial\\.bin")));
  EXPECT_FALSE(is_cached(file));
  store_content(file, "all of it");
  EXPECT_THAT(read_from_cache(file), Optional(std::string("all of it")));
}

}  // namespace
}  // namespace foveola
