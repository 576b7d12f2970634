#include "renderer/scene/textures/mip_chain.h"

#include <cmath>

#include "renderer/base/numbers/random.h"
#include "renderer/scene/textures/srgb.h"
#include "tests/matchers.h"

namespace foveola {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes level_bytes(const Bytes& texels, const MipLevel& level, int channels) {
  const auto begin = texels.begin() + static_cast<std::ptrdiff_t>(level.offset);
  return {begin, begin + static_cast<std::ptrdiff_t>(channels) * level.width * level.height};
}

Bytes random_bytes(std::size_t count, std::uint32_t first, std::uint32_t range) {
  Pcg32 random(7);
  Bytes bytes(count);
  for (std::uint8_t& byte : bytes) {
    byte = static_cast<std::uint8_t>(first + random.below(range));
  }
  return bytes;
}

TEST(MipChain, HalvesDownToSixteenTexels) {
  Bytes texels(static_cast<std::size_t>(11 * 24), 9);
  const std::vector<MipLevel> levels = append_mip_chain(texels, 24, 11, 1, false);
  std::vector<std::pair<int, int>> sizes;
  for (const MipLevel& level : levels) {
    sizes.emplace_back(level.width, level.height);
  }
  EXPECT_THAT(sizes, ElementsAre(std::pair(24, 11), std::pair(12, 5)));
  EXPECT_EQ(texels, Bytes(264 + 60, 9)) << "6 x 2 would be 12 texels";
  Bytes column(256, 9);
  EXPECT_EQ(append_mip_chain(column, 1, 256, 1, false).back().height, 16);
}

TEST(MipChain, FewTexelsStayAlone) {
  Bytes texels{1, 2, 3};
  EXPECT_EQ(append_mip_chain(texels, 1, 1, 3, true).size(), 1U);
  EXPECT_EQ(texels, (Bytes{1, 2, 3}));
}

/// `row` again and again, as long as levels of it are made.
Bytes repeated(const Bytes& row, int times) {
  Bytes result;
  for (int i = 0; i < times; ++i) {
    result.insert(result.end(), row.begin(), row.end());
  }
  return result;
}

TEST(MipChain, AveragesTwoByTwo) {
  Bytes texels = repeated({10, 20, 1, 3,  //
                           30, 40, 5, 7},
                          32);
  const std::vector<MipLevel> levels = append_mip_chain(texels, 4, 64, 1, false);
  ASSERT_EQ(levels.size(), 3U);
  EXPECT_EQ(level_bytes(texels, levels[1], 1), repeated({25, 4}, 32));
  EXPECT_EQ(level_bytes(texels, levels[2], 1), repeated({15, 14}, 8))
      << "14.5: what the first has too much, the next has too little";
}

/// A leaf, and what a painter left in its invisible part: its averages are the leaf's colour.
TEST(MipChain, TransparentTexelsHaveNoColour) {
  const auto coarser = [](const Bytes& invisible, bool has_opacity) {
    Bytes row{10, 200, 30, 255};
    row.insert(row.end(), invisible.begin(), invisible.end());
    Bytes texels = repeated(repeated(row, 4), 8);
    const MipLevel level = append_mip_chain(texels, 8, 8, 4, true, has_opacity).at(1);
    return level_bytes(texels, level, 4);
  };
  const Bytes over_black = coarser({0, 0, 0, 0}, true);
  EXPECT_EQ(over_black, coarser({255, 0, 255, 0}, true));
  for (std::size_t i = 0; i < over_black.size(); i += 4) {
    EXPECT_EQ(Bytes(over_black.begin() + i, over_black.begin() + i + 3), (Bytes{10, 200, 30}));
    EXPECT_NEAR(over_black[i + 3], 127.5, 0.5);
  }
  EXPECT_NE(coarser({0, 0, 0, 0}, false), over_black) << "of an opaque surface they are plain";
  const Bytes faint = coarser({255, 200, 30, 51}, true);  // a fifth as visible, linear red 1
  EXPECT_NEAR(faint[0], 114, 1);                          // sRGB of (0.00304 + 0.2) / 1.2
}

/// Of five texels each of two averages covers two and a half.
TEST(MipChain, OddSidesCutATexel) {
  const Bytes five{100, 50, 200, 0, 250};
  Bytes rows = repeated(five, 16);
  const std::vector<MipLevel> levels = append_mip_chain(rows, 5, 16, 1, false);
  EXPECT_EQ(level_bytes(rows, levels[1], 1), repeated({100, 140}, 8));
  Bytes columns;
  for (const std::uint8_t code : five) {
    columns.insert(columns.end(), 16, code);
  }
  const MipLevel next = append_mip_chain(columns, 16, 5, 1, false).at(1);
  const Bytes averages = level_bytes(columns, next, 1);
  EXPECT_EQ(averages, (Bytes{100, 100, 100, 100, 100, 100, 100, 100,  //
                             140, 140, 140, 140, 140, 140, 140, 140}));
}

/// Half the light of white is code 188 (IEC 61966-2-1: 0.5 encodes to 187.516).
TEST(MipChain, AveragesLightNotCode) {
  const auto half = [](const Bytes& pair, int channels) {
    Bytes texels = repeated(pair, 32);
    const std::vector<MipLevel> levels = append_mip_chain(texels, 2, 32, channels, true);
    Bytes first = level_bytes(texels, levels.at(1), channels);
    first.resize(static_cast<std::size_t>(channels));
    return first;
  };
  EXPECT_EQ(half({0, 255}, 1), Bytes{188});
  EXPECT_EQ(half({0, 0, 0, 0, 255, 255, 255, 255}, 4), (Bytes{188, 188, 188, 128}));
  EXPECT_EQ(half({0, 0, 255, 255}, 2), (Bytes{188, 128}));
}

double decoded(std::uint8_t code, bool is_srgb) {
  const double value = code / 255.0;
  if (!is_srgb) {
    return value;
  }
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

/// In codes: where sRGB is encoded, of the mean light's encoding.
double mean_code(const Bytes& bytes, int channel, int channels, bool is_srgb) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = static_cast<std::size_t>(channel); i < bytes.size();
       i += static_cast<std::size_t>(channels)) {
    sum += decoded(bytes[i], is_srgb);
    ++count;
  }
  const double mean = sum / static_cast<double>(count);
  if (!is_srgb) {
    return 255.0 * mean;
  }
  return 255.0 * (mean <= 0.0031308 ? 12.92 * mean : 1.055 * std::pow(mean, 1.0 / 2.4) - 0.055);
}

