#include "renderer/cluster/job_scripts.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/error.h"
#include "renderer/command_line/shell_text.h"

namespace fs = std::filesystem;

namespace foveola {
namespace {

/// Before the time limit, for keeping what there is.
constexpr int warning_s = 120;

/// Slurm replaces % in the names of logs, and knows no quotes in them.
void require_plain(const fs::path& folder) {
  if (folder.string().find_first_of("%\"'\\\n\r") != std::string::npos) {
    throw Error(folder.string(), "has %, a quotation mark, \\ or a line break in its name",
                "name a folder without them with --output");
  }
}

std::string quoted(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : " ") + shell_quoted(word);
  }
  return text;
}

/// What Slurm is to know: lines that are comments to bash.
std::string slurm_lines(Stage stage, const ScriptSetting& setting, const ClusterJob& job,
                        const JobFolder& folder) {
  std::vector<std::string> options = {fmt::format("--job-name={}-{}", job.name, name_of(stage))};
  const bool is_array = stage != Stage::merge;
  const std::string log = (folder.path() / "logs" / name_of(stage)).string();
  if (is_array) {
    const std::string limit = setting.at_once > 0 ? fmt::format("%{}", setting.at_once) : "";
    options.push_back(fmt::format("--array=1-{}{}", folder.count(stage), limit));
    options.emplace_back("--nodes=1");
    options.emplace_back("--ntasks=1");
    options.push_back(job.cores > 0 ? fmt::format("--cpus-per-task={}", job.cores)
                                    : std::string("--exclusive"));
    if (!job.memory.empty()) {
      options.push_back("--mem=" + job.memory);
    }
    if (!job.time_limit.empty()) {
      options.push_back("--time=" + job.time_limit);
      options.push_back(fmt::format("--signal=B:USR1@{}", warning_s));
    }
    options.emplace_back("--requeue");
  }
  options.emplace_back("--open-mode=append");
  options.push_back(fmt::format("--output=\"{}{}.log\"", log, is_array ? "-%a" : ""));
  options.insert(options.end(), setting.slurm_options.begin(), setting.slurm_options.end());
  std::string lines;
  for (const std::string& option : options) {
    lines += fmt::format("#SBATCH {}\n", option);
  }
  return lines;
}

std::string opening(Stage stage, const ScriptSetting& setting, const ClusterJob& job,
                    const JobFolder& folder) {
  const char* const does = stage == Stage::prepare  ? "Fills caches for"
                           : stage == Stage::shards ? "Computes one part of"
                                                    : "Merges the parts of";
  return fmt::format(
      "#!/bin/bash\n"
      "# {} the job {} of {}. Written by foveola cluster submit; yours to read, keep and edit.\n"
      "{}"
      "set -euo pipefail\n"
      "cd {}\n"
      "foveola={}\n"
      "job={}\n",
      does, job.name, setting.plan_name, slurm_lines(stage, setting, job, folder),
      shell_quoted(setting.plan_folder.string()), shell_quoted(setting.program.string()),
      shell_quoted(folder.path().string()));
}

/// Which part this is, unless it is done. finished: its file, in terms of $job and $shard.
std::string which_part(std::int64_t count, const std::string& finished) {
  return fmt::format(
      "shard=${{SLURM_ARRAY_TASK_ID:-${{1:?which of the {0} parts}}}}\n"
      "part={1}\n"
      "if [ -e \"$part\" ]; then\n"
      "  echo \"Part $shard of {0} is done already.\"\n"
      "  exit\n"
      "fi\n"
      "echo \"Part $shard of {0} on $(uname -n)\"\n",
      count, finished);
}

/// Where databases grow. SQLite must not be written over a network.
constexpr std::string_view on_local_disk = R"sh(
# A database grows on this machine's own disk. What there was when it was stopped is in an archive.
scratch=$(mktemp -d "${SLURM_TMPDIR:-${TMPDIR:-/tmp}}/foveola-XXXXXX")
trap 'rm -rf "$scratch"' EXIT
work=$scratch/part.sqlite
kept=$job/unfinished/$shard.tar
if [ -e "$kept" ]; then
  tar -C "$scratch" -xf "$kept"
