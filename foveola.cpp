// The program: the one place that puts the commands of all modules together.
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <memory>
#include <stop_token>
#include <string_view>
#include <system_error>
#include <thread>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "analysis/commands/commands.h"
#include "analysis/publication/analyze_study.h"
#include "analysis/publication/exports/output_folder.h"
#include "analysis/publication/report/published_comparison_report.h"
#include "renderer/base/build_info.h"
#include "renderer/base/error.h"
#include "renderer/base/files/file_access.h"
#include "renderer/base/files/files.h"
#include "renderer/base/text/print.h"
#include "renderer/base/text/utf8.h"
#include "renderer/base/work/work_scope.h"
#include "renderer/command_line/commands.h"
#include "renderer/command_line/completion.h"
#include "renderer/command_line/output_options.h"
#include "renderer/commands/bench/bench_commands.h"
#include "renderer/commands/commands.h"
#include "renderer/commands/typed_command.h"
#include "scenes/builtin.h"
#include "scenes/commands.h"
#include "scenes/descriptor_text.h"
#include "scenes/find_scene.h"
#include "study/commands/commands.h"
#include "study/record/sqlite/database.h"
#include "study/simulation/simulate_study.h"

namespace fs = std::filesystem;

namespace foveola {
namespace {

/// Turns the first SIGINT, SIGTERM or SIGHUP (the terminal was closed) into a request to stop, so
/// that running work ends by itself and loses nothing; the second ends the program at once. Made
/// before any other thread, which then inherits the blocked signals.
class SignalStop {
 public:
  SignalStop() {
    ::sigemptyset(&signals_);
    ::sigaddset(&signals_, SIGINT);
    ::sigaddset(&signals_, SIGTERM);
    if (!is_ignored(SIGHUP)) {
      ::sigaddset(&signals_, SIGHUP);
    }
    ::pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
    waiter_ = std::jthread([this](const std::stop_token& done) { wait(done); });
  }
  ~SignalStop() {
    waiter_.request_stop();
    ::pthread_kill(waiter_.native_handle(), SIGTERM);  // Wakes the waiting thread.
  }
  SignalStop(const SignalStop&) = delete;
  SignalStop& operator=(const SignalStop&) = delete;

  std::stop_token token() const { return stop_.get_token(); }

 private:
  /// nohup asks for it.
  static bool is_ignored(int signal) {
    struct sigaction action{};
    return ::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
  }

  void wait(const std::stop_token& done) {
    for (;;) {
      const int signal = ::sigwaitinfo(&signals_, nullptr);
      if (done.stop_requested()) {
        return;
      }
      if (signal > 0 && !stop_.request_stop()) {
        std::_Exit(stopped_exit_code);
      }
    }
  }

