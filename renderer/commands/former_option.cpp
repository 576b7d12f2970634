#include "renderer/commands/former_option.h"

#include <CLI/CLI.hpp>

#include "renderer/base/print.h"

namespace foveola {

void accept_former_name(CLI::App& command, CLI::Option& option, const std::string& former) {
  const auto take = [&option, former](const CLI::results_t& values) {
    print_text(stderr, "foveola: note: {} is now called {}\n", former, option.get_name());
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

void accept_former_values(CLI::Option& option,
                          const std::map<std::string, std::string>& new_names) {
  option.transform([&option, new_names](const std::string& value) {
    const auto found = new_names.find(value);
    if (found == new_names.end()) {
      return value;
    }
    print_text(stderr, "foveola: note: {} {} is now called {}\n", option.get_name(), value,
               found->second);
    return found->second;
  });
}

}  // namespace foveola
