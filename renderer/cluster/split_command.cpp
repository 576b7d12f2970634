#include "renderer/cluster/split_command.h"

#include <algorithm>
#include <array>

namespace foveola {
namespace {

constexpr std::array<std::string_view, 2> databases = {".sqlite", ".db"};
constexpr std::array<std::string_view, 2> images = {".exr", ".png"};
constexpr std::array<std::string_view, 2> texts = {".txt", ".json"};

constexpr std::array commands = {
    SplitCommand{.words = "study simulate",
                 .part_option = "--db",
                 .part_extension = ".sqlite",
                 .merge_words = "study merge",
                 .result = MergedResult::file,
                 .result_extensions = databases,
                 .prepare_option = "--prepare",
                 .goes_on = true,
                 .is_database = true},
    SplitCommand{.words = "render",
                 .part_option = "--output",
                 .part_extension = ".film",
                 .merge_words = "merge-images",
                 .result = MergedResult::file,
                 .result_extensions = images,
                 .prepare_option = {},
                 .goes_on = true},
    SplitCommand{.words = "bench convergence",
                 .part_option = "--output",
                 .part_extension = ".json",
                 .merge_words = "bench merge",
                 .result = MergedResult::folder,
                 .result_extensions = {},
                 .prepare_option = "--references"},
    SplitCommand{.words = "bench stability",
                 .part_option = "--output",
                 .part_extension = ".json",
                 .merge_words = "bench merge",
                 .result = MergedResult::text,
                 .result_extensions = texts,
                 .prepare_option = {}},
    SplitCommand{.words = "bench statistics",
                 .part_option = "--output",
                 .part_extension = ".json",
                 .merge_words = "bench merge",
                 .result = MergedResult::text,
                 .result_extensions = texts,
                 .prepare_option = {}},
};

/// What every part gets from whoever splits the work, and what is of no use in a part.
constexpr std::array<std::string_view, 8> options_of_parts = {
    "--shard", "--output", "-o", "--resume", "--threads", "--json", "--report", "--view"};

bool is_option(std::string_view word, std::string_view option) {
  return word == option || (word.starts_with(option) && word.substr(option.size()).front() == '=');
}

std::size_t count_of_words(std::string_view text) {
  return 1 + static_cast<std::size_t>(std::ranges::count(text, ' '));
}

}  // namespace

std::span<const SplitCommand> split_commands() { return commands; }

const SplitCommand* find_split_command(const std::vector<std::string>& words) {
  const auto begins_with = [&](const SplitCommand& command) {
    std::string beginning;
    for (std::size_t i = 0; i < std::min(words.size(), count_of_words(command.words)); ++i) {
      beginning += (i == 0 ? "" : " ") + words[i];
    }
    return beginning == command.words;
  };
  const auto* const found = std::ranges::find_if(commands, begins_with);
  return found == commands.end() ? nullptr : found;
}

std::string option_of_parts(const SplitCommand& command, const std::vector<std::string>& words) {
  const auto is_of_parts = [&](const std::string& word) {
    return is_option(word, command.part_option) ||
           (!command.prepare_option.empty() && is_option(word, command.prepare_option)) ||
           std::ranges::any_of(options_of_parts,
                               [&](std::string_view option) { return is_option(word, option); });
  };
  const auto found = std::ranges::find_if(words, is_of_parts);
  return found == words.end() ? std::string() : *found;
}

}  // namespace foveola
