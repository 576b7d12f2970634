#include "scenes/descriptor_search.h"

#include <algorithm>
#include <system_error>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "renderer/base/toml/toml_file.h"
#include "scenes/builtin.h"
#include "scenes/file_search.h"

namespace fs = std::filesystem;

namespace foveola::scenes {
namespace {

fs::path programs_folder() { return resource_folder() / "scenes"; }

fs::path folder_of(const std::string& name) {
  return is_builtin_name(name) ? builtin_folder(name) : programs_folder();
}

/// Returns NAME.toml in `folder`, if it exists or the folder cannot be read.
std::optional<fs::path> named_file(const fs::path& folder, const std::string& name) {
  if (!is_scene_name(name)) {
    return std::nullopt;
  }
  fs::path file = folder / (name + ".toml");
  std::error_code failure;
  if (!fs::exists(file, failure) && failure != std::errc::permission_denied) {
    return std::nullopt;
  }
  return file;
}

std::optional<Descriptor> find_among(const fs::path& folder, const std::string& name) {
  const std::optional<fs::path> file = named_file(folder, name);
  return file ? std::optional(read_descriptor(*file)) : std::nullopt;
}

void append(std::vector<std::string>& names, const std::vector<std::string>& more) {
  names.insert(names.end(), more.begin(), more.end());
}

template <typename FolderOf>
DescriptorList read_descriptors(const std::vector<std::string>& names, const FolderOf& folder_of) {
  DescriptorList list;
  for (const std::string& name : names) {
    try {
      list.descriptors.push_back(read_descriptor(folder_of(name) / (name + ".toml")));
    } catch (const Error& fault) {
      list.faults.emplace_back(fault.what());
    }
  }
  return list;
}

std::vector<std::string> readable_names_in(const fs::path& folder) {
  try {
    return toml_names_in(folder);
  } catch (const Error&) {
    return {};
  }
}

}  // namespace

bool is_scene_name(const std::string& text) {
  return !text.empty() && text.find('/') == std::string::npos && text.front() != '.';
}

std::optional<Descriptor> find_descriptor(const std::string& name) {
  return find_among(folder_of(name), name);
}

std::optional<Descriptor> find_users_descriptor(const std::string& name) {
  return find_among(fetched_folder(), name);
}

std::optional<Descriptor> find_descriptor_in(const fs::path& folder, const std::string& name) {
  const std::optional<fs::path> file = named_file(folder, name);
  return file && is_descriptor(*file) ? std::optional(read_descriptor(*file)) : std::nullopt;
}

std::optional<Descriptor> descriptor_beside(const fs::path& scene_file) {
  std::optional<Descriptor> descriptor =
      find_descriptor_in(scene_file.parent_path(), scene_file.stem().string());
  return descriptor && descriptor->file_name == scene_file.filename() ? descriptor : std::nullopt;
}

bool is_programs_own(const Descriptor& descriptor) {
  std::error_code ignored;
  return fs::equivalent(fs::absolute(descriptor.path).parent_path(), folder_of(descriptor.name),
                        ignored);
}

DescriptorList all_descriptors() {
  std::vector<std::string> names = toml_names_in(programs_folder());
  append(names, builtin_names());
  std::ranges::sort(names);
  return read_descriptors(names, folder_of);
}

DescriptorList users_descriptors() {
  return read_descriptors(toml_names_or_none(fetched_folder()),
                          [](const std::string&) { return fetched_folder(); });
}

std::vector<std::string> known_scene_names() {
  std::vector<std::string> names = readable_names_in(programs_folder());
  append(names, builtin_names());
  append(names, readable_names_in(fetched_folder()));
  return names;
}

}  // namespace foveola::scenes
