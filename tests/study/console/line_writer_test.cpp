#include "study/console/line_writer.h"

#include <array>
#include <chrono>
#include <string>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace foveola::study {
namespace {

class LineWriterTest : public ::testing::Test {
 protected:
  LineWriterTest() { EXPECT_EQ(::pipe2(ends_.data(), O_CLOEXEC), 0); }
  ~LineWriterTest() override {
    close_reader();
    ::close(ends_[1]);
  }
  void close_reader() {
    if (ends_[0] >= 0) {
      ::close(std::exchange(ends_[0], -1));
    }
  }
  int output() const { return ends_[1]; }
  /// Up to so many characters, as soon as there are any.
  std::string read(std::size_t most) const {
    std::string text(most, '\0');
    text.resize(static_cast<std::size_t>(::read(ends_[0], text.data(), most)));
    return text;
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

const std::string much(1 << 20, 'x');  // more than a pipe holds

TEST_F(LineWriterTest, WritesLinesInOrderAndEscaped) {
  {
    LineWriter writer(output());
    writer.write("first\nsec\x1bond");
    writer.write("");
    writer.write("{\"third\": \"\u202e\"}");
  }
  EXPECT_EQ(read(100), "first\nsec\\u001bond\n{\"third\": \"\\u202e\"}\n");
}

TEST_F(LineWriterTest, WritesAllToASlowReaderBeforeItsEnd) {
  std::size_t taken = 0;
  std::thread reader([&] {
    for (std::size_t count = 1; count > 0 && taken <= much.size();) {
      count = read(1 << 16).size();
      taken += count;
    }
  });
  {
    LineWriter(output()).write(much);
  }
  reader.join();
  EXPECT_EQ(taken, much.size() + 1);
}

TEST_F(LineWriterTest, WritesWhatComesRightBeforeItsEnd) {
  {
    LineWriter writer(output());
    std::this_thread::sleep_for(LineWriter::patience + std::chrono::milliseconds(200));
    writer.write("last");
  }
  ASSERT_EQ(::write(output(), "!", 1), 1);
  EXPECT_EQ(read(100), "last\n!");
}

TEST_F(LineWriterTest, WaitsForNobodyWhoTakesNothing) {
  LineWriter writer(output());
  writer.write(much);
  writer.write(much);
}

TEST_F(LineWriterTest, AClosedTerminalIsNoFault) {
  close_reader();
  LineWriter writer(output());
  writer.write(much);
}

}  // namespace
}  // namespace foveola::study
