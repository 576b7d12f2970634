#include "analysis/koskela2018/published_study.h"

#include <utility>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "tests/analysis/koskela2018/paper.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

TEST(PublishedStudy, HasACellForEverySceneMarkAndMethod) {
  const PublishedStudy published = paper();
  EXPECT_EQ(published.background.size(), 6U);
  ASSERT_EQ(published.times.size(), 5U * 2U * 3U);
  for (const char* scene : {"bmw", "classroom", "conference", "sibenik", "sponza"}) {
    for (const char* mark : {"outline", "material"}) {
      for (const char* method : {"od", "vp", "fv"}) {
        EXPECT_NE(published_time(published, scene, mark, method), nullptr) << scene;
      }
    }
  }
  EXPECT_EQ(published_time(published, "bmw", "outline", "hybrid"), nullptr);
  EXPECT_EQ(published_answers(published, "shoe_size"), nullptr);
}

// exp of the mean logarithm of Table 2's five means, by a pocket calculator.
TEST(PublishedStudy, GeometricMeansOverScenesAreComputedFromTable2) {
  const PublishedStudy published = paper();
  EXPECT_NEAR(geometric_mean_of_table_2(published, "outline", "od").value(), 17.38, 0.005);
  EXPECT_NEAR(geometric_mean_of_table_2(published, "outline", "vp").value(), 30.34, 0.005);
  EXPECT_NEAR(geometric_mean_of_table_2(published, "outline", "fv").value(), 11.37, 0.005);
  EXPECT_NEAR(geometric_mean_of_table_2(published, "material", "od").value(), 66.40, 0.005);
  EXPECT_NEAR(geometric_mean_of_table_2(published, "material", "vp").value(), 32.49, 0.005);
  EXPECT_NEAR(geometric_mean_of_table_2(published, "material", "fv").value(), 9.10, 0.005);
  EXPECT_FALSE(geometric_mean_of_table_2(published, "third", "od"));
}

TEST(PublishedStudy, AMeanHasTheIntervalOf16ParticipantsEvenBelowZero) {
  const PublishedStudy published = paper();
  // t(15) = 2.131450: 41.8 -+ 2.131450 * 9.8 / 4.
  const Estimate vp = published_mean(published, 41.8, 9.8);
  EXPECT_EQ(vp.n, 16U);
  EXPECT_NEAR(vp.interval->low, 36.578, 0.0005);
  EXPECT_NEAR(vp.interval->high, 47.022, 0.0005);
  // Conference's material with OD, 137.2 -+ 105.19, and a longer tail, 10 -+ 10.66.
  EXPECT_NEAR(published_mean(published, 137.2, 197.4).interval->low, 32.013, 0.0005);
  EXPECT_NEAR(published_mean(published, 10.0, 20.0).interval->low, -0.657, 0.0005);
}

TEST(PublishedStudy, ASceneStandsForItselfOrAsACounterpart) {
  const PublishedStudy published = paper();
  const PublishedScene real = published_scene_of(published, "sponza").value();
  EXPECT_EQ(real.name, "sponza");
  EXPECT_FALSE(real.is_counterpart);
  const PublishedScene own = published_scene_of(published, "arcade").value();
  EXPECT_EQ(own.name, "sponza");
  EXPECT_TRUE(own.is_counterpart);
  EXPECT_FALSE(published_scene_of(published, "aula"));
}

TEST(PublishedStudy, ADamagedTableIsNamedWithItsLine) {
  const ScratchFolder folder;
  const std::string table1 = "question,mean,sd\n";
  const std::string table2 = "scene,counterpart,mark,method,mean,sd\n";
  const std::string text = "figure,value,unit,section\n";
  write_file(folder / "table1.csv", table1 + "age,30.5,2\n");
  write_file(folder / "text.csv", text);
  const auto read = [&] { (void)read_published_study(folder / ""); };
  for (const auto& [content, says] :
       {std::pair(table2 + "bmw,studio-car,outline,od,4.5 s,1\n",
                  "table2.csv:2: \"4.5 s\" is not a number"),
        std::pair(table2 + "bmw,studio-car,outline,od,4.5,\n",
                  "table2.csv:2: \"\" is not a number"),
        std::pair(table2 + "bmw,studio-car,shade,od,1,1\n", "\"shade\" is not a mark"),
        std::pair(table2 + "bmw,studio-car\n", "has 2 fields instead of 6"),
        std::pair(std::string("scene\n"), "table2.csv:1")}) {
    write_file(folder / "table2.csv", content);
    EXPECT_THAT(read, ThrowsMessage<Error>(HasSubstr(says)));
  }
  write_file(folder / "table2.csv", table2);
  write_file(folder / "text.csv", text + "participants,many,,5\n");
  EXPECT_THAT(read, ThrowsMessage<Error>(HasSubstr("text.csv:2: \"many\" is not a number")));
  write_file(folder / "text.csv", text);
  EXPECT_THAT([&] { (void)published_number(read_published_study(folder / ""), "participants"); },
              ThrowsMessage<Error>(HasSubstr("text.csv: has no row of the figure")));
}

}  // namespace
}  // namespace foveola::analysis
