#include "renderer/command_line/output_options.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files/file_access.h"

namespace fs = std::filesystem;

namespace foveola {
namespace {

constexpr const char* output_mark = "an output";

bool is_output(CLI::Option& option) {
  if (option.check_lname("output")) {
    return true;
  }
  try {
    return option.get_validator(output_mark) != nullptr;
  } catch (const CLI::OptionNotFound&) {
    return false;
  }
}

/// The path with all links followed as far as it exists.
fs::path place_of(const fs::path& path) {
  std::error_code ignored;
  const fs::path place = fs::weakly_canonical(path, ignored);
  return place.has_filename() ? place : place.parent_path();
}

bool is_same_file(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  return fs::equivalent(a, b, ignored) || place_of(a) == place_of(b);
}

/// Whether it is a file beside a study: SQLite's files, its writer's lock, and its backups.
bool is_beside(const fs::path& path, const fs::path& input) {
  constexpr std::array beside = {"-wal", "-shm", "-journal", ".controller", ".backups"};
  const fs::path place = place_of(path);
  return std::ranges::any_of(beside, [&](const char* ending) {
    const fs::path other = place_of(input).string() + ending;
    return is_same_file(place, other) || place.parent_path() == other;
  });
}

/// Whether a value names an existing file, or a study to be made.
bool may_be_input(const std::string& value) {
  std::error_code ignored;
  return fs::exists(value, ignored) ? !fs::is_directory(value, ignored)
                                    : fs::path(value).has_extension();
}

/// An output of a command line, as "--output" and a path.
struct OutputPath {
  std::string option;
  fs::path path;
};

void collect(CLI::App& app, std::vector<OutputPath>& outputs, std::vector<fs::path>& inputs) {
  for (CLI::Option* option : app.get_options()) {
    for (const std::string& value : option->results()) {
      if (is_output(*option)) {
        outputs.push_back({.option = option->get_name(), .path = value});
      } else if (may_be_input(value)) {
        inputs.emplace_back(value);
      }
    }
  }
  for (CLI::App* command : app.get_subcommands()) {
    collect(*command, outputs, inputs);
  }
}

/// Throws if an output is the input under any name, or has the name of a file beside a study: its
/// log, its lock, its backups.
void require_no_input(const std::vector<OutputPath>& outputs, const fs::path& input) {
  for (const auto& [option, path] : outputs) {
    if (is_same_file(path, input)) {
      throw Error(option, fmt::format("{} is read by the command, too", path.string()),
                  "name another file");
    }
    if (is_beside(path, input)) {
      throw Error(option, fmt::format("{} belongs to {}", path.string(), input.string()),
                  "name another file");
    }
  }
}

}  // namespace

CLI::Option* mark_output(CLI::Option* option) {
  return option->check(CLI::Validator([](std::string&) { return std::string(); }, "", output_mark));
}

void keep_outputs_apart(CLI::App& app) {
  std::vector<OutputPath> outputs;
  std::vector<fs::path> inputs;
  collect(app, outputs, inputs);
  for (const fs::path& input : inputs) {
    require_no_input(outputs, input);
  }
  for (const auto& [option, path] : outputs) {
    guard_output(option, path);
  }
}

}  // namespace foveola
