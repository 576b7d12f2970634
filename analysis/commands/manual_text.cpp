#include "analysis/commands/commands.h"

namespace foveola::analysis {
namespace {

ManualSection exit_status() {
  return {.title = "EXIT STATUS",
          .entries = {
              {"0",
               "The command succeeded, or a session that its experimenter ended "
               "before it was complete was recorded."},
              {"1",
               "Something that the user can mend was wrong: a file, a setting, a device, or a "
               "figure that bench was to hold and that is not met. One line on standard error "
               "states the place, the fault and the remedy."},
              {"2", "The command line is not valid. One line on standard error says why."},
              {"130",
               "The command was stopped by SIGINT (Ctrl+C), SIGTERM or SIGHUP. Finished work "
               "is kept. A second signal ends it at once."},
          }};
}

ManualSection environment() {
  return {
      .title = "ENVIRONMENT",
      .entries = {
          {"FOVEOLA_RESOURCES",
           "The folder that holds the protocols, scenes and data that come with Foveola, in place "
           "of share/foveola beside the program's folder."},
          {"FOVEOLA_SCENE_PATH",
           "Folders, separated by colons, that are searched for the files of real scenes, with "
           "one level of folders below them."},
          {"XDG_CACHE_HOME", "The folder of files that can be recreated, in place of ~/.cache."},
          {"XDG_DATA_HOME", "The folder of the user's own files, in place of ~/.local/share."},
          {"HOME", "The folder of both, if these two are not set."},
          {"TMPDIR", "The folder of temporary files, in place of /tmp."},
          {"PATH", "The folders that are searched for gnuplot, Rscript and cmake."},
          {"DISPLAY", "The X server on which windows are opened."},
          {"TERM", "The terminal in which study run shows the experimenter's console."},
          {"http_proxy, https_proxy, all_proxy, no_proxy",
           "The proxies of scene fetch's downloads; libcurl reads them."},
      }};
}

ManualSection files() {
  return {
      .title = "FILES",
      .entries = {
          {"~/.local/share/foveola/protocols/NAME.toml", "The user's own protocols, used by name."},
          {"~/.local/share/foveola/questionnaires/NAME.toml",
           "The user's own questionnaires, named by protocols."},
          {"~/.local/share/foveola/scenes",
           "The user's own scenes with their descriptors, and those that scene fetch downloaded."},
          {"~/.cache/foveola/scenes", "The built-in scenes, made when they are first used."},
          {"~/.cache/foveola/references, ~/.cache/foveola/pilots",
           "Finished images and pilots of scenes, which studies and benchmarks compare with or "
           "predict from. All of the cache may be removed at any time."},
      }};
}

ManualSection see_also() {
  return {.title = "SEE ALSO", .entries = {{"", "gnuplot(1), Rscript(1), sqlite3(1)"}}};
}

}  // namespace

ManualText manual_text() {
  return {
      .description =
          {"Foveola renders previews that follow the gaze: a progressive path tracer sends its "
           "samples where a person looks. It also has everything for a study of such previews: "
           "protocols, sessions with people or simulated participants, a durable record, and the "
           "statistics, tables and figures of the analysis.",
           "A SCENE is the name of a scene, as scene list prints them, or a .glb, .gltf or .obj "
           "file. A PROTOCOL is the name of a study's protocol, or a .toml file. A DB is the "
           "SQLite file "
           "of a study, written by study run or study simulate.",
           "Every command takes --help. Those with --json print their result for machines. Results "
           "go to standard output, progress, warnings and errors to standard error."},
      .sections = {exit_status(), environment(), files(), see_also()}};
}

}  // namespace foveola::analysis
