// Options and their values under the names that they had in earlier versions.
#pragma once

#include <map>
#include <string>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace foveola {

/// Lets `command` take what `option` takes under its former name too, which the help does not show
/// and whose use a note on standard error answers. former: with its dashes.
void accept_former_name(CLI::App& command, CLI::Option& option, const std::string& former);

/// Lets `option` take values under their former names too, with such a note.
void accept_former_values(CLI::Option& option, const std::map<std::string, std::string>& new_names);

}  // namespace foveola
