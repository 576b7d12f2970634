// What the command line says of itself, as a value: what manuals and completions are made from.
#pragma once

#include <string>
#include <vector>

#include "renderer/command_line/cli_fwd.h"

namespace foveola {

/// An option, or a positional argument.
struct OptionDescription {
  std::vector<std::string> names;    ///< {"-o", "--output"}; of a positional, {"SCENE"}
  std::string value_name;            ///< "TEXT", "INT"; empty if it takes no value
  bool takes_number = false;         ///< its value is a number, so neither a file nor a word
  bool takes_many = false;           ///< any number of values
  std::vector<std::string> choices;  ///< the only values that it accepts; empty: not listed
  std::string limits;                ///< of a number: "1 to 1000"; empty: none stated
  std::string default_value;         ///< as typed; empty: none stated
  bool is_required = false;
  std::vector<std::string> needs;     ///< names of options without which it is an error
  std::vector<std::string> excludes;  ///< names of options with which it is an error
  std::string group;                  ///< the title that help has above it; empty: only "Options"
  std::string description;

  bool operator==(const OptionDescription&) const = default;
};

struct CommandDescription {
  std::string name;
  std::string description;
  std::vector<OptionDescription> positionals;
  std::vector<OptionDescription> options;
  std::vector<CommandDescription> commands;
  std::string footer;  ///< its example
};

/// What `app` and its commands say of themselves, in the order of their help, without what help
/// leaves out: options and commands in no group, such as names of earlier versions. Choices and
/// limits are those that validators state as CLI::IsMember and CLI::Range do.
CommandDescription describe(const CLI::App& app);

/// Whether its value may be a file: it has one that is neither a number nor one of a few words.
bool may_take_file(const OptionDescription& option);

}  // namespace foveola
