// OUTPUTS.md is what the tables' columns say, and names everything that an analysis writes.
#include "analysis/publication/exports/outputs_document.h"

#include <filesystem>

#include "analysis/publication/analyze_study.h"
#include "renderer/base/files/files.h"
#include "renderer/base/text/csv.h"
#include "tests/analysis/made_up_study.h"
#include "tests/matchers.h"
#include "tests/temporary_folder.h"

namespace foveola::analysis {
namespace {

namespace fs = std::filesystem;

class OutputsDocument : public testing::Test {
 protected:
  const test::TemporaryFolder scratch_;
  const AnalysisOutput output_ = analyze_records(golden_study_records(), {}, scratch_ / "out");
  const std::string document_ = outputs_in_words(output_.results);
};

TEST_F(OutputsDocument, IsTheOneInTheRepository) {
  const fs::path kept =
      fs::path(FOVEOLA_DATA_DIR).parent_path() / "analysis/publication/OUTPUTS.md";
  if (read_file(kept) != document_) {
    const fs::path made = fs::temp_directory_path() / "foveola-OUTPUTS.md";
    write_file(made, document_);
    FAIL() << "OUTPUTS.md is not what the tables' columns say; if they changed on purpose:\n  cp "
           << made.string() << ' ' << kept.string();
  }
}

TEST_F(OutputsDocument, NamesEveryTableAndEveryColumn) {
  for (const fs::path& file : output_.files) {
    if (file.parent_path() != scratch_ / "out" || file.extension() != ".csv" ||
        file.stem() == "codebook") {
      continue;
    }
    EXPECT_THAT(document_, HasSubstr("### " + file.filename().string() + "\n")) << file;
    const CsvRow columns = parse_csv(read_file(file), file).at(0);
    for (const std::string& column : columns) {
      EXPECT_THAT(document_, HasSubstr("- `" + column + "` (")) << file;
    }
  }
}

}  // namespace
}  // namespace foveola::analysis
