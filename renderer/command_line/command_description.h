// The command line's description as a value, from which manuals and completions are made.
#pragma once

#include <string>
#include <vector>

#include "renderer/command_line/cli_fwd.h"

namespace foveola {

/// An option, or a positional argument.
struct OptionDescription {
  std::vector<std::string> names;    ///< {"-o", "--output"}; of a positional, {"SCENE"}
  std::string value_name;            ///< "TEXT", "INT"; empty if it takes no value
  bool takes_number = false;         ///< its value is a number, and so neither a file nor a word
  bool takes_many = false;           ///< any number of values
  std::vector<std::string> choices;  ///< the only accepted values; empty: not listed
  std::string limits;                ///< of a number: "1 to 1000"; empty: not stated
  std::string default_value;         ///< as typed; empty: not stated
  bool is_required = false;
  std::vector<std::string> needs;     ///< names of options that it requires
  std::vector<std::string> excludes;  ///< names of options that it excludes
  std::string group;                  ///< its heading in help; empty: only "Options"
  std::string description;

  bool operator==(const OptionDescription&) const = default;
};

struct CommandDescription {
  std::string name;
  std::string description;
  std::vector<OptionDescription> positionals;
  std::vector<OptionDescription> options;
  std::vector<CommandDescription> commands;
  std::string footer;  ///< an example
};

/// The description of `app` and its commands, in the order of their help, without items that help
/// leaves out: options and commands in no group, such as names of earlier versions. Choices and
/// limits are those in validators' texts, as of CLI::IsMember and CLI::Range.
CommandDescription describe(const CLI::App& app);

/// Whether its value may be a file: neither a number nor one of a few words.
bool may_take_file(const OptionDescription& option);

}  // namespace foveola
