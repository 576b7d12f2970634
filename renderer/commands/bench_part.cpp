#include "renderer/commands/bench_part.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "renderer/base/build_info.h"
#include "renderer/base/digest.h"
#include "renderer/base/files.h"
#include "renderer/base/print.h"

namespace foveola {
namespace {

/// The convergence of some ten thousand renders; read, it takes about ten times this memory.
constexpr std::size_t most_bytes = std::size_t{1} << 27;
/// Values inside each other, of which the deepest parts have about ten: more would fill the stack.
constexpr int most_depth = 32;

constexpr const char* format_key = "foveola_bench_part";
constexpr int format_version = 1;

/// Whatever a path or a name may hold that is no UTF-8 is replaced.
std::string dumped(const nlohmann::json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string digest_of(const nlohmann::json& results) {
  return sha256(std::string_view(dumped(results)));
}

nlohmann::json parsed(const std::string& text) {
  return nlohmann::json::parse(text,
                               [](int depth, nlohmann::json::parse_event_t, const nlohmann::json&) {
                                 if (depth > most_depth) {
                                   throw std::out_of_range("nested too deeply");
                                 }
                                 return true;
                               });
}

/// A part and the program that measured it.
struct SignedPart {
  BenchPart part;
  std::string program;
};

SignedPart read_signed(const std::filesystem::path& file) {
  const std::string text = read_file(file, most_bytes, "split the benchmark into more parts");
  SignedPart read;
  std::string digest;
  try {
    nlohmann::json json = parsed(text);
    if (json.at(format_key) != format_version || !json.at("settings").is_object()) {
      throw std::invalid_argument("of another format");
    }
    read.program = json.at("program").get<std::string>();
    digest = json.at("results_sha256").get<std::string>();
    read.part = {.command = json.at("command").get<std::string>(),
                 .shard = parse_shard("shard", json.at("shard").get<std::string>()),
                 .settings = std::move(json.at("settings")),
                 .results = std::move(json.at("results")),
                 .file = file};
  } catch (const std::exception&) {
    throw Error(file.string(), "is no part of a benchmark, or damaged",
                "name files that foveola bench has written with --shard");
  }
  if (digest_of(read.part.results) != digest) {
    throw Error(file.string(), "is damaged", "measure this part again");
  }
  return read;
}

std::string value_of(const nlohmann::json& settings, const std::string& name) {
  constexpr std::size_t most_letters = 60;
  const auto found = settings.find(name);
  return found == settings.end() ? "absent" : fmt::format("{:.{}}", dumped(*found), most_letters);
}

/// "seed is 2, not 1"; empty if nothing differs.
std::string difference(const nlohmann::json& settings, const nlohmann::json& wanted) {
  for (const nlohmann::json* one : {&wanted, &settings}) {
    for (const auto& item : one->items()) {
      const std::string& name = item.key();
      if (!settings.contains(name) || !wanted.contains(name) ||
          settings.at(name) != wanted.at(name)) {
        return fmt::format("{} is {}, not {}", name, value_of(settings, name),
                           value_of(wanted, name));
      }
    }
  }
  return {};
}

/// Throws Error unless `part` is of the same benchmark as `first`, by this program.
void require_same(const SignedPart& part, const BenchPart& first) {
  const std::string where = part.part.file.string();
  const std::string like = first.file.string();
  if (const std::string own = exact_name(build_info()); part.program != own) {
    throw Error(where, fmt::format("was measured by {}, not by {}", part.program, own),
                "merge with the program that measured all parts, on such a machine");
  }
  if (part.part.command != first.command) {
    throw Error(
        where,
        fmt::format("is of bench {}, but {} of bench {}", part.part.command, like, first.command),
        "merge the parts of one benchmark");
  }
  if (const std::string other = difference(part.part.settings, first.settings); !other.empty()) {
    throw Error(where, fmt::format("is of another benchmark than {}: {}", like, other),
                "merge the parts of one benchmark");
  }
  if (part.part.shard.count != first.shard.count) {
    throw Error(where,
                fmt::format("is part {} of a benchmark that {} is part {} of",
                            text_of(part.part.shard), like, text_of(first.shard)),
                "merge parts of one split");
  }
}

/// parts: in the order of their numbers.
void require_each_once(const std::vector<BenchPart>& parts) {
  const auto fault = [&](std::int64_t number, const char* what) {
    return Error(
        "bench merge",
        fmt::format("part {} is {}", text_of(Shard{number, parts.front().shard.count}), what),
        "name each part once");
  };
  std::int64_t next = 1;
  for (const BenchPart& part : parts) {
    if (part.shard.number < next) {
      throw fault(part.shard.number, "there more than once");
    }
    if (part.shard.number > next) {
      throw fault(next, "missing");
    }
    ++next;
  }
  if (next <= parts.front().shard.count) {
    throw fault(next, "missing");
  }
}

}  // namespace

void write_bench_part(const std::filesystem::path& path, const BenchPart& part) {
  const nlohmann::json json = {{format_key, format_version},
                               {"command", part.command},
                               {"program", exact_name(build_info())},
                               {"shard", text_of(part.shard)},
                               {"settings", part.settings},
                               {"results", part.results},
                               {"results_sha256", digest_of(part.results)}};
  write_file(path, dumped(json) + "\n");
}

std::vector<BenchPart> read_whole_bench(const std::vector<std::filesystem::path>& files) {
  std::vector<BenchPart> parts;
  parts.reserve(files.size());
  for (const std::filesystem::path& file : files) {
    SignedPart read = read_signed(file);
    require_same(read, parts.empty() ? read.part : parts.front());
    parts.push_back(std::move(read.part));
  }
  std::ranges::sort(parts, {}, [](const BenchPart& part) { return part.shard.number; });
  require_each_once(parts);
  return parts;
}

std::uint64_t whole_number(const nlohmann::json& json, std::uint64_t most) {
  const bool is_whole =
      json.is_number_unsigned() || (json.is_number_integer() && json.get<std::int64_t>() >= 0);
  if (!is_whole || json.get<std::uint64_t>() > most) {
    throw std::out_of_range("no such number");
  }
  return json.get<std::uint64_t>();
}

CLI::Option* add_shard_option(CLI::App& command, std::string& shard) {
  return command
      .add_option("--shard", shard,
                  "Measure only the Kth of N parts, as K/N, into the file of --output; foveola "
                  "bench merge makes of all parts what one command would have printed")
      ->group("Parts");
}

void add_bench_part_options(CLI::App& command, BenchPartArguments& arguments) {
  CLI::Option* const shard = add_shard_option(command, arguments.shard);
  CLI::Option* const output =
      command.add_option("-o,--output", arguments.output, "The file of a part, a .json")
          ->needs(shard)
          ->group("Parts");
  shard->needs(output);
}

std::optional<Shard> shard_of(const BenchPartArguments& arguments) {
  if (arguments.shard.empty()) {
    return std::nullopt;
  }
  const Shard shard = parse_shard("--shard", arguments.shard);
  require_writable(arguments.output);
  return shard;
}

void print_written(const std::filesystem::path& path, const BenchPart& part, bool as_json) {
  if (as_json) {
    const nlohmann::json json = {{"output", path.string()}, {"shard", text_of(part.shard)}};
    print_text("{}\n", json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  } else {
    print_text("{}: part {} of bench {}\n", path.string(), text_of(part.shard), part.command);
  }
}

void require_finished(const std::filesystem::path& path, bool is_stopped) {
  if (is_stopped) {
    throw Error(path.string(), "is not written: the part was stopped before its end",
                "measure it again");
  }
}

}  // namespace foveola