  sigset_t signals_{};
  std::stop_source stop_;
  std::jthread waiter_;
};

/// The first of NAME-1, NAME-2, ... under `parent` that does not exist: a demo overwrites nothing.
fs::path new_folder(const fs::path& parent, const std::string& name) {
  for (int i = 1;; ++i) {
    const fs::path folder = parent / fmt::format("{}-{}", name, i);
    if (fs::create_directories(folder)) {
      return folder;
    }
  }
}

void run_demo(const fs::path& parent, int participants, const std::stop_token& stop) {
  require_writable(parent / "foveola-demo");
  const fs::path folder = new_folder(parent, "foveola-demo");
  const fs::path database = folder / "study.sqlite";
  print_text("Simulating a small study on built-in scenes with {} participants.\n", participants);
  const study::SimulateReport simulated =
      study::simulate_study({.protocol = resource_folder() / "protocols" / "demo.toml",
                             .database = database,
                             .participants = participants,
                             .seed = 2018,
                             .threads = 0},
                            scenes::find_scene_beside, stop);
  if (stop.stop_requested()) {
    print_text("Stopped. The sessions recorded so far are in {}\n", database.string());
    return;
  }
  const analysis::AnalysisOutput analysed = analysis::analyze_study(database, folder / "analysis");
  print_text(
      "{}\n{} trials, simulated in {}, took the participants {} of virtual time.\n"
      "Database  {}\nReport    {}\n",
      analysed.summary, simulated.trials, human_duration(simulated.wall_s),
      human_duration(simulated.simulated_s), database.string(), analysed.report.string());
}

void add_demo(CLI::App& app, const std::stop_token& stop) {
  const auto parent = std::make_shared<std::string>(".");
  const auto participants = std::make_shared<int>(4);
  CLI::App* command =
      app.add_subcommand("demo", "Simulate a small study and analyse it, from scenes to a report");
  command->add_option("-o,--output", *parent,
                      "The folder in which to make foveola-demo-1 (or the next free number)");
  command->add_option("--participants", *participants, "Number of simulated participants")
      ->check(CLI::Range(1, 1000));
  command->footer("Example: foveola demo");
  command->callback([parent, participants, stop] { run_demo(*parent, *participants, stop); });
}

/// Returns the scene. Throws OutputIsInput if an output is its file or its environment's.
SceneSource apart_from_outputs(SceneSource scene) {
  require_no_output(scene.file);
  if (scene.environment_file) {
    require_no_output(*scene.environment_file);
  }
  return scene;
}

constexpr int user_error = 1;
constexpr int usage_error = 2;

int complain(const std::string& message, int exit_code) {
  print_text(stderr, "foveola: error: {}\n", printable(message));
  return exit_code;
}

int run(int argc, char** argv) {
  // A file that may not grow is then an error like that of a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  const SignalStop signals;
  study::keep_no_memory_counts();
  CLI::App app("A laboratory for foveated previews: renderer, user study, statistics.", "foveola");
  app.set_version_flag("--version", "foveola " + build_info().version + " (computing with " +
                                        build_info().instruction_set + ")");
  app.require_subcommand(1);
  app.parse_complete_callback([&] { keep_outputs_apart(app); });
  const SceneFinder find_scene = [](const std::string& name) {
    return apart_from_outputs(scenes::find_scene(name));
  };
  const SceneFinderBeside find_scene_beside = [](const std::string& name, const fs::path& folder) {
    return apart_from_outputs(scenes::find_scene_beside(name, folder));
  };
  add_demo(app, signals.token());
  add_render(app, find_scene, signals.token());
  add_merge_images(app);
  add_compare(app);
  add_preview(app, find_scene, signals.token());
  CLI::App& bench = add_bench_commands(app, scenes::builtin_names(), find_scene, signals.token());
  analysis::add_bench_convergence(bench, find_scene, signals.token());
  analysis::add_bench_calibration(bench, find_scene_beside, signals.token());
  analysis::add_bench_compare(bench);
  study::add_bench_prediction(bench, find_scene_beside, signals.token());
  study::add_bench_sensitivity(bench, find_scene_beside, signals.token());
  analysis::add_bench_statistics(bench, signals.token());
  CLI::App& scene = scenes::add_scene_commands(app, signals.token());
  add_scene_describe(scene, scenes::descriptor_text, signals.token());
  add_scene_info(scene, find_scene, signals.token());
  add_scene_pick(scene, find_scene, signals.token());
  add_scene_sheet(scene, scenes::builtin_names(), find_scene, signals.token());
  add_tracker_commands(app, signals.token());
  study::add_study_commands(
      app, find_scene_beside,
      {.check = analysis::check_output_folder, .write = analysis::report_published_comparison},
      signals.token());
  analysis::add_analysis_commands(app, signals.token());
  analysis::add_replicate(app, signals.token());
  add_command_line_commands(app, analysis::manual_text());
  if (argc > 2 && argv[1] == std::string_view(complete_command)) {
    print_text("{}", completions(describe(app), {argv + 2, argv + argc}));
    return EXIT_SUCCESS;
  }
  try {
    complete_options(app);
    reject_unknown_commands(app, {argv + 1, argv + argc});
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return complain(fault_text(app, error), usage_error);
  } catch (const UsageError& error) {
    return complain(error.what(), usage_error);
  } catch (const WorkStopped&) {
    print_load_stopped();
    return stopped_exit_code;
  } catch (const Error& error) {
    const bool stopped = signals.token().stop_requested();
    return complain(error.what(), stopped ? stopped_exit_code : user_error);
  } catch (const fs::filesystem_error& error) {
    const std::string to = error.path2().empty() ? "" : " -> " + error.path2().string();
    return complain(error.path1().string() + to + ": " + error.code().message(), user_error);
  } catch (const std::bad_alloc&) {
    return complain("not enough memory; try a smaller image or scene", user_error);
  } catch (const std::system_error& error) {
    return complain(error.what(), user_error);
  } catch (const std::exception& error) {
    return complain(std::string("this is a fault in Foveola: ") + error.what(), user_error);
  }
  return signals.token().stop_requested() ? stopped_exit_code : EXIT_SUCCESS;
}

/// The exit code of a command that ended with `exit_code`, once all that it printed is written.
int finish(int exit_code) {
  try {
    finish_printing();
  } catch (const Error& error) {
    return exit_code == EXIT_SUCCESS ? complain(error.what(), user_error) : exit_code;
  }
  return exit_code;
}

}  // namespace
}  // namespace foveola

int main(int argc, char** argv) {
  foveola::hold_closed_streams();
  return foveola::finish(foveola::run(argc, argv));
}
