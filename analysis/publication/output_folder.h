// The folder that results go to.
#pragma once

#include <filesystem>

namespace foveola::analysis {

/// Throws Error unless make_output_folder and writing into the folder would succeed: for refusing a
/// bad output before long work.
void check_output_folder(const std::filesystem::path& folder);

/// Makes the folder if its parent exists. Throws Error if it cannot be made or is a file.
void make_output_folder(const std::filesystem::path& folder);

}  // namespace foveola::analysis