fi
keep() {
  tar -C "$scratch" -cf "$kept.new" . && mv "$kept.new" "$kept"
}
publish() {
  cp "$work" "$part.new" && mv "$part.new" "$part"
  rm -f "$kept"
}
so_far() { cksum "$work" 2>/dev/null || true; }
)sh";

constexpr std::string_view in_place = R"sh(
# The program writes this file whole or not at all, and goes on with a render where it was.
work=$job/unfinished/$shard@EXTENSION@
keep() { :; }
publish() { mv "$work" "$part"; }
so_far() { cksum "$work" 2>/dev/null || true; }
)sh";

constexpr std::string_view nothing_but_caches = R"sh(
# What was rendered lies in the caches, where nothing is rendered twice.
keep() { :; }
publish() { touch "$part"; }
so_far() { ls -R "${XDG_CACHE_HOME:-$HOME/.cache}/foveola" 2>/dev/null | cksum; }
)sh";

/// Behind the program, which runs in the background: a shell that waits in the foreground would not
/// take signals.
constexpr std::string_view until_it_ends = R"sh(program=$!

# Slurm sends USR1 shortly before the time is up. A program that is asked to end keeps what it has.
out_of_time=
trap 'out_of_time=yes; kill -TERM "$program"' USR1
# When a job is cancelled, Slurm sends TERM to the program itself; a second one would end it at once.
if [ -n "${SLURM_JOB_ID:-}" ]; then
  trap : TERM
else
  trap 'kill -TERM "$program"' TERM INT
fi
while :; do
  status=0
  wait "$program" || status=$?
  kill -0 "$program" 2>/dev/null || break  # A signal ends the wait, but not the program.
done

again() {
  echo "Part $shard is to go on: $1"
  rm -rf "${scratch:-}"
  if [ -n "${SLURM_JOB_ID:-}" ]; then  # For one of an array, that may name all of it.
    scontrol requeue "${SLURM_ARRAY_JOB_ID}_$shard"
  fi
  exit 75
}

if [ "$status" -eq 0 ]; then
  publish
  echo "Part $shard is done."
  exit
fi
keep
if [ -n "$out_of_time" ]; then
  if [ "$(so_far)" = "$before" ]; then
    echo "Part $shard came no further in its time: give it more (time_limit), or make more shards"
    exit 1
  fi
  again "its time was up"
fi
# Killed, as for want of memory, or crashed. That may pass; what the program itself refuses, with 1 or
# 2, will not. 130: it was asked to end.
if [ "$status" -eq 130 ]; then
  echo "Part $shard was stopped."
elif [ "$status" -gt 2 ]; then
  deaths=$job/unfinished/$shard.deaths
  echo "$status" >>"$deaths"
  if [ "$(wc -l <"$deaths")" -le 2 ]; then
    again "it ended with exit code $status"
  fi
  echo "Part $shard ended with exit code $status three times."
fi
exit "$status"
)sh";

std::string with(std::string_view text, const std::string& name, std::string_view value) {
  return replaced_all(std::string(text), "@" + name + "@", std::string(value));
}

std::string part_script(Stage stage, const ClusterJob& job, std::int64_t count) {
  const bool prepares = stage == Stage::prepare;
  const std::string extension(job.command.part_extension);
  std::string text =
      which_part(count, prepares ? "$job/prepared/$shard" : "$job/parts/$shard" + extension);
  if (prepares) {
    text += nothing_but_caches;
  } else if (job.command.is_database) {
    text += on_local_disk;
  } else {
    text += with(in_place, "EXTENSION", extension);
  }
  const std::string own = prepares ? std::string(job.command.prepare_option)
                                   : fmt::format("{} \"$work\"{}", job.command.part_option,
                                                 job.command.goes_on ? " --resume" : "");
  text += fmt::format(
      "before=$(so_far)\n\n\"$foveola\" {} {} --shard \"$shard/{}\" --threads "
      "\"${{SLURM_CPUS_ON_NODE:-{}}}\" &\n",
      quoted(job.words), own, count, job.cores);
  text += until_it_ends;
  return text;
}

