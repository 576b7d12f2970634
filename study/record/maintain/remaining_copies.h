// What still holds a participant who was taken out of a study: files that other commands wrote, and
// copies under names that nobody told of.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace foveola::study {

/// A file, and what of the person it holds or why nobody knows.
struct RemainingCopy {
  std::filesystem::path file;
  std::string what;
};

/// Whether `word` stands in the text, and no letter or digit at either end of it.
bool has_word(std::string_view text, std::string_view word);

/// Looks through all files of the study's folder and of those in it: their names for the
/// participant's code, their bytes for the code as a word of its own and for the sessions' UUIDs.
/// Links are not followed. What cannot be read is listed too.
std::vector<RemainingCopy> remaining_copies(const std::filesystem::path& study,
                                            const std::string& code,
                                            const std::set<std::string>& uuids);

}  // namespace foveola::study
