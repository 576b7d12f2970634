#include "analysis/koskela2018/published_means.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace foveola::analysis {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

const std::filesystem::path data_file =
    std::filesystem::path(FOVEOLA_DATA_DIR) / "koskela2018" / "mean_percent_of_od.csv";

TEST(PublishedMeans, AreThoseOfThePaper) {
  const auto means = read_published_means(data_file);
  ASSERT_EQ(means.size(), 2U);
  EXPECT_EQ(published_mean_of(means, "od", "vp")->low, 31.0);
  EXPECT_EQ(published_mean_of(means, "od", "vp")->high, 33.0);
  EXPECT_EQ(published_mean_of(means, "od", "fv")->low, 9.0);
  EXPECT_EQ(published_mean_of(means, "od", "fv")->high, 12.0);
}

TEST(PublishedMeans, AreShownOnlyForWhatThePaperCompared) {
  const auto means = read_published_means(data_file);
  EXPECT_FALSE(published_mean_of(means, "od", "hybrid"));
  EXPECT_FALSE(published_mean_of(means, "vp", "fv"));
}

class PublishedMeansFile : public testing::Test {
 protected:
  ~PublishedMeansFile() override { std::filesystem::remove(path_); }

  void expect_error(const std::string& content, const std::string& message) {
    write_file(path_, content);
    EXPECT_THAT([this] { (void)read_published_means(path_); },
                ThrowsMessage<Error>(HasSubstr(message)));
  }

 private:
  std::filesystem::path path_ =
      std::filesystem::path(testing::TempDir()) / "foveola_published_means.csv";
};

TEST_F(PublishedMeansFile, SaysWhatIsWrongWithIt) {
  const std::string columns = "method,low_percent_of_od,high_percent_of_od\n";
  expect_error("", ":1: does not have the columns");
  expect_error("a,b\n", ":1: does not have the columns");
  expect_error(columns + "vp,31\n", ":2: has 2 fields");
  expect_error(columns + "vp,31,x\n", ":2: \"x\" is not a number");
  expect_error(columns + "vp,,33\n", ":2: \"\" is not a number");
}

}  // namespace
}  // namespace foveola::analysis
