#include <gtest/gtest.h>

#include "analysis/publication/exports/data_files.h"
#include "tests/analysis/gunzip.h"

namespace foveola::analysis {
namespace {

TEST(Gzip, ZlibGivesTheTextBack) {
  std::string text;
  for (long i = 0; i < 50'000; ++i) {
    text += std::to_string(i * i) + "\t\n";
  }
  EXPECT_EQ(gunzip(gzip(text)), text);
  EXPECT_LT(gzip(text).size(), text.size() / 2);
  EXPECT_EQ(gunzip(gzip("")), "");
}

TEST(Gzip, TheSameTextGivesTheSameFile) {
  EXPECT_EQ(gzip("a text"), gzip("a text"));
  EXPECT_EQ(gzip("a text").substr(0, 2), "\x1f\x8b");
  EXPECT_EQ(gzip("a text").substr(4, 4), std::string(4, '\0')) << "no time";
}

}  // namespace
}  // namespace foveola::analysis
