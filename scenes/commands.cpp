#include "scenes/commands.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "renderer/base/text/print.h"
#include "renderer/base/text/similar_word.h"
#include "renderer/base/text/utf8.h"
#include "renderer/base/transformed.h"
#include "renderer/base/work/work_scope.h"
#include "scenes/builtin.h"
#include "scenes/descriptor.h"
#include "scenes/descriptor_search.h"
#include "scenes/fetch.h"
#include "scenes/file_search.h"

namespace fs = std::filesystem;

namespace foveola::scenes {
namespace {

void warn(const std::string& text) { print_text(stderr, "foveola: warning: {}\n", text); }

/// Availability of a scene, and its file.
struct State {
  const char* word;  ///< "built-in", "real", "own", "another file", "unreadable" or "missing"
  std::string file;  ///< empty if there is none
  std::vector<std::string>
      obstacles;  ///< reasons why a missing file may be unfindable: see FileSearch
};

/// Finds the file of a user's descriptor, which is in its folder.
FileSearch search_own_folder(const Descriptor& descriptor) {
  fs::path file = descriptor.path.parent_path() / descriptor.file_name;
  std::error_code missing;
  return fs::exists(file, missing) ? FileSearch{.file = std::move(file)} : FileSearch{};
}

State state_of(const Descriptor& descriptor) {
  if (descriptor.is_builtin) {
    return {"built-in", builtin_file(descriptor.name).string(), {}};
  }
  const bool is_own = !is_programs_own(descriptor);
  FileSearch search =
      is_own ? search_own_folder(descriptor) : search_scene_path(descriptor.file_name);
  if (!search.file) {
    return {"missing", {}, std::move(search.obstacles)};
  }
  try {
    const bool is_described = is_described_file(descriptor, *search.file);
    const char* const word = is_own ? "own" : "real";
    return {is_described ? word : "another file", search.file->string(), {}};
  } catch (const Error&) {
    return {"unreadable", search.file->string(), {}};
  }
}

struct ListedScene {
  Descriptor descriptor;
  State state;
};

nlohmann::ordered_json json_of(const ListedScene& scene) {
  const Descriptor& descriptor = scene.descriptor;
  return {{"name", descriptor.name},     {"title", descriptor.source.title},
          {"author", descriptor.author}, {"licence", descriptor.licence},
          {"origin", descriptor.origin}, {"counterpart", descriptor.counterpart},
          {"state", scene.state.word},   {"file", scene.state.file}};
}

void list_as_json(const std::vector<ListedScene>& scenes) {
  const nlohmann::ordered_json list(
      transformed(scenes, [&](const ListedScene& scene) { return json_of(scene); }));
  print_text("{}\n", list.dump(2));
}

std::string origin_of(const Descriptor& descriptor) {
  return is_programs_own(descriptor) ? descriptor.origin
                                     : "belongs into " + descriptor.path.parent_path().string();
}

/// Describes the file's place on one line; empty if there is nothing to say.
std::string place_of(const Descriptor& descriptor, const State& state) {
  std::string place = state.file.empty()
                          ? fmt::format("{}: {}", descriptor.file_name, origin_of(descriptor))
                          : state.file;
  if (!descriptor.counterpart.empty()) {
    place += fmt::format(" (built-in counterpart: {})", descriptor.counterpart);
  }
  return place;
}

std::string terms_of(const Descriptor& descriptor) {
  std::string terms;
  if (!descriptor.author.empty()) {
    terms += ", by " + printable(descriptor.author);
  }
  if (!descriptor.licence.empty()) {
    terms += ". Licence: " + printable(descriptor.licence);
  }
  return terms;
}

void list_as_text(const std::vector<ListedScene>& scenes) {
  for (const auto& [descriptor, state] : scenes) {
    print_text("{:<14} {:<13} {}{}\n", descriptor.name, state.word,
               printable(descriptor.source.title), terms_of(descriptor));
    print_text("{:<28} {}\n", "", place_of(descriptor, state));
  }
}

/// Missing scenes may be in unreadable folders; one folder can hide several.
void warn_of_obstacles(const std::vector<ListedScene>& scenes) {
  std::set<std::string> obstacles;
  for (const ListedScene& scene : scenes) {
    obstacles.insert(scene.state.obstacles.begin(), scene.state.obstacles.end());
  }
  for (const std::string& obstacle : obstacles) {
    warn(obstacle + "; mend it, or remove it from FOVEOLA_SCENE_PATH");
  }
}

/// Returns the program's and the user's descriptors, by name; of two with the same name, the
/// user's.
DescriptorList descriptors_in_force() {
  DescriptorList list = users_descriptors();
  const std::size_t users = list.descriptors.size();
  DescriptorList programs = all_descriptors();
  list.faults.insert(list.faults.end(), programs.faults.begin(), programs.faults.end());
  for (Descriptor& descriptor : programs.descriptors) {
    const auto end = list.descriptors.begin() + static_cast<std::ptrdiff_t>(users);
    if (std::none_of(list.descriptors.begin(), end,
                     [&](const Descriptor& own) { return own.name == descriptor.name; })) {
      list.descriptors.push_back(std::move(descriptor));
    }
  }
  std::ranges::sort(list.descriptors,
                    [](const Descriptor& a, const Descriptor& b) { return a.name < b.name; });
  return list;
}

void list_scenes(bool as_json) {
  DescriptorList list = descriptors_in_force();
  for (const std::string& fault : list.faults) {
    warn(fault);
  }
  std::vector<ListedScene> scenes;
  for (Descriptor& descriptor : list.descriptors) {
    State state = state_of(descriptor);
    scenes.push_back({std::move(descriptor), std::move(state)});
  }
  warn_of_obstacles(scenes);
  as_json ? list_as_json(scenes) : list_as_text(scenes);
}

void add_list(CLI::App& app) {
  const auto as_json = std::make_shared<bool>(false);
  CLI::App* command = app.add_subcommand(
      "list", "List the scenes known by name, and whether their files are available");
  command->add_flag("--json", *as_json, "Print the list as JSON");
  command->footer("Example: FOVEOLA_SCENE_PATH=~/scenes foveola scene list");
  command->callback([as_json] { list_scenes(*as_json); });
}

/// Returns the descriptor of a file, or of a name, the user's before the program's. Throws Error if
/// there is none with a file.
Descriptor real_scene(const std::string& name) {
  auto descriptor = lower_case_extension(name) == ".toml" ? std::optional(read_descriptor(name))
                                                          : find_users_descriptor(name);
  descriptor = descriptor ? std::move(descriptor) : find_descriptor(name);
  if (!descriptor) {
    throw Error(name, "is not a known scene",
                did_you_mean(name, known_scene_names(), "see 'foveola scene list'"));
  }
  if (descriptor->is_builtin) {
    throw Error(name, "is built in", "use it by its name");
  }
  return *descriptor;
}

/// Printed at once, also into a pipe: the download may take long.
void print_terms(const Descriptor& descriptor) {
  print_text("{}, by {}\nLicence: {}\nFrom: {}\n", descriptor.source.title, descriptor.author,
             descriptor.licence, descriptor.origin);
  std::fflush(stdout);
}

/// The command line of `fetch`, as typed.
struct FetchArguments {
  std::string name;
  std::string from;
  bool is_unverified = false;
};

void warn_of_another_file(const Descriptor& descriptor, const fs::path& file) {
  if (!is_described_file(descriptor, file)) {
    warn(fmt::format(
        "used as {} although it is not the described file; displays and records of it say so",
        descriptor.name));
  }
}

fs::path fetch(const Descriptor& descriptor, const FetchArguments& arguments,
               const std::stop_token& stop) {
  if (!arguments.from.empty()) {
    const fs::path file =
        fetch_from_disk(descriptor, arguments.from,
                        arguments.is_unverified ? Accept::any_glb : Accept::described_file);
    warn_of_another_file(descriptor, file);
    return file;
  }
  Progress progress("downloading " + descriptor.file_name);
  return fetch_from_web(descriptor, [&](double fraction) { progress.update(fraction); }, stop);
}

void add_fetch(CLI::App& app, const std::stop_token& stop) {
  const auto arguments = std::make_shared<FetchArguments>();
  CLI::App* command =
      app.add_subcommand("fetch", "Get the file of a scene that is not built in, and check it");
  command
      ->add_option("NAME", arguments->name,
                   "The scene, or its descriptor's file; see 'foveola scene list'")
      ->required();
  CLI::Option* from = command->add_option("--from", arguments->from,
                                          "A file or folder to copy it from, in place of the web");
  command
      ->add_flag("--unverified", arguments->is_unverified,
                 "Accept a .glb that is not the described file, such as a conversion of your own")
      ->needs(from);
  command->footer("Example: foveola scene fetch sponza --from my-sponza.glb --unverified");
  command->callback([arguments, stop] {
    const Descriptor descriptor = real_scene(arguments->name);
    print_terms(descriptor);
    print_text("{}\n", fetch(descriptor, *arguments, stop).string());
  });
}

}  // namespace

CLI::App& add_scene_commands(CLI::App& app, std::stop_token stop) {
  CLI::App* scene = app.add_subcommand("scene", "List, download and inspect scenes");
  scene->require_subcommand(1);
  add_list(*scene);
  add_fetch(*scene, stop);
  return *scene;
}

}  // namespace foveola::scenes
