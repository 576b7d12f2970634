#include "study/console/line_reader.h"

#include <array>

#include <fcntl.h>
#include <unistd.h>

#include "tests/matchers.h"
#include "tests/waiting.h"

namespace foveola::study {
namespace {

/// All lines until there are `count`; throws std::runtime_error if there never are.
std::vector<std::string> wait_for_lines(LineReader& reader, std::size_t count) {
  std::vector<std::string> lines;
  foveola::test::wait_until("lines", [&] {
    for (std::string& line : reader.take_lines()) {
      lines.push_back(std::move(line));
    }
    return lines.size() >= count;
  });
  return lines;
}

TEST(LineReader, ReadsWholeLines) {
  std::array<int, 2> pipe{};
  ASSERT_EQ(::pipe(pipe.data()), 0);
  {
    LineReader reader(pipe[0]);
    const std::string typed = "state\nnote a";
    ASSERT_EQ(::write(pipe[1], typed.data(), typed.size()), static_cast<ssize_t>(typed.size()));
    EXPECT_THAT(wait_for_lines(reader, 1), ElementsAre("state"));
    ASSERT_EQ(::write(pipe[1], "bc\n", 3), 3);
    EXPECT_THAT(wait_for_lines(reader, 1), ElementsAre("note abc"));
    ::close(pipe[1]);
  }
  ::close(pipe[0]);
}

TEST(LineReader, DoesWithoutAnInput) {
  const int nothing = ::open("/dev/null", O_RDONLY);
  {
    LineReader reader(nothing);
    EXPECT_TRUE(reader.take_lines().empty());
  }
  ::close(nothing);
  LineReader closed(nothing);
  EXPECT_TRUE(closed.take_lines().empty());
}

}  // namespace
}  // namespace foveola::study
