#include "scenes/commands.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/digest.h"
#include "renderer/base/error.h"
#include "renderer/base/progress.h"
#include "scenes/builtin.h"
#include "scenes/descriptor.h"
#include "scenes/fetch.h"

namespace fs = std::filesystem;

namespace foveola::scenes {
namespace {

/// Where a scene stands: whether it can be used, and from which file.
struct State {
  const char* word;  ///< "built-in", "real" or "missing"
  std::string file;  ///< empty if missing
};

State state_of(const Descriptor& descriptor) {
  if (descriptor.is_builtin) {
    return {"built-in", cached_builtin(descriptor.name).string()};
  }
  const auto file = find_real_file(descriptor);
  return file ? State{"real", file->string()} : State{"missing", {}};
}

void list_as_json(const std::vector<Descriptor>& descriptors) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Descriptor& descriptor : descriptors) {
    const State state = state_of(descriptor);
    list.push_back({{"name", descriptor.name},
                    {"title", descriptor.source.title},
                    {"author", descriptor.author},
                    {"licence", descriptor.licence},
                    {"origin", descriptor.origin},
                    {"counterpart", descriptor.counterpart},
                    {"state", state.word},
                    {"file", state.file}});
  }
  fmt::print("{}\n", list.dump(2));
}

void list_as_text(const std::vector<Descriptor>& descriptors) {
  for (const Descriptor& descriptor : descriptors) {
    const State state = state_of(descriptor);
    fmt::print("{:<14} {:<9} {}, by {}. Licence: {}\n", descriptor.name, state.word,
               descriptor.source.title, descriptor.author, descriptor.licence);
    if (state.file.empty()) {
      fmt::print("{:<24} {}: {}\n", "", descriptor.file_name, descriptor.origin);
    } else {
      fmt::print("{:<24} {}\n", "", state.file);
    }
  }
}

void add_list(CLI::App& app) {
  const auto as_json = std::make_shared<bool>(false);
  CLI::App* command = app.add_subcommand("list", "The scenes known by name, and their state");
  command->add_flag("--json", *as_json, "Print the list as JSON");
  command->footer("Example: FOVEOLA_SCENE_PATH=~/scenes foveola scene list");
  command->callback([as_json] {
    const std::vector<Descriptor> descriptors = all_descriptors();
    *as_json ? list_as_json(descriptors) : list_as_text(descriptors);
  });
}

void make_scene(const std::string& name, const fs::path& file) {
  const auto start = std::chrono::steady_clock::now();
  const std::size_t triangles = write_builtin(name, file);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  fmt::print("{}  {} triangles  {:.2f} s  sha256 {}\n", file.string(), triangles, elapsed.count(),
             sha256_of_file(file));
}

void add_make(CLI::App& app, const std::stop_token& stop) {
  const auto names = std::make_shared<std::vector<std::string>>();
  const auto folder = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("make", "Make built-in scenes as .glb files");
  command->add_option("NAME", *names, "Which (default: all)")
      ->check(CLI::IsMember(builtin_names()));
  command->add_option("-o,--output", *folder, "The folder to put them in (default: the cache)");
  command->footer("Example: foveola scene make arcade -o scenes/");
  command->callback([names, folder, stop] {
    for (const std::string& name : names->empty() ? builtin_names() : *names) {
      if (stop.stop_requested()) {
        return;
      }
      make_scene(name,
                 folder->empty() ? cached_builtin(name) : fs::path(*folder) / (name + ".glb"));
    }
  });
}

/// Throws Error if there is none of that name that has a file.
Descriptor real_scene(const std::string& name) {
  const auto descriptor = find_descriptor(name);
  if (!descriptor) {
    throw Error(name, "no such scene", "see 'foveola scene list'");
  }
  if (descriptor->is_builtin) {
    throw Error(name, "is built in", fmt::format("make it with 'foveola scene make {}'", name));
  }
  return *descriptor;
}

void print_terms(const Descriptor& descriptor) {
  fmt::print("{}, by {}\nLicence: {}\nFrom: {}\n", descriptor.source.title, descriptor.author,
             descriptor.licence, descriptor.origin);
}

fs::path fetch(const Descriptor& descriptor, const std::string& from, const std::stop_token& stop) {
  if (!from.empty()) {
    return fetch_from_disk(descriptor, from);
  }
  Progress progress("downloading " + descriptor.file_name);
  return fetch_from_web(
      descriptor, [&](double fraction) { progress.update(fraction); }, stop);
}

void add_fetch(CLI::App& app, const std::stop_token& stop) {
  const auto name = std::make_shared<std::string>();
  const auto from = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("fetch", "Get a real scene's file, and check it");
  command->add_option("NAME", *name, "Which; see 'foveola scene list'")->required();
  command->add_option("--from", *from, "A file or folder to take it from, in place of the web");
  command->footer("Example: foveola scene fetch sponza --from ~/Downloads");
  command->callback([name, from, stop] {
    const Descriptor descriptor = real_scene(*name);
    print_terms(descriptor);
    fmt::print("{}\n", fetch(descriptor, *from, stop).string());
  });
}

}  // namespace

CLI::App& add_scene_commands(CLI::App& app, std::stop_token stop) {
  CLI::App* scene = app.add_subcommand("scene", "The scenes: what there is, and making it");
  scene->require_subcommand(1);
  add_list(*scene);
  add_make(*scene, stop);
  add_fetch(*scene, stop);
  return *scene;
}

}  // namespace foveola::scenes
