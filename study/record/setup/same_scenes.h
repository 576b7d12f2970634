// Every scene the same for the whole of a study: results on two would be taken for one.
#pragma once

#include <filesystem>
#include <vector>

#include "study/record/write/study_store.h"

namespace foveola::study {

/// Throws Error if a session of the study at `database`, which exists, was shown another file under
/// the name of one of `scenes`, or the same one from another place or in another light.
void require_same_scenes(const std::filesystem::path& database,
                         const std::vector<ShownScene>& scenes);

}  // namespace foveola::study