/// Levels of sizes of all kinds keep the mean light of the one before within half a code.
TEST(MipChain, KeepsTheMean) {
  const std::vector<std::pair<int, int>> sizes{{64, 64}, {1, 37},  {37, 1},   {17, 31},
                                               {3, 3},   {100, 7}, {127, 33}, {2, 255}};
  for (const auto& [width, height] : sizes) {
    for (const bool is_srgb : {false, true}) {
      Bytes texels = random_bytes(static_cast<std::size_t>(3 * width * height), 20, 200);
      const std::vector<MipLevel> levels = append_mip_chain(texels, width, height, 3, is_srgb);
      for (std::size_t i = 1; i < levels.size(); ++i) {
        for (int channel = 0; channel < 3; ++channel) {
          const double before =
              mean_code(level_bytes(texels, levels[i - 1], 3), channel, 3, is_srgb);
          const double after = mean_code(level_bytes(texels, levels[i], 3), channel, 3, is_srgb);
          EXPECT_NEAR(after, before, 0.5001) << width << " x " << height << " level " << i;
        }
      }
    }
  }
}

// Its texels are all much alike in a coarse level, and would all be rounded the same way.
TEST(MipChain, CoarseLevelsOfDarkTexturesKeepTheirMean) {
  const auto mean = [](const Bytes& codes) {
    double sum = 0.0;
    for (const std::uint8_t code : codes) {
      sum += linear_from_byte(/*is_srgb=*/true)[code];
    }
    return sum / static_cast<double>(codes.size());
  };
  for (const std::uint32_t brightest : {20U, 45U, 90U}) {
    Bytes texels = random_bytes(128 * 128, 1, brightest);
    const double expected = mean(texels);
    const std::vector<MipLevel> levels = append_mip_chain(texels, 128, 128, 1, true);
    for (const MipLevel& level : levels) {
      const double tolerance = level.width >= 8 ? 0.002 : 0.005;
      EXPECT_NEAR(mean(level_bytes(texels, level, 1)), expected, tolerance * expected)
          << brightest << ' ' << level.width;
    }
  }
}

}  // namespace
}  // namespace foveola
