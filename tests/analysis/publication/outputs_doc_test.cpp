// OUTPUTS.md names everything that an analysis writes.
#include <filesystem>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/publication/analyze_study.h"
#include "renderer/base/csv.h"
#include "renderer/base/files.h"
#include "tests/analysis/made_up_study.h"

namespace foveola::analysis {
namespace {

namespace fs = std::filesystem;

TEST(OutputsDocument, NamesEveryFileAndEveryColumn) {
  const std::string document =
      read_file(fs::path(FOVEOLA_DATA_DIR).parent_path() / "analysis/publication/OUTPUTS.md");
  const ScratchFolder scratch;
  const AnalysisOutput output =
      analyze_records(golden_study_records(), {}, scratch / "out", {.bids = false});
  std::set<std::string> described_elsewhere = {"participants_wide.csv", "trials_long.csv",
                                               "codebook.csv"};
  for (const fs::path& file : output.files) {
    if (file.parent_path() != scratch / "out") {
      continue;
    }
    EXPECT_THAT(document, testing::HasSubstr("`" + file.stem().string())) << file;
    if (file.extension() != ".csv" || described_elsewhere.contains(file.filename())) {
      continue;
    }
    const CsvRow columns = parse_csv(read_file(file), file).at(0);
    for (const std::string& column : columns) {
      EXPECT_THAT(document, testing::HasSubstr("`" + column + "`")) << file;
    }
  }
}

}  // namespace
}  // namespace foveola::analysis
