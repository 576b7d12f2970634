#include "renderer/commands/former_option.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace foveola {

void accept_former_name(CLI::App& command, CLI::Option& option, const std::string& former) {
  const auto take = [&option, former](const CLI::results_t& values) {
    fmt::print(stderr, "foveola: note: {} is now called {}\n", former, option.get_name());
    option.clear();
    for (const std::string& value : values) {
      option.add_result(value);
    }
    option.run_callback();
    return true;
  };
  command.add_option(former, take)
      ->type_size(option.get_type_size())
      ->expected(option.get_expected())
      ->group("");
}

}  // namespace foveola
