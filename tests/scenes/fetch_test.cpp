#include "scenes/fetch.h"

#include <algorithm>
#include <chrono>
#include <stop_token>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "renderer/base/error.h"
#include "renderer/base/files/digest.h"
#include "renderer/base/files/files.h"
#include "scenes/download.h"
#include "scenes/file_search.h"
#include "tests/renderer/gaze/tracker_server.h"
#include "tests/scenes/environment.h"
#include "tests/scenes/http_server.h"
#include "tests/temporary_folder.h"

namespace foveola::scenes {
namespace {

namespace fs = std::filesystem;
using test::cut;
using test::first_byte_wanted;
using test::HttpServer;
using test::ok;
using test::redirect;
using test::rest;
using test::status;
using ::testing::AllOf;
using ::testing::HasSubstr;

std::string some_document() {
  std::string bytes(300000, ' ');
  std::generate(bytes.begin(), bytes.end(), [n = 0]() mutable { return static_cast<char>(n++); });
  return bytes;
}

/// A user who has fetched nothing yet, and a scene of `document` at some address.
class FetchTest : public ::testing::Test {
 protected:
  FetchTest()
      : data_home_("XDG_DATA_HOME", (folder_ / "data").string()), no_proxy_("no_proxy", "*") {}

  Descriptor hall_at(const std::string& address) const {
    Descriptor hall;
    hall.name = "hall";
    hall.path = resource_folder() / "scenes" / "hall.toml";
    hall.file_name = "hall.glb";
    hall.origin = "the archive of halls";
    hall.sha256 = sha256(std::string_view(document_));
    hall.size_bytes = document_.size();
    hall.address = address;
    return hall;
  }

  /// What went wrong; empty if nothing.
  std::string fetch(const Descriptor& descriptor, const std::stop_token& stop = {}) {
    try {
      EXPECT_EQ(fetch_from_web(descriptor, [](double) {}, stop), target());
    } catch (const Error& error) {
      return error.what();
    }
    return {};
  }
  std::string fetch_from(const Descriptor& descriptor, const fs::path& path,
                         Accept accept = Accept::described_file) {
    try {
      EXPECT_EQ(fetch_from_disk(descriptor, path, accept), target());
    } catch (const Error& error) {
      return error.what();
    }
    return {};
  }

  fs::path target() const { return folder_ / "data" / "foveola" / "scenes" / "hall.glb"; }
  fs::path part() const { return target().string() + ".part"; }
  void expect_fetched() const {
    ASSERT_TRUE(fs::exists(target()));
    EXPECT_EQ(read_file(target()), document_);
    EXPECT_FALSE(fs::exists(part()));
  }

