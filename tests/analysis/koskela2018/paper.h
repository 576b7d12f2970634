// The paper's numbers as they are shipped.
#pragma once

#include <filesystem>

#include "analysis/koskela2018/published_study.h"

namespace foveola::analysis {

inline PublishedStudy paper() {
  return read_published_study(std::filesystem::path(FOVEOLA_DATA_DIR) / "koskela2018");
}

}  // namespace foveola::analysis
