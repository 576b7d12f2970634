#include "scenes/builtin_files.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "renderer/base/cache.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "scenes/generators_digest.h"
#include "scenes/generators_program.h"

namespace fs = std::filesystem;

namespace foveola::scenes {
namespace {

fs::path cached_scenes() { return cache_folder() / "scenes"; }

void prepare_folder(const fs::path& folder) {
  std::error_code failure;
  if (!folder.empty()) {
    fs::create_directories(folder, failure);
  }
  if (failure) {
    throw Error(folder.string(), "cannot be made: " + failure.message(), "choose another folder");
  }
}

void prepare_cache_for(const fs::path& file) {
  make_cache_folder(file.parent_path());
  std::error_code unreachable;
  if (fs::is_directory(file, unreachable)) {
    throw Error(file.string(), "is a folder, where the cache keeps a scene", "remove it");
  }
}

}  // namespace

std::vector<std::string> builtin_names() {
  return {"arcade", "church", "meeting-room", "schoolroom", "studio-car"};
}

fs::path cached_builtin(const std::string& name, std::uint32_t seed) {
  const std::string variant = seed == default_seed ? "" : fmt::format("-seed-{}", seed);
  return cached_scenes() / fmt::format("{}{}-{}.glb", name, variant, generators_digest());
}

std::optional<std::uint32_t> variant_seed(const std::string& name, const fs::path& file) {
  const std::string called = file.filename().string();
  const std::string before_seed = name + "-seed-";
  if (!called.starts_with(before_seed)) {
    return std::nullopt;
  }
  std::uint32_t seed = default_seed;
  std::from_chars(called.data() + before_seed.size(), called.data() + called.size(), seed);
  const bool is_its_name = seed != default_seed && called == cached_builtin(name, seed).filename();
  return is_its_name ? std::optional(seed) : std::nullopt;
}

std::size_t write_builtin(const std::string& name, const fs::path& file, std::uint32_t seed) {
  const bool is_cached = file.parent_path() == cached_scenes();
  if (is_cached) {
    prepare_cache_for(file);
  } else {
    prepare_folder(file.parent_path());
  }
  require_writable(file);
  const GeneratedScene scene = generate_scene(name, seed);
  if (is_cached) {
    keep_content(file, scene.glb);
  } else {
    write_file(file, scene.glb);
  }
  return scene.triangles;
}

bool is_whole_glb(const fs::path& file) {
  constexpr std::size_t length_offset = 8;
  std::array<char, 12> header{};
  std::ifstream stream(file, std::ios::binary);
  std::error_code missing;
  const std::uintmax_t size_bytes = fs::file_size(file, missing);
  if (missing || !stream.read(header.data(), header.size()) ||
      !std::string_view(header.data(), header.size()).starts_with("glTF")) {
    return false;
  }
  std::uint32_t announced_bytes = 0;
  std::memcpy(&announced_bytes, header.data() + length_offset, sizeof announced_bytes);
  return announced_bytes == size_bytes;
}

fs::path require_builtin(const std::string& name) {
  const fs::path file = cached_builtin(name);
  if (!is_kept(file)) {
    write_builtin(name, file);
  }
  return file;
}

}  // namespace foveola::scenes
