// The commands of foveola whose work can be split, and how their parts become one result.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace foveola {

/// What a merge makes.
enum class MergedResult : std::uint8_t {
  file,    ///< a file, named by the merge's --output
  folder,  ///< a folder of files, named likewise
  text     ///< what the merge prints
};

struct SplitCommand {
  std::string_view words;        ///< "study simulate"
  std::string_view part_option;  ///< names the file of a part
  std::string_view part_extension;
  std::string_view merge_words;  ///< "study merge", before the parts
  MergedResult result = MergedResult::file;
  std::span<const std::string_view> result_extensions;  ///< of a file or a text; of a folder none
  /// Only fills the caches that the work reads; empty if there are none.
  std::string_view prepare_option;
  bool goes_on = false;      ///< knows --resume
  bool is_database = false;  ///< parts are SQLite's, which must not be written over a network
};

/// All of them.
std::span<const SplitCommand> split_commands();

/// The one that `words` begin with; null if there is none.
const SplitCommand* find_split_command(const std::vector<std::string>& words);

/// The first of the words that the command gets from whoever splits it (--shard, the file of a
/// part, the number of threads and so on), as it is written there; empty if there is none.
std::string option_of_parts(const SplitCommand& command, const std::vector<std::string>& words);

}  // namespace foveola
