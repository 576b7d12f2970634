// Protocols as accidents leave them: whatever is in the file, it is read or refused in words.

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "renderer/base/numbers/random.h"
#include "study/protocol/protocol.h"
#include "tests/matchers.h"

namespace foveola::study {
namespace {

struct Outcomes {
  int read = 0;
  int refused = 0;
};

/// Anything but a protocol or an Error that names its place ends the test program.
void read_whatever(const std::string& text, Outcomes& outcomes) {
  try {
    const Protocol protocol = read_protocol(text, "broken.toml");
    ++outcomes.read;
    EXPECT_FALSE(protocol.phases.empty());
  } catch (const Error& error) {
    ++outcomes.refused;
    EXPECT_THAT(error.what(), StartsWith("broken.toml:"));
  }
}

std::string published() { return read_file(find_protocol("koskela2018")); }

TEST(BrokenProtocols, ThatEndTooSoonAreReadOrRefused) {
  const std::string text = published();
  Outcomes outcomes;
  for (std::size_t end = 0; end < text.size(); end += 3) {
    read_whatever(text.substr(0, end), outcomes);
  }
  EXPECT_GT(outcomes.read, 100);
  EXPECT_GT(outcomes.refused, 1000);
}

/// A byte, a line or a number changed, or two lines swapped.
std::string changed(std::string text, Pcg32& random) {
  const auto size = static_cast<std::uint32_t>(text.size());
  const std::size_t place = random.below(size);
  const std::size_t line = text.find('\n', place);
  switch (random.below(5)) {
    case 0:
      text[place] = static_cast<char>(random.below(256));
      break;
    case 1:
      text.erase(place, random.below(40));
      break;
    case 2:
      text.insert(place, text.substr(random.below(size), 60));
      break;
    case 3:
      text.insert(line == std::string::npos ? 0 : line + 1, "[[questionnaire.question]]\n");
      break;
    default:
      if (const std::size_t digit = text.find_first_of("0123456789", place);
          digit != std::string::npos) {
        text.replace(digit, 1, random.below(2) == 0 ? "-1e99" : "99999999999999999999");
      }
  }
  return text;
}

TEST(BrokenProtocols, ThatWereScrambledAreReadOrRefused) {
  const std::string text = published();
  Pcg32 random(8);
  Outcomes outcomes;
  for (int i = 0; i < 3000; ++i) {
    std::string scrambled = text;
    const std::uint32_t changes = 1 + random.below(4);
    for (std::uint32_t change = 0; change < changes; ++change) {
      scrambled = changed(scrambled, random);
    }
    read_whatever(scrambled, outcomes);
  }
  EXPECT_GT(outcomes.read, 100);
  EXPECT_GT(outcomes.refused, 1000);
}

}  // namespace
}  // namespace foveola::study
