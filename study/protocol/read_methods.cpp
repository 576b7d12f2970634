#include "study/protocol/read_methods.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/confined_path.h"
#include "renderer/base/digest.h"
#include "renderer/base/error.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

/// Throws Error for a file out of the folder, for one that is no image of weights, and for one that
/// somebody writes at this moment.
MethodFile read_method_file(const std::string& method, const std::string& file,
                            const fs::path& folder) {
  fs::path path;
  try {
    path = confined_path(folder, file);
  } catch (const std::runtime_error& reason) {
    throw Error(fmt::format("method '{}'", method),
                fmt::format("its file '{}' is {}", file, reason.what()),
                "put a copy into the folder of the protocol");
  }
  const std::string digest = sha256_of_file(path);
  auto weights = std::make_shared<const WeightImage>(read_weights(path));
  if (sha256_of_file(path) != digest) {
    throw Error(path.string(), "changed while it was read", "try again when it is finished");
  }
  return {.method = method, .file = file, .sha256 = digest, .weights = std::move(weights)};
}

/// What is made of a protocol may take each of its methods and trials with each other.
void require_moderate_number(const TomlReader& reader, std::size_t scenes, std::size_t methods) {
  constexpr std::size_t most_methods = 100;
  constexpr std::size_t most_trials = 1000;
  if (methods > most_methods) {
    reader.fail(reader.source("methods"),
                fmt::format("{} methods, and a study has at most {}", methods, most_methods),
                "name fewer");
  }
  if (scenes * methods > most_trials) {
    reader.fail(
        reader.source("methods"),
        fmt::format("{} scenes with {} methods make {} trials, and a session has at most {}",
                    scenes, methods, scenes * methods, most_trials),
        "name fewer");
  }
}

void require_moderate_length(const TomlReader& reader, const TomlReader::Text& method) {
  constexpr std::size_t longest = 1000;
  if (method.value.size() > longest) {
    reader.fail(method.source,
                fmt::format("a method of {} characters, and the longest has {}",
                            method.value.size(), longest),
                "write it shorter, or paint it as the image of a mask");
  }
}

/// Throws Error for what no session could use.
void require_usable(const std::string& method, const fs::path& folder,
                    std::vector<MethodFile>& files) {
  if (follows_pointer(method)) {
    throw Error(fmt::format("method '{}'", method),
                "follows a pointer, which sessions do not have in this version",
                "hold it in place with azimuth= and elevation=, or choose another method");
  }
  make_view_sampler(method, [&](const std::string& file) {
    if (find_method_file(files, method, file) == nullptr) {
      files.push_back(read_method_file(method, file, folder));
    }
    return *find_method_file(files, method, file)->weights;
  });
}

}  // namespace

std::vector<SceneEntry> read_scenes(TomlReader& reader) {
  std::vector<SceneEntry> scenes;
  for (const TomlReader::Text& scene : reader.require_texts("scenes")) {
    scenes.push_back({.name = scene.value,
                      .line = static_cast<int>(scene.source.begin.line),
                      .column = static_cast<int>(scene.source.begin.column)});
  }
  return scenes;
}

const MethodFile* find_method_file(const std::vector<MethodFile>& files, const std::string& method,
                                   const std::string& file) {
  const auto found = std::find_if(files.begin(), files.end(), [&](const MethodFile& known) {
    return known.method == method && known.file == file;
  });
  return found != files.end() ? &*found : nullptr;
}

void read_methods(TomlReader& reader, Protocol& protocol) {
  const std::vector<TomlReader::Text> methods = reader.require_texts("methods");
  require_moderate_number(reader, protocol.scenes.size(), methods.size());
  for (const TomlReader::Text& method : methods) {
    require_moderate_length(reader, method);
    try {
      require_usable(method.value, folder_of(protocol), protocol.method_files);
    } catch (const Error& error) {
      reader.fail(method.source, error.what(), "see foveola render --help");
    }
    protocol.methods.push_back(method.value);
  }
}

}  // namespace foveola::study
