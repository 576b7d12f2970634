// No output is an input: what a command writes takes the place of nothing that it reads.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace foveola {

/// Marks an option as the path of something that its command writes, as every --output is. Returns
/// it.
CLI::Option* mark_output(CLI::Option* option);

/// What a command line has the command write, as "--output" and a path.
struct OutputPath {
  std::string option;
  std::filesystem::path path;
};

/// Of the commands that were given. Throws Error if an output is a file that the command line
/// names, too, or lies beside one: see require_no_input().
std::vector<OutputPath> outputs_apart_from_inputs(CLI::App& app);

/// Throws Error if an output is `input`, by whatever name, or by its own name one of the files
/// that a study has beside it: its log, its lock, its backups.
void require_no_input(const std::vector<OutputPath>& outputs, const std::filesystem::path& input);

}  // namespace foveola