  const std::string document_ = some_document();
  const test::TemporaryFolder folder_;
  const EnvironmentVariable data_home_;
  const EnvironmentVariable no_proxy_;
};

TEST_F(FetchTest, TheFileIsThenFoundByItsName) {
  const HttpServer server([&](const std::string&) { return ok(document_); });
  EXPECT_EQ(fetch(hall_at(server.address("/hall.glb"))), "");
  expect_fetched();
  EXPECT_EQ(search_scene_path("hall.glb").file, target());
}

TEST_F(FetchTest, RedirectionsAreFollowed) {
  const HttpServer server([&](const std::string& request) {
    return request.starts_with("GET /old ") ? redirect("/new") : ok(document_);
  });
  EXPECT_EQ(fetch(hall_at(server.address("/old"))), "");
  expect_fetched();
}

TEST_F(FetchTest, RedirectionsInACircleEnd) {
  const HttpServer server([](const std::string&) { return redirect("/again"); });
  EXPECT_THAT(fetch(hall_at(server.address("/"))), HasSubstr("redirects"));
  EXPECT_LE(server.requests(), 11);
}

TEST_F(FetchTest, RedirectionsToFilesAreRefused) {
  const HttpServer server([](const std::string&) { return redirect("file:///etc/passwd"); });
  EXPECT_NE(fetch(hall_at(server.address("/"))), "");
  EXPECT_FALSE(fs::exists(target()));
}

TEST_F(FetchTest, AMissingDocumentIsSaid) {
  const HttpServer server([](const std::string&) { return status("404 Not Found"); });
  EXPECT_THAT(fetch(hall_at(server.address("/hall.glb"))), HasSubstr("404"));
  EXPECT_FALSE(fs::exists(target()));
}

TEST_F(FetchTest, ACutDownloadIsContinuedWhereItEnded) {
  const HttpServer server([&](const std::string& request) {
    const std::size_t from = first_byte_wanted(request);
    return from == 0 ? cut(document_, 100000) : rest(document_, from);
  });
  const Descriptor hall = hall_at(server.address("/hall.glb"));
  EXPECT_THAT(fetch(hall), AllOf(HasSubstr("100000 bytes are here"), HasSubstr("continue")));
  EXPECT_FALSE(fs::exists(target()));
  EXPECT_EQ(fs::file_size(part()), 100000U);
  EXPECT_EQ(fetch(hall), "");
  expect_fetched();
  EXPECT_EQ(server.requests(), 2);
}

// The second program has nothing to add to what the first has begun, and finds it whole.
TEST_F(FetchTest, TwoAtOnceDownloadTheFileOnce) {
  const HttpServer server([&](const std::string&) { return ok(document_); });
  const Descriptor hall = hall_at(server.address("/hall.glb"));
  std::vector<std::jthread> programs;
  for (int i = 0; i < 4; ++i) {
    programs.emplace_back([&] { EXPECT_EQ(fetch(hall), ""); });
  }
  programs.clear();
  expect_fetched();
  EXPECT_EQ(server.requests(), 1);
}

TEST_F(FetchTest, WhatAnotherProgramHasBegunIsWaitedFor) {
  fs::create_directories(part().parent_path());
  write_file(part(), document_.substr(0, 1000));
  const int other = ::open(part().c_str(), O_RDWR | O_CLOEXEC);
  ASSERT_EQ(::flock(other, LOCK_EX), 0);
  const HttpServer server([&](const std::string&) { return ok(document_); });
  std::stop_source stop;
  std::jthread stopping([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    stop.request_stop();
  });
  EXPECT_THAT(fetch(hall_at(server.address("/hall.glb")), stop.get_token()),
              HasSubstr("another program is downloading it"));
  EXPECT_EQ(server.requests(), 0);
  EXPECT_EQ(fs::file_size(part()), 1000U);
  ::close(other);
}

TEST_F(FetchTest, TheFileOfOnesOwnDescriptorLiesBesideIt) {
  const HttpServer server([&](const std::string&) { return ok(document_); });
  Descriptor own = hall_at(server.address("/hall.glb"));
  own.path = folder_ / "my-scenes" / "hall.toml";
  EXPECT_EQ(fetch_from_web(own, [](double) {}, {}), folder_ / "my-scenes" / "hall.glb");
  EXPECT_EQ(read_file(folder_ / "my-scenes" / "hall.glb"), document_);
}

TEST_F(FetchTest, AServerThatCannotContinueSendsAllAgain) {
  const HttpServer server([&](const std::string&) { return ok(document_); });
  fs::create_directories(part().parent_path());
  write_file(part(), document_.substr(0, 1000));
  EXPECT_EQ(fetch(hall_at(server.address("/hall.glb"))), "");
  expect_fetched();
}

TEST_F(FetchTest, ABeginningThatTheServerDoesNotKnowIsThrownAway) {
  for (const std::string& beginning : {document_ + "more", std::string(1000, 'x')}) {
    const HttpServer server([&](const std::string& request) {
      return first_byte_wanted(request) == 0 ? ok(document_) : status("416 Range Not Satisfiable");
    });
    fs::create_directories(part().parent_path());
    fs::remove(target());
    write_file(part(), beginning);
    EXPECT_EQ(fetch(hall_at(server.address("/hall.glb"))), "");
    expect_fetched();
    EXPECT_EQ(server.requests(), beginning.size() < document_.size() ? 2 : 1);
  }
}

TEST_F(FetchTest, AFileThatIsThereAndRightIsNotDownloadedAgain) {
  const HttpServer server([&](const std::string&) { return ok(document_); });
  const Descriptor hall = hall_at(server.address("/hall.glb"));
  EXPECT_EQ(fetch(hall), "");
  EXPECT_EQ(fetch(hall), "");
  EXPECT_EQ(server.requests(), 1);
  write_file(target(), "damaged");
  EXPECT_EQ(fetch(hall), "");
  EXPECT_EQ(server.requests(), 2);
  expect_fetched();
}

TEST_F(FetchTest, AnotherFileOfTheSameSizeIsRefusedAndForgotten) {
  std::string other = document_;
  other.back() ^= 1;
  const HttpServer server([&](const std::string&) { return ok(other); });
  EXPECT_THAT(fetch(hall_at(server.address("/hall.glb"))), HasSubstr("SHA-256"));
  EXPECT_FALSE(fs::exists(target()));
  EXPECT_FALSE(fs::exists(part()));
}

TEST_F(FetchTest, FilesOfAnotherSizeAreRefused) {
  std::string other = document_ + "more";
  const HttpServer server([&](const std::string&) { return ok(other); });
  EXPECT_THAT(fetch(hall_at(server.address("/hall.glb"))), HasSubstr("larger"));
  other = document_.substr(0, 10);
  EXPECT_THAT(fetch(hall_at(server.address("/hall.glb"))), HasSubstr("smaller"));
  EXPECT_FALSE(fs::exists(target()));
}

TEST_F(FetchTest, StoppingKeepsWhatCame) {
  std::stop_source stop;
  const HttpServer server([&](const std::string&) {
    stop.request_stop();
    return cut(document_, 1000);
  });
  EXPECT_THAT(fetch(hall_at(server.address("/hall.glb")), stop.get_token()), HasSubstr("continue"));
  EXPECT_FALSE(fs::exists(target()));
}

TEST_F(FetchTest, AServerThatIsNotThereIsSaid) {
  const test::TrackerServer nobody(test::TrackerServer::Begin::later);
  EXPECT_THAT(fetch(hall_at("http://127.0.0.1:" + std::to_string(nobody.port()) + "/hall.glb")),
              HasSubstr("check the network"));
}

TEST_F(FetchTest, WithoutAnAddressSaysWhereToGetIt) {
  EXPECT_THAT(fetch(hall_at("")), AllOf(HasSubstr("the archive of halls"), HasSubstr("--from")));
}

/// Linux's device that is always full.
TEST_F(FetchTest, AFullDiskIsSaid) {
  const HttpServer server([&](const std::string&) { return ok(document_); });
  fs::create_directories(part().parent_path());
  fs::create_symlink("/dev/full", part());
  EXPECT_THAT(fetch(hall_at(server.address("/hall.glb"))),
              AllOf(HasSubstr("No space left"), HasSubstr("free space")));
  EXPECT_FALSE(fs::exists(target()));
}

TEST_F(FetchTest, ComesFromAFileOrAFolderToo) {
  const Descriptor hall = hall_at("");
  EXPECT_EQ(fetch_from(hall, folder_.write("elsewhere/x.glb", document_)), "");
  expect_fetched();
  fs::remove(target());
  folder_.write("halls/glb/hall.glb", document_);
  EXPECT_EQ(fetch_from(hall, folder_ / "halls"), "");
  expect_fetched();
}

TEST_F(FetchTest, OtherFilesOfTheDiskAreRefused) {
  const Descriptor hall = hall_at("");
  EXPECT_THAT(fetch_from(hall, folder_.write("hall.glb", "another")),
              AllOf(HasSubstr("SHA-256"), HasSubstr("--unverified")));
  EXPECT_THAT(fetch_from(hall, folder_ / "missing"), HasSubstr("no such file"));
  fs::create_directories(folder_ / "empty");
  EXPECT_THAT(fetch_from(hall, folder_ / "empty"), HasSubstr("has no hall.glb"));
  EXPECT_FALSE(fs::exists(target()));
}

/// A glTF binary of 20 bytes, by its header; `more` follows.
std::string small_glb(const std::string& more) {
  return std::string("glTF\2\0\0\0\24\0\0\0", 12) + "JSON{}  " + more;
}

TEST_F(FetchTest, OnesOwnConversionIsTakenWhenAskedFor) {
  const fs::path own = folder_.write("own.glb", small_glb(""));
  EXPECT_THAT(fetch_from(hall_at(""), own), HasSubstr("SHA-256"));
  EXPECT_EQ(fetch_from(hall_at(""), own, Accept::any_glb), "");
  EXPECT_EQ(read_file(target()), small_glb(""));
  EXPECT_FALSE(is_described_file(hall_at(""), target()));
}

TEST_F(FetchTest, WhatIsNoWholeGlbIsNoConversion) {
  EXPECT_THAT(fetch_from(hall_at(""), folder_.write("a.glb", "another"), Accept::any_glb),
              HasSubstr("is not a glTF binary"));
  EXPECT_THAT(fetch_from(hall_at(""), folder_.write("b.glb", small_glb("more")), Accept::any_glb),
              HasSubstr("is not a glTF binary"));
  EXPECT_FALSE(fs::exists(target()));
}

TEST_F(FetchTest, PipesAreRefused) {
  const fs::path pipe = folder_ / "pipe.glb";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT(fetch_from(hall_at(""), pipe), HasSubstr("is not a regular file"));
}

}  // namespace
}  // namespace foveola::scenes
