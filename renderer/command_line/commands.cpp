#include "renderer/command_line/commands.h"

#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "renderer/base/build_info.h"
#include "renderer/base/text/print.h"
#include "renderer/command_line/completion.h"

namespace foveola {
namespace {

void add_manual(CLI::App& app, const ManualText& text) {
  CLI::App* command = app.add_subcommand("manual", "Print the manual page, for man");
  command->footer("Example: foveola manual > foveola.1 && man -l foveola.1");
  command->callback(
      [&app, text] { print_text("{}", manual_page(describe(app), build_info().version, text)); });
}

void add_completion(CLI::App& app) {
  const auto shell = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand(
      "completion", "Print a script by which a shell completes commands, options and values");
  command->add_option("SHELL", *shell, "The shell that reads it")
      ->check(CLI::IsMember({"bash", "zsh", "fish"}))
      ->required();
  command->footer(
      "Examples: source <(foveola completion bash)\n"
      "          foveola completion fish > ~/.config/fish/completions/foveola.fish");
  command->callback([&app, shell] { print_text("{}", completion_script(*shell, app.get_name())); });
}

}  // namespace

void add_command_line_commands(CLI::App& app, const ManualText& text) {
  add_manual(app, text);
  add_completion(app);
}

}  // namespace foveola
