#include "renderer/base/files/files.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <string>
#include <tuple>

#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include "renderer/base/error.h"
#include "renderer/base/files/digest.h"
#include "renderer/base/files/file_access.h"
#include "renderer/base/files/little_endian.h"
#include "tests/matchers.h"
#include "tests/scenes/environment.h"
#include "tests/temporary_folder.h"
#include "tests/unprivileged.h"

namespace fs = std::filesystem;

namespace foveola {
namespace {

class Files : public testing::Test {
 protected:
  std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  const test::TemporaryFolder temporary_;
  const fs::path folder_ = temporary_.path();
};

TEST_F(Files, ReadBackWhatWasWritten) {
  const std::string content("a\0b\r\n\xff", 6);
  write_file(folder_ / "x.bin", content);
  EXPECT_EQ(read_file(folder_ / "x.bin"), content);
  EXPECT_EQ(entries(), 1U);
}

// XDG Base Directory Specification: "All paths set in these environment variables must be absolute.
// If an implementation encounters a relative path [...] it should [...] ignore it."
TEST_F(Files, RelativeFoldersOfTheEnvironmentAreIgnored) {
  const scenes::EnvironmentVariable home("HOME", folder_);
  const scenes::EnvironmentVariable relative("XDG_DATA_HOME", "data");
  EXPECT_EQ(data_folder(), folder_ / ".local/share/foveola");
  const scenes::EnvironmentVariable absolute("XDG_CACHE_HOME", folder_ / "cache");
  EXPECT_EQ(cache_folder(), folder_ / "cache/foveola");
}

// In the system's temporary folder anybody may have put a folder under its name.
TEST_F(Files, WithoutAHomeNobodyElsesFolderIsTrusted) {
  const scenes::EnvironmentVariable home("HOME", "");
  const scenes::EnvironmentVariable cache("XDG_CACHE_HOME", "");
  const scenes::EnvironmentVariable temporary("TMPDIR", folder_);
  const fs::path own = folder_ / fmt::format("foveola-{}", ::geteuid());
  const auto expect_refused = [] {
    EXPECT_THAT([] { cache_folder(); },
                ThrowsMessage<Error>(HasSubstr("is not a folder of yours alone")));
  };
  EXPECT_EQ(cache_folder(), own);
  EXPECT_EQ(fs::status(own).permissions(), fs::perms::owner_all);
  fs::permissions(own, fs::perms::all);
  expect_refused();
  fs::permissions(own, fs::perms::owner_all);
  fs::rename(own, folder_ / "other");
  fs::create_directory_symlink(folder_ / "other", own);
  expect_refused();
  fs::remove(own);
  fs::rename(folder_ / "other", own);
  EXPECT_EQ(cache_folder(), own);
  if (::chown(own.c_str(), 12345, 12345) == 0) {
    expect_refused();
  }
}

constexpr const char* access_list = "system.posix_acl_access";

std::string access_list_of(const fs::path& file) {
  std::string list(200, '\0');
  list.resize(static_cast<std::size_t>(
      std::max<ssize_t>(0, ::getxattr(file.c_str(), access_list, list.data(), list.size()))));
  return list;
}

/// Mode, owner, group and access list.
std::tuple<unsigned, uid_t, gid_t, std::string> access_of(const fs::path& file) {
  struct stat status{};
  EXPECT_EQ(::stat(file.c_str(), &status), 0);
  return {status.st_mode, status.st_uid, status.st_gid, access_list_of(file)};
}

TEST_F(Files, AReplacedOneKeepsItsModeOwnerGroupAndAccessList) {
  const fs::path file = folder_ / "x";
  write_file(file, "old");
  if (::geteuid() == 0) {
    ASSERT_EQ(::chown(file.c_str(), 12345, 23456), 0);
  }
  ASSERT_EQ(::chmod(file.c_str(), 0640), 0);
  // By <linux/posix_acl_xattr.h>: version 2, then tag, permissions and id of the user, of user
  // 12345, of the group, of the mask and of others.
  constexpr std::uint32_t nobody = ~0U;
  struct Entry {
    std::uint16_t tag;
    std::uint16_t permissions;
    std::uint32_t id;
  };
  std::string list;
  append(list, std::uint32_t{2});
  for (const auto& [tag, permissions, id] :
       {Entry{0x01, 6, nobody}, Entry{0x02, 4, 12345}, Entry{0x04, 4, nobody},
        Entry{0x10, 4, nobody}, Entry{0x20, 0, nobody}}) {
    append(list, tag);
    append(list, permissions);
    append(list, id);
  }
  if (::setxattr(file.c_str(), access_list, list.data(), list.size(), 0) == 0) {
    ASSERT_EQ(access_list_of(file), list);
  }
  const auto before = access_of(file);
  write_file(file, "new", FileAccess::own);
  EXPECT_EQ(access_of(file), before);
  EXPECT_EQ(read_file(file), "new");
}

TEST_F(Files, WhatAReplacedOneCannotKeepIsSaid) {
  if (::geteuid() != 0) {
    GTEST_SKIP() << "only root has a file of another user's";
  }
  const fs::path file = folder_ / "x";
  write_file(file, "old");
  test::open_to_all(folder_);
  testing::internal::CaptureStderr();
  {
    const test::Unprivileged unprivileged;
    write_file(file, "new");
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            fmt::format("foveola: warning: {}: its owner could not be given to the new file "
                        "(Operation not permitted); use chown\n",
                        file.string()));
  EXPECT_EQ(read_file(file), "new");
}

TEST_F(Files, AnEmptyFileIsEmpty) {
  write_file(folder_ / "empty", "");
  EXPECT_EQ(read_file(folder_ / "empty"), "");
  std::string room = "what was there";
  read_file(folder_ / "empty", room);
  EXPECT_EQ(room, "");
}

TEST_F(Files, AreReadUpToALimit) {
  const std::string content = std::string(70'000, 'a') + "b";
  write_file(folder_ / "x", content);
  EXPECT_EQ(read_file(folder_ / "x", content.size(), "name another"), content);
  EXPECT_THAT([&] { read_file(folder_ / "x", content.size() - 1, "name another"); },
              ThrowsMessage<Error>(
                  HasSubstr("x: has over 70000 bytes, the maximum that is read; name another")));
  write_file(folder_ / "empty", "");
  EXPECT_EQ(read_file(folder_ / "empty", 0, ""), "");
}

TEST_F(Files, MissingFilesAndFoldersAreNamed) {
  EXPECT_THAT([&] { read_file(folder_ / "absent.glb"); },
              ThrowsMessage<Error>(HasSubstr("absent.glb: no such file")));
  EXPECT_THAT([&] { read_file(folder_); }, ThrowsMessage<Error>(HasSubstr("is a folder")));
  EXPECT_THAT([&] { write_file(folder_ / "no" / "x", ""); },
              ThrowsMessage<Error>(HasSubstr("does not exist")));
  EXPECT_THAT([&] { write_file(folder_, ""); }, ThrowsMessage<Error>(HasSubstr("is a folder")));
}

TEST_F(Files, PipesAndDevicesAreNotWaitedFor) {
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  for (const fs::path& path : {folder_ / "pipe", fs::path("/dev/zero")}) {
    const auto message =
        ThrowsMessage<Error>(path.string() + ": is not a regular file; copy its content into one");
    EXPECT_THAT([&] { read_file(path); }, message);
    EXPECT_THAT([&] { read_file(path, 1000, "name another"); }, message);
  }
}

TEST_F(Files, WhatIsOutOfReachIsNotMissing) {
  fs::create_directory(folder_ / "locked");
  write_file(folder_ / "locked" / "x", "");
  test::open_to_all(folder_);
  const test::Locked locked(folder_ / "locked");
  const test::Unprivileged unprivileged;
  EXPECT_THAT([&] { read_file(folder_ / "locked" / "x"); },
              ThrowsMessage<Error>(HasSubstr("x: cannot be reached: Permission denied; check")));
  EXPECT_THAT([&] { require_writable(folder_ / "locked" / "sub" / "x"); },
              ThrowsMessage<Error>(HasSubstr("sub cannot be reached; check")));
}

TEST_F(Files, AFileIsNoFolder) {
  write_file(folder_ / "x", "");
  EXPECT_THAT([&] { require_writable(folder_ / "x" / "y"); },
              ThrowsMessage<Error>(HasSubstr("x is a file, not a folder")));
}

TEST_F(Files, AFailedWriteLeavesTheOldFileAndNothingElse) {
  write_file(folder_ / "x.txt", "old");
  EXPECT_THROW(replace_file(folder_ / "x.txt",
                            [](const fs::path& temporary) {
                              std::ofstream(temporary) << "half";
                              throw std::runtime_error("disk full");
                            }),
               std::runtime_error);
  EXPECT_EQ(read_file(folder_ / "x.txt"), "old");
  EXPECT_EQ(entries(), 1U);
}

TEST_F(Files, TheTemporaryFileKeepsTheExtension) {
  replace_file(folder_ / "x.exr", [](const fs::path& temporary) {
    EXPECT_EQ(temporary.extension(), ".exr");
    std::ofstream(temporary) << "image";
  });
  EXPECT_EQ(read_file(folder_ / "x.exr"), "image");
}

TEST_F(Files, ALinkIsFollowedAndStaysOne) {
  fs::create_directories(folder_ / "elsewhere");
  fs::create_symlink("elsewhere/b.txt", folder_ / "a.txt");
  fs::create_symlink(folder_ / "a.txt", folder_ / "link.txt");
  for (const char* content : {"new", "newer"}) {  // it leads to no file at first
    require_writable(folder_ / "link.txt");
    write_file(folder_ / "link.txt", content);
    EXPECT_EQ(read_file(folder_ / "elsewhere/b.txt"), content);
    EXPECT_TRUE(fs::is_symlink(folder_ / "link.txt") && fs::is_symlink(folder_ / "a.txt"));
  }
  fs::create_symlink("no-such-folder/b.txt", folder_ / "broken.txt");
  EXPECT_THAT([&] { require_writable(folder_ / "broken.txt"); },
              ThrowsMessage<Error>(HasSubstr("no-such-folder does not exist")));
  fs::create_symlink("/dev/null", folder_ / "null.txt");
  EXPECT_THAT([&] { require_writable(folder_ / "null.txt"); },
              ThrowsMessage<Error>(HasSubstr("is not a regular file")));
}

/// Two machines can have processes of the same number, and one process several threads.
TEST_F(Files, TwoTemporaryFilesOfOneNameAreTwo) {
  const TemporaryFile one(folder_ / "x.exr");
  const TemporaryFile other(folder_ / "x.exr");
  EXPECT_NE(one.path(), other.path());
  EXPECT_EQ(one.path().parent_path(), folder_);
  std::ofstream(one.path()) << "one";
  std::ofstream(other.path()) << "other";
  one.replace_final();
  EXPECT_EQ(read_file(folder_ / "x.exr"), "one");
  other.replace_final();
  EXPECT_EQ(read_file(folder_ / "x.exr"), "other");
  EXPECT_EQ(entries(), 1U);
}

TEST(LowerCaseExtension, ChangesNothingButAsciiLetters) {
  EXPECT_EQ(lower_case_extension("a.b/Scene.GlB"), ".glb");
  EXPECT_EQ(lower_case_extension("Scene.\u00C4B"), ".\u00C4b");
  EXPECT_EQ(lower_case_extension("Scene"), "");
  EXPECT_EQ(lower_case_extension(".GLB"), "") << "the name of a hidden file";
}

// The examples of FIPS 180-4's validation suite.
TEST(Sha256, MatchesTheStandard) {
  EXPECT_EQ(sha256(std::string_view("abc")),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(std::string_view("")),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST_F(Files, DigestOfAFileIsThatOfItsContent) {
  const std::string content(200'000, 'x');
  write_file(folder_ / "x", content);
  EXPECT_EQ(sha256_of_file(folder_ / "x"), sha256(std::string_view(content)));
  EXPECT_THROW(sha256_of_file(folder_ / "absent"), Error);
}

}  // namespace
}  // namespace foveola
