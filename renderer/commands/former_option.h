// Options under the names that they had in earlier versions.
#pragma once

#include <string>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace foveola {

/// Lets `command` take what `option` takes under its former name too, which the help does not show
/// and whose use a note on standard error answers. former: with its dashes.
void accept_former_name(CLI::App& command, CLI::Option& option, const std::string& former);

}  // namespace foveola
