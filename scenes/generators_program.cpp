#include "scenes/generators_program.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include "renderer/base/cores.h"
#include "renderer/base/error.h"
#include "renderer/base/print.h"
#include "renderer/base/programs.h"
#include "scenes/generators_digest.h"

namespace fs = std::filesystem;

namespace foveola::scenes {
namespace {

constexpr const char* program_name = "foveola-scenes";

bool is_of_foveola(std::ifstream& cmake_cache) {
  for (std::string line; std::getline(cmake_cache, line);) {
    if (line == "CMAKE_PROJECT_NAME:STATIC=foveola") {
      return true;
    }
  }
  return false;
}

/// The folder that CMake built `program` in, if it lies in one.
std::optional<fs::path> build_folder_around(const fs::path& program) {
  for (fs::path folder = program.parent_path(); folder.has_relative_path();
       folder = folder.parent_path()) {
    if (std::ifstream cache(folder / "CMakeCache.txt"); cache) {
      return is_of_foveola(cache) ? std::optional(folder) : std::nullopt;
    }
  }
  return std::nullopt;
}

/// Where foveola-scenes is, or is to be built.
struct Place {
  fs::path program;
  std::optional<fs::path> build_folder;  ///< none: it was installed
};

Place place_for(const fs::path& laboratory) {
  const fs::path prefix = installation_prefix().value_or(laboratory.parent_path().parent_path());
  const fs::path installed = prefix / FOVEOLA_GENERATORS_IN_PREFIX / program_name;
  const std::optional<fs::path> build_folder = build_folder_around(laboratory);
  std::error_code missing;
  if (!build_folder || fs::exists(installed, missing)) {
    return {installed, std::nullopt};
  }
  return {*build_folder / "scenes" / program_name, build_folder};
}

/// While it lives, neither another laboratory nor the front door builds in the folder.
class BuildLock {
 public:
  /// Waits for it. The builder inherits the descriptor, and with it the lock if we are killed.
  explicit BuildLock(const fs::path& build_folder) {
    constexpr mode_t readable_by_all = 0644;
    descriptor_ = ::open((build_folder / ".lock").c_str(), O_RDONLY | O_CREAT, readable_by_all);
    if (descriptor_ < 0) {
      throw Error(build_folder.string(),
                  "the generators of the built-in scenes cannot be built here: " +
                      std::generic_category().message(errno),
                  fmt::format("let its owner run 'cmake --build {} --target {}'",
                              build_folder.string(), program_name));
    }
    while (::flock(descriptor_, LOCK_EX) != 0 && errno == EINTR) {
    }
  }
  ~BuildLock() { ::close(descriptor_); }
  BuildLock(const BuildLock&) = delete;
  BuildLock& operator=(const BuildLock&) = delete;

 private:
  int descriptor_ = -1;
};

/// The end of what was printed, from the beginning of a line.
std::string_view last_lines(std::string_view text) {
  constexpr std::size_t shown_bytes = 4000;
  if (text.size() > shown_bytes) {
    text.remove_prefix(text.size() - shown_bytes);
    text.remove_prefix(text.find('\n') + 1);
  }
  return text;
}

ProgramEnd end_of_build(const fs::path& build_folder) {
  try {
    return run_to_end({.words = {"cmake", "--build", build_folder.string(), "--parallel",
                                 fmt::to_string(usable_cores()), "--target", program_name},
                       .on_interrupt = OnInterrupt::ends});
  } catch (const std::system_error& failure) {
    throw Error("cmake",
                "cannot be started, and is to build the generators of the built-in scenes: " +
                    failure.code().message(),
                "install it: apt-get install cmake");
  }
}

void build_program(const fs::path& build_folder) {
  print_text(stderr, "foveola: building the generators of the built-in scenes, once\n");
  const BuildLock lock(build_folder);
  const ProgramEnd end = end_of_build(build_folder);
  if (end.status != 0) {
    print_text(stderr, "{}{}", last_lines(end.output), last_lines(end.errors));
    throw Error(build_folder.string(),
                fmt::format("building {} ended with {}", program_name, failure_named(end.status)),
                WIFSIGNALED(end.status) ? "try again" : "see above; mend it and try again");
  }
}

/// The program prints how many triangles and bytes there are, and on the next line the bytes.
GeneratedScene scene_in(const std::string& output, const fs::path& program) {
  const std::size_t end_of_line = output.find('\n');
  std::istringstream numbers(output.substr(0, end_of_line));
  GeneratedScene scene;
  std::size_t bytes = 0;
  if (!(numbers >> scene.triangles >> bytes) || end_of_line == std::string::npos ||
      output.size() - end_of_line - 1 != bytes) {
    throw Error(program.string(), "printed no whole scene", "install or build Foveola again");
  }
  scene.glb = output.substr(end_of_line + 1);
  return scene;
}

bool is_refusal(int status) {
  return WIFEXITED(status) && WEXITSTATUS(status) == refusal_exit_code;
}

[[noreturn]] void fail(const std::string& name, const ProgramEnd& end) {
  const std::string reason = end.errors.substr(0, end.errors.find('\n'));
  throw Error(name,
              fmt::format("the program that makes it ended with {}{}{}", failure_named(end.status),
                          reason.empty() ? "" : ": ", reason),
              "check that there is enough memory, and try again");
}

/// A scene, or why the program that is there can make none.
struct Attempt {
  std::optional<GeneratedScene> scene;
  std::string obstacle;
};

Attempt attempt(const fs::path& program, const std::string& name, std::uint32_t seed) {
  ProgramEnd end;
  try {
    end =
        run_to_end({.words = {program.string(), generators_digest(), name, fmt::to_string(seed)}});
  } catch (const std::system_error& failure) {
    return {std::nullopt,
            "makes the built-in scenes, but cannot be started: " + failure.code().message()};
  }
  if (is_refusal(end.status)) {
    return {std::nullopt, "was built from other sources than this program: its scenes are others"};
  }
  if (end.status != 0) {
    fail(name, end);
  }
  return {scene_in(end.output, program), {}};
}

}  // namespace

GeneratedScene generate_scene(const std::string& name, std::uint32_t seed) {
  const Place place = place_for(own_program());
  Attempt made = attempt(place.program, name, seed);
  if (!made.scene && place.build_folder) {
    build_program(*place.build_folder);
    made = attempt(place.program, name, seed);
  }
  if (!made.scene) {
    throw Error(place.program.string(), made.obstacle,
                place.build_folder ? fmt::format("build both: cmake --build {} --target foveola {}",
                                                 place.build_folder->string(), program_name)
                                   : "install Foveola again");
  }
  return *std::move(made.scene);
}

}  // namespace foveola::scenes