/// Refuses to merge before all parts are there.
constexpr std::string_view all_parts = R"sh(for part in "${parts[@]}"; do
  if ! [ -e "$part" ]; then
    echo "$part is missing."
    exit 1
  fi
done

# The result appears whole, under its name.
rm -rf "$merged"
)sh";

/// SQLite reads on this machine's own disk, too.
constexpr std::string_view of_databases =
    R"sh(scratch=$(mktemp -d "${SLURM_TMPDIR:-${TMPDIR:-/tmp}}/foveola-XXXXXX")
trap 'rm -rf "$scratch"' EXIT
mkdir "$scratch/parts"
cp "${parts[@]}" "$scratch/parts"
"$foveola" @MERGE@ "$scratch/parts"/* --output "$scratch/merged.sqlite"
cp "$scratch/merged.sqlite" "$merged"
)sh";

constexpr std::string_view of_files = R"sh("$foveola" @MERGE@ "${parts[@]}" --output "$merged"
)sh";

/// The program may say by its exit code that what it found is not as it should be.
constexpr std::string_view of_texts = R"sh(status=0
"$foveola" @MERGE@ "${parts[@]}"@JSON@ >"$merged" || status=$?
if [ -s "$merged" ]; then
  mv "$merged" "$result"
  echo "Merged into $result"
fi
exit "$status"
)sh";

constexpr std::string_view under_its_name = R"sh(mv "$merged" "$result"
echo "Merged into $result"
)sh";

std::string merge_script(const ClusterJob& job, const JobFolder& folder) {
  std::string text = fmt::format(
      "result={}\n"
      "merged=$job/unfinished/{}\n"
      "if [ -e \"$result\" ]; then\n"
      "  echo \"It is merged already.\"\n"
      "  exit\n"
      "fi\n"
      "parts=()\n"
      "for shard in $(seq {}); do\n"
      "  parts+=(\"$job/parts/$shard{}\")\n"
      "done\n",
      shell_quoted(folder.output().string()), job.output, job.shards, job.command.part_extension);
  text += all_parts;
  if (job.command.result == MergedResult::text) {
    const bool is_json = folder.output().extension() == ".json";
    return text +
           with(with(of_texts, "MERGE", job.command.merge_words), "JSON", is_json ? " --json" : "");
  }
  text += with(job.command.is_database ? of_databases : of_files, "MERGE", job.command.merge_words);
  return text + std::string(under_its_name);
}

}  // namespace

std::string job_script(Stage stage, const ScriptSetting& setting, const ClusterJob& job,
                       const JobFolder& folder) {
  require_plain(folder.path());
  return opening(stage, setting, job, folder) +
         (stage == Stage::merge ? merge_script(job, folder)
                                : part_script(stage, job, folder.count(stage)));
}

std::string shell_quoted(const std::string& word) {
  constexpr const char* plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./:=,+@%";
  if (!word.empty() && word.find_first_not_of(plain) == word.npos) {
    return word;
  }
  std::string text = "'";
  for (const char c : word) {
    text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return text + "'";
}

std::string number_ranges(const std::vector<std::int64_t>& numbers) {
  std::vector<std::string> ranges;
  for (std::size_t first = 0; first < numbers.size();) {
    std::size_t last = first;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) {
      ++last;
    }
    ranges.push_back(last == first ? fmt::format("{}", numbers[first])
                                   : fmt::format("{}-{}", numbers[first], numbers[last]));
    first = last + 1;
  }
  return fmt::format("{}", fmt::join(ranges, ","));
}

}  // namespace foveola
