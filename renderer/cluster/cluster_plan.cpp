#include "renderer/cluster/cluster_plan.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/shard.h"
#include "renderer/base/toml_file.h"
#include "renderer/base/toml_reader.h"

namespace fs = std::filesystem;

namespace foveola {
namespace {

constexpr std::size_t longest_name = 64;
constexpr int most_cores = 4096;
constexpr const char* blanks = " \t\r\n";

bool is_letter_or_digit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

bool is_plain_name(std::string_view name, std::string_view further) {
  return !name.empty() && name.size() <= longest_name && is_letter_or_digit(name.front()) &&
         std::ranges::all_of(name, [&](char c) {
           return is_letter_or_digit(c) || further.find(c) != further.npos;
         });
}

/// The words of a command, apart by blanks; those in quotes may have blanks in them.
std::vector<std::string> words_of(const TomlReader& reader, const std::string& command) {
  std::vector<std::string> words;
  for (std::size_t at = command.find_first_not_of(blanks); at < command.size();
       at = command.find_first_not_of(blanks, at)) {
    std::string word;
    while (at < command.size() && std::string_view(blanks).find(command[at]) == std::string::npos) {
      const char c = command[at];
      if (c != '"' && c != '\'') {
        word += c;
        ++at;
        continue;
      }
      const std::size_t end = command.find(c, at + 1);
      if (end == command.npos) {
        reader.fail(reader.source("command"), fmt::format("a quotation mark {} is not closed", c),
                    "close it");
      }
      word += command.substr(at + 1, end - at - 1);
      at = end + 1;
    }
    words.push_back(std::move(word));
  }
  return words;
}

void read_command(TomlReader& reader, ClusterJob& job) {
  job.words = words_of(reader, reader.require_text("command"));
  if (!job.words.empty() && job.words.front() == "foveola") {
    job.words.erase(job.words.begin());
  }
  const SplitCommand* const command = find_split_command(job.words);
  if (command == nullptr) {
    std::vector<std::string_view> known;
    for (const SplitCommand& each : split_commands()) {
      known.push_back(each.words);
    }
    reader.fail(reader.source("command"), "this is no command that can be split",
                fmt::format("begin it with {}", fmt::join(known, ", ")));
  }
  job.command = *command;
  if (const std::string option = option_of_parts(*command, job.words); !option.empty()) {
    reader.fail(reader.source("command"),
                fmt::format("{} is given by the plan, or is of the whole work", option),
                "leave it out");
  }
}

void read_output(TomlReader& reader, ClusterJob& job) {
  job.output = reader.require_text("output");
  if (!is_plain_name(job.output, "-_.") || job.output == folder_of_jobs) {
    reader.fail(reader.source("output"), "this is no plain name of a file, or that of the jobs",
                "use letters, digits, -, _ and dots: it lies in the plan's folder of results");
  }
  const auto& extensions = job.command.result_extensions;
  if (!extensions.empty() &&
      std::ranges::find(extensions, lower_case_extension(job.output)) == extensions.end()) {
    reader.fail(reader.source("output"),
                fmt::format("what {} makes is no such file", job.command.merge_words),
                fmt::format("end the name in {}", fmt::join(extensions, " or ")));
  }
}

/// A word for Slurm, of digits, letters and `further`.
void read_slurm_word(TomlReader& reader, std::string_view key, std::string_view further,
                     const char* example, std::string& value) {
  reader.read(key, value);
  if (reader.has(key) && !is_plain_name(value, further)) {
    reader.fail(reader.source(key), "Slurm does not read this", fmt::format("write {}", example));
  }
}

ClusterJob read_job(TomlReader& reader) {
  ClusterJob job;
  job.name = reader.require_text("name");
  if (!is_plain_name(job.name, "-_")) {
    reader.fail(reader.source("name"), "this is no plain name",
                "use at most 64 letters, digits, - and _");
  }
  read_command(reader, job);
  reader.require("shards");
  reader.read("shards", job.shards, 1, most_shards);
  reader.read("prepare_shards", job.prepare_shards, 0, most_shards);
  if (job.prepare_shards > 0 && job.command.prepare_option.empty()) {
    reader.fail(reader.source("prepare_shards"),
                fmt::format("{} has no caches to fill", job.command.words), "leave it out");
  }
  read_output(reader, job);
  read_slurm_word(reader, "time_limit", ":-", "\"08:00:00\" or \"2-12:00:00\"", job.time_limit);
  reader.read("cores", job.cores, 0, most_cores);
  read_slurm_word(reader, "memory", "", "\"4G\"", job.memory);
  reader.reject_unknown_keys();
  return job;
}

std::vector<std::string> read_slurm_options(TomlReader& reader) {
  std::vector<std::string> options;
  for (const TomlReader::Text& text : reader.texts("slurm_options")) {
    const bool is_option =
        text.value.starts_with("--") && text.value.find_first_of("\n\r") == text.value.npos;
    if (!is_option) {
      reader.fail(text.source, "this is no option of sbatch", "write \"--account=vision\"");
    }
    options.push_back(text.value);
  }
  return options;
}

}  // namespace

ClusterPlan read_cluster_plan(const fs::path& file) {
  const std::string name = file.string();
  ClusterPlan plan{.file = fs::absolute(file).lexically_normal(),
                   .text = read_toml_file(file),
                   .jobs = {},
                   .slurm_options = {}};
  const toml::table table =
      parse_toml(name, plan.text, "mend it as TOML (https://toml.io); see docs/CLUSTER.md");
  TomlReader reader(name, table, "");
  plan.slurm_options = read_slurm_options(reader);
  for (TomlReader& job : reader.tables("job")) {
    plan.jobs.push_back(read_job(job));
    const ClusterJob& last = plan.jobs.back();
    for (auto other = plan.jobs.begin(); other + 1 != plan.jobs.end(); ++other) {
      const bool same_name = other->name == last.name;
      if (same_name || other->output == last.output) {
        job.fail(job.source(same_name ? "name" : "output"), "another job has this, too",
                 "give each job its own");
      }
    }
  }
  reader.reject_unknown_keys();
  if (plan.jobs.empty()) {
    throw Error(name, "has no job", "write a table [[job]] with name, command, shards and output");
  }
  return plan;
}

}  // namespace foveola
