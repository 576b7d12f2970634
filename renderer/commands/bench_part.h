// Parts of a benchmark that is split: a file for each, and all of them together again.
#pragma once

#include <cstdint>
#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "renderer/base/shard.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace foveola {

/// What one of a benchmark's parts has measured.
struct BenchPart {
  std::string command;  ///< of `bench`: "statistics"
  Shard shard;
  /// An object: all that the results depend on but for the program, the same in every part.
  nlohmann::json settings;
  nlohmann::json results;
  std::filesystem::path file;  ///< where it was read; empty if it was not
};

/// Writes the part with the name of this program, whole or not at all. Throws Error if it cannot
/// be written.
void write_bench_part(const std::filesystem::path& path, const BenchPart& part);

/// All parts of one benchmark in the order of their numbers, from files in any order, at least one.
/// Throws Error for what is no part or damaged, for parts of another program than this, of other
/// settings or of another split, and for one that is missing or there more than once.
std::vector<BenchPart> read_whole_bench(const std::vector<std::filesystem::path>& files);

/// What `read` makes of the part. Throws Error, which names its file, for whatever `read` throws:
/// settings or results are not as this program writes them.
template <typename Read>
auto read_part(const BenchPart& part, const Read& read) {
  try {
    return read(part);
  } catch (const std::exception&) {
    throw Error(part.file.string(), "is damaged", "measure this part again");
  }
}

/// The whole number, from 0 to `most`, that `json` is. Throws std::out_of_range for anything else.
std::uint64_t whole_number(const nlohmann::json& json, std::uint64_t most);

/// --shard and --output as typed; empty where they are not.
struct BenchPartArguments {
  std::string shard;
  std::string output;
};

/// Adds --shard to `command`. Returns the option.
CLI::Option* add_shard_option(CLI::App& command, std::string& shard);
/// Adds --shard and --output, which need each other.
void add_bench_part_options(CLI::App& command, BenchPartArguments& arguments);

/// Empty if all is to be measured. Throws UsageError for what is no shard, and Error if the output
/// could not be written: before the work, not after it.
std::optional<Shard> shard_of(const BenchPartArguments& arguments);

/// Says which part was written where, on standard output.
void print_written(const std::filesystem::path& path, const BenchPart& part, bool as_json);

/// Throws Error if `stop` was requested: half a part is no part.
void require_finished(const std::filesystem::path& path, bool is_stopped);

}  // namespace foveola
