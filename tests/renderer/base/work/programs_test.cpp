#include "renderer/base/work/programs.h"

#include <csignal>
#include <system_error>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace foveola {
namespace {

ProgramEnd end_of_script(const std::string& script, const std::string& input = "",
                         OnInterrupt on_interrupt = OnInterrupt::as_here) {
  return run_to_end({.words = {"sh", "-c", script}, .input = input, .on_interrupt = on_interrupt});
}

/// While it lives, this thread leaves requests to stop to another, as the laboratory's threads do.
class RequestsBlocked {
 public:
  RequestsBlocked() {
    sigset_t requests;
    ::sigemptyset(&requests);
    ::sigaddset(&requests, SIGTERM);
    ::pthread_sigmask(SIG_BLOCK, &requests, &before_);
  }
  ~RequestsBlocked() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  RequestsBlocked(const RequestsBlocked&) = delete;
  RequestsBlocked& operator=(const RequestsBlocked&) = delete;

 private:
  sigset_t before_{};
};

TEST(Programs, OwnOneIsTheTest) {
  EXPECT_EQ(own_program().filename(), "base_test");
  EXPECT_TRUE(own_program().is_absolute());
}

// tests/examples/check sees programs that link an installed Foveola find it.
TEST(Programs, WhatLiesWhereItWasBuiltWasNotInstalled) {
  EXPECT_EQ(installation_prefix(), std::nullopt);
}

TEST(Programs, OutputAndErrorsAreKeptApart) {
  const ProgramEnd end = end_of_script("echo said; echo complained >&2");
  EXPECT_EQ(end.status, 0);
  EXPECT_EQ(end.output, "said\n");
  EXPECT_EQ(end.errors, "complained\n");
}

/// More than a pipe holds, in both directions.
TEST(Programs, InputComesWholeAndThenEnds) {
  const std::string megabytes(3'000'000, 'x');
  EXPECT_EQ(end_of_script("cat", megabytes).output, megabytes);
  EXPECT_EQ(end_of_script("cat").output, "");
}

TEST(Programs, ArgumentsReachThemAsTheyAre) {
  EXPECT_EQ(run_to_end({.words = {"printf", "%s|", "a b", "", "$HOME;'\""}}).output,
            "a b||$HOME;'\"|");
}

TEST(Programs, FailuresAreNamed) {
  EXPECT_EQ(failure_named(end_of_script("exit 3").status), "exit status 3");
  EXPECT_EQ(failure_named(end_of_script("kill -KILL $$").status), "signal 9 (Killed)");
}

TEST(Programs, WhatCannotBeStartedIsAnError) {
  try {
    run_to_end({.words = {"/no/such/program"}});
    FAIL() << "no error";
  } catch (const std::system_error& error) {
    EXPECT_EQ(error.code(), std::errc::no_such_file_or_directory);
  }
}

/// With SIGTERM in place of SIGINT, which shells have their background jobs ignore.
TEST(Programs, AnInterruptEndsThoseThatItIsMeantTo) {
  const RequestsBlocked blocked;
  const std::string interrupted = "kill -TERM $$; echo went on";
  EXPECT_EQ(end_of_script(interrupted).output, "went on\n");
  const ProgramEnd end = end_of_script(interrupted, "", OnInterrupt::ends);
  EXPECT_EQ(failure_named(end.status), "signal 15 (Terminated)");
  EXPECT_EQ(end.output, "");
}

}  // namespace
}  // namespace foveola
