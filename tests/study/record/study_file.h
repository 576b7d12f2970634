// A place for a study's file, and the words in which its tests speak of it.
#pragma once

#include <filesystem>

#include "small_study.h"
#include "study/record/maintain/maintenance.h"
#include "tests/matchers.h"

namespace foveola::study {

namespace fs = std::filesystem;

/// A folder in which nothing is but what its test writes, a study at path_ above all.
class StudyFile : public testing::Test {
 protected:
  TemporaryFolder folder_;
  fs::path path_ = folder_ / "study.sqlite";
};

}  // namespace foveola::study
