// The paper's numbers were read twice, by two who did not see each other's: the shipped data must
// be the second reading's, cell by cell.
#include <cmath>
#include <filesystem>
#include <map>
#include <string>

#include <fmt/format.h>

#include "renderer/base/files/files.h"
#include "renderer/base/text/csv.h"
#include "tests/analysis/koskela2018/paper.h"
#include "tests/matchers.h"

namespace fs = std::filesystem;

namespace foveola::analysis {
namespace {

using Cells = std::map<std::string, double>;

Cells first_reading_of_tables() {
  const PublishedStudy published = paper();
  Cells cells;
  for (const PublishedAnswers& row : published.background) {
    cells[fmt::format("table1/{}///mean", row.question)] = row.mean;
    cells[fmt::format("table1/{}///sd", row.question)] = row.standard_deviation;
  }
  for (const PublishedTime& row : published.times) {
    const std::string cell = fmt::format("table2/{}/{}/{}", row.scene, row.mark, row.method);
    cells[cell + "/mean"] = row.mean;
    cells[cell + "/sd"] = row.standard_deviation;
  }
  return cells;
}

Cells first_reading_of_text() {
  Cells cells;
  for (const PublishedNumber& figure : paper().text) {
    cells[fmt::format("text/{}///value", figure.id)] = figure.value;
  }
  return cells;
}

/// The second reading's cells of a source.
Cells second_reading_of(const std::string& source) {
  const fs::path path = fs::path(FOVEOLA_DATA_DIR) / ".." / "tests" / "analysis" / "koskela2018" /
                        "second_reading.csv";
  Cells cells;
  const std::vector<CsvRow> rows = parse_csv(read_file(path), path.string());
  EXPECT_EQ(rows.front(), (CsvRow{"source", "row", "mark", "method", "quantity", "value"}));
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const CsvRow& row = rows[i];
    if (row.at(0) == source) {
      const auto [at, is_new] = cells.emplace(
          fmt::format("{}/{}/{}/{}/{}", row[0], row[1], row[2], row[3], row[4]), std::stod(row[5]));
      EXPECT_TRUE(is_new) << at->first;
    }
  }
  return cells;
}

TEST(Transcription, BothReadingsOfTheTablesAreTheSame) {
  Cells second = second_reading_of("table1");
  second.merge(second_reading_of("table2"));
  EXPECT_EQ(second.size(), 12U + 60U);
  EXPECT_THAT(first_reading_of_tables(), testing::ContainerEq(second));
}

TEST(Transcription, BothReadingsOfTheTextAreTheSame) {
  // Only the second has equation 7, which is the renderer's, and parts of the latency.
  const Cells second = second_reading_of("text");
  const Cells first = first_reading_of_text();
  EXPECT_EQ(first.size(), 19U);
  for (const auto& [figure, value] : first) {
    ASSERT_TRUE(second.contains(figure)) << figure;
    EXPECT_EQ(value, second.at(figure)) << figure;
  }
}

// Section 5 and Table 1 say the same of gender, whose codes are 5 for female and 1 for male.
TEST(Transcription, TheGendersOfTheTextAreThoseOfTable1) {
  const PublishedStudy published = paper();
  const double female = published_number(published, "female").value;
  const double male = published_number(published, "male").value;
  const double n = published_number(published, "participants").value;
  EXPECT_EQ(female + male, n);
  const double mean = (5.0 * female + male) / n;
  const double deviation = std::sqrt(16.0 * female * male / (n * (n - 1.0)));
  EXPECT_NEAR(published_answers(published, "gender")->mean, mean, 0.0501);
  EXPECT_NEAR(published_answers(published, "gender")->standard_deviation, deviation, 0.05);
}

}  // namespace
}  // namespace foveola::analysis
