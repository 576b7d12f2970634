#include "study/console/line_console.h"

#include <array>

#include <nlohmann/json.hpp>
#include <unistd.h>

#include "tests/matchers.h"

namespace foveola::study {
namespace {

using namespace std::chrono_literals;

constexpr int no_input = -1;

/// What is written is read once all was.
class ConsoleOutput : public ::testing::Test {
 protected:
  ConsoleOutput() { EXPECT_EQ(::pipe(ends_.data()), 0); }
  ~ConsoleOutput() override { ::close(ends_[0]); }

  template <typename Kind, typename Use>
  std::vector<std::string> lines_of(const Use& use) {
    {
      LineWriter writer(ends_[1]);
      Kind console(writer, no_input);
      use(console);
    }
    ::close(ends_[1]);
    std::string all;
    std::array<char, 4096> bytes{};
    for (ssize_t count = 1; count > 0;) {
      count = ::read(ends_[0], bytes.data(), bytes.size());
      all.append(bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(0, count)));
    }
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin < all.size();) {
      const std::size_t end = all.find('\n', begin);
      lines.push_back(all.substr(begin, end - begin));
      begin = end + 1;
    }
    return lines;
  }

  std::array<int, 2> ends_{};
};

const ToldEvent mark{.time = 12345ms, .name = "marked", .phase = "rating", .words = "Marked."};
const StatusWarning late{WarningKind::late_frames, "Frames are late."};

TEST_F(ConsoleOutput, LinesTellEventsAndWarningsAsTheyArise) {
  EXPECT_THAT(
      lines_of<LineConsole>([](LineConsole& console) {
        console.say("a\nb");
        console.tell(mark);
        console.show({});
        console.show({.warnings = {late}});
        console.show({.warnings = {late}});
        console.show({});
        console.show({.warnings = {late}});
      }),
      ElementsAre("a", "b", "   12.345 s  Marked.", "Frames are late.", "Frames are late."));
}

TEST_F(ConsoleOutput, MachinesGetAnObjectALineAndTheStatusEverySecond) {
  std::vector<nlohmann::json> objects;
  for (const std::string& line : lines_of<JsonConsole>([](JsonConsole& console) {
         console.say("a\nb \xff");
         console.tell(mark);
         console.show({.time = 0ms});
         console.show({.time = 900ms});
         console.show({.time = 950ms, .warnings = {late}});
         console.show({.time = 1900ms, .warnings = {late}});
         console.show({.time = 1950ms});
       })) {
    objects.push_back(nlohmann::json::parse(line));
  }
  ASSERT_EQ(objects.size(), 5U);
  EXPECT_EQ(objects[0]["kind"], "text");
  EXPECT_THAT(std::string(objects[0]["text"]), HasSubstr("a\nb "));
  EXPECT_EQ(objects[1], nlohmann::json({{"kind", "event"},
                                        {"time_s", 12.345},
                                        {"event", "marked"},
                                        {"phase", "rating"},
                                        {"words", "Marked."}}));
  EXPECT_EQ(objects[2]["kind"], "status");
  EXPECT_EQ(objects[2]["time_s"], 0.0);
  EXPECT_EQ(objects[3]["time_s"], 0.95) << "at once, with a warning";
  EXPECT_EQ(objects[4]["time_s"], 1.95);
}

}  // namespace
}  // namespace foveola::study
