#include "scenes/descriptor.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace fs = std::filesystem;

namespace foveola::scenes {
namespace {

constexpr double largest_coordinate_m = 1e6;
constexpr double largest_radiance = 1e6;

struct Range {
  double lowest;
  double highest;
};

/// One table of a descriptor, read key by key; whatever was not asked for in the end is unknown.
class TableReader {
 public:
  TableReader(const fs::path& file, const toml::table& table) : file_(file), table_(table) {}

  bool has(const char* key) const { return table_.contains(key); }

  std::string text(const char* key) {
    const auto value = required(key).value_exact<std::string>();
    if (!value || value->empty()) {
      fail(table_.get(key)->source(), fmt::format("{} must be a text", key),
           "put it in double quotes");
    }
    return *value;
  }
  std::string text_or_none(const char* key) { return has(key) ? text(key) : std::string(); }

  bool flag_or_false(const char* key) {
    if (!has(key)) {
      return false;
    }
    const auto value = required(key).value_exact<bool>();
    if (!value) {
      fail(table_.get(key)->source(), fmt::format("{} must be true or false", key), {});
    }
    return *value;
  }

  double number(const char* key, const Range& range) {
    return number_from(required(key), key, range);
  }
  double number_or(double otherwise, const char* key, const Range& range) {
    return has(key) ? number(key, range) : otherwise;
  }

  /// A list of exactly as many numbers as the vector has components.
  template <typename Vector>
  Vector vector(const char* key, const Range& range) {
    const toml::node& node = required(key);
    const toml::array* list = node.as_array();
    if (list == nullptr || list->size() != static_cast<std::size_t>(Vector::length())) {
      fail(node.source(), fmt::format("{} must be a list of {} numbers", key, Vector::length()),
           {});
    }
    Vector result{};
    for (int i = 0; i < Vector::length(); ++i) {
      result[i] =
          static_cast<float>(number_from(*list->get(static_cast<std::size_t>(i)), key, range));
    }
    return result;
  }

  TableReader table(const char* key) {
    const toml::node& node = required(key);
    if (!node.is_table()) {
      fail(node.source(), fmt::format("{} must be a table", key), fmt::format("write [{}]", key));
    }
    return {file_, *node.as_table()};
  }

  std::vector<TableReader> tables(const char* key) {
    std::vector<TableReader> result;
    if (!has(key)) {
      return result;
    }
    const toml::node& node = required(key);
    if (!node.is_array_of_tables()) {
      fail(node.source(), fmt::format("{} must be tables", key), fmt::format("write [[{}]]", key));
    }
    for (const toml::node& element : *node.as_array()) {
      result.emplace_back(file_, *element.as_table());
    }
    return result;
  }

  /// To be called when everything was asked for.
  void reject_unknown_keys() const {
    for (const auto& [key, node] : table_) {
      if (asked_.find(key.str()) == asked_.end()) {
        fail(key.source(), fmt::format("'{}' is not a key of a scene's descriptor here", key.str()),
             fmt::format("the keys are {}", fmt::join(asked_, ", ")));
      }
    }
  }

  [[noreturn]] void fail(const toml::source_region& source, const std::string& what,
                         const std::string& remedy) const {
    throw Error(fmt::format("{}:{}:{}", file_.string(), source.begin.line, source.begin.column),
                what, remedy);
  }
  const toml::source_region& source(const char* key) const { return table_.get(key)->source(); }
  const toml::source_region& source() const { return table_.source(); }

  /// Has no effect but that `key` counts as known.
  void know(const char* key) { asked_.insert(key); }

 private:
  const toml::node& required(const char* key) {
    know(key);
    const toml::node* node = table_.get(key);
    if (node == nullptr) {
      fail(table_.source(), fmt::format("{} is missing", key), {});
    }
    return *node;
  }

  double number_from(const toml::node& node, const char* key, const Range& range) const {
    const auto value = node.is_number() ? node.value<double>() : std::nullopt;
    if (!value || !(*value >= range.lowest && *value <= range.highest)) {
      fail(node.source(),
           fmt::format("{} must hold numbers from {} to {}", key, range.lowest, range.highest), {});
    }
    return *value;
  }

  const fs::path& file_;
  const toml::table& table_;
  std::set<std::string, std::less<>> asked_;
};

constexpr Range coordinate{-largest_coordinate_m, largest_coordinate_m};
constexpr Range radiance{0.0, largest_radiance};

bool is_axis(const Vec3& v) {
  const Vec3 size = glm::abs(v);
  return size == Vec3(1, 0, 0) || size == Vec3(0, 1, 0) || size == Vec3(0, 0, 1);
}

RectangleLight read_light(TableReader table) {
  RectangleLight light;
  light.center = table.vector<Vec3>("center", coordinate);
  light.size = table.vector<Vec2>("size", {1e-6, largest_coordinate_m});
  light.normal = table.vector<Vec3>("normal", {-1.0, 1.0});
  light.radiance = table.vector<Rgb>("radiance", radiance);
  if (!is_axis(light.normal)) {
    table.fail(table.source("normal"), "normal must be an axis", "for instance [0, -1, 0]");
  }
  table.reject_unknown_keys();
  return light;
}

ObjectOfInterest read_object(TableReader table) {
  ObjectOfInterest object;
  object.name = table.text("name");
  object.position = table.vector<Vec3>("position", coordinate);
  object.radius_deg = static_cast<float>(table.number("radius_deg", {0.1, 90.0}));
  table.reject_unknown_keys();
  return object;
}

void read_camera(TableReader table, SceneSource& source) {
  source.camera_position = table.vector<Vec3>("position", coordinate);
  source.heading.azimuth_rad = radians(table.number("azimuth_deg", {-180.0, 180.0}));
  source.heading.elevation_rad = radians(table.number("elevation_deg", {-90.0, 90.0}));
  table.reject_unknown_keys();
}

void read_viewpoint(TableReader& table, SceneSource& source) {
  read_camera(table.table("camera"), source);
  source.exposure_stops = table.number_or(0.0, "exposure_stops", {-20.0, 20.0});
  if (table.has("environment_radiance")) {
    source.environment_radiance = table.vector<Rgb>("environment_radiance", radiance);
  }
  for (const TableReader& light : table.tables("light")) {
    source.lights.push_back(read_light(light));
  }
  for (const TableReader& object : table.tables("object")) {
    source.objects.push_back(read_object(object));
  }
}

Descriptor descriptor_from(const fs::path& file, const toml::table& toml) {
  TableReader table(file, toml);
  for (const char* const optional : {"builtin", "file", "origin", "counterpart", "exposure_stops",
                                     "environment_radiance", "light", "object"}) {
    table.know(optional);
  }
  Descriptor descriptor;
  descriptor.name = file.stem().string();
  descriptor.source.name = descriptor.name;
  descriptor.source.title = table.text("title");
  descriptor.author = table.text("author");
  descriptor.licence = table.text("licence");
  descriptor.is_builtin = table.flag_or_false("builtin");
  descriptor.file_name = table.text_or_none("file");
  descriptor.origin = table.text_or_none("origin");
  descriptor.counterpart = table.text_or_none("counterpart");
  if (descriptor.is_builtin == !descriptor.file_name.empty()) {
    table.fail(table.source(), "a scene is either built in or has a file",
               "give one of builtin = true and file = \"NAME.glb\"");
  }
  read_viewpoint(table, descriptor.source);
  table.reject_unknown_keys();
  return descriptor;
}

fs::path descriptor_folder() { return resource_folder() / "scenes"; }

/// The folders of $FOVEOLA_SCENE_PATH.
std::vector<fs::path> search_folders() {
  std::vector<fs::path> folders;
  const char* value = std::getenv("FOVEOLA_SCENE_PATH");
  std::istringstream list(value != nullptr ? value : "");
  for (std::string folder; std::getline(list, folder, ':');) {
    if (!folder.empty()) {
      folders.emplace_back(folder);
    }
  }
  return folders;
}

/// The folders in `folder`, in order of their names; none if it cannot be read.
std::vector<fs::path> subfolders(const fs::path& folder) {
  std::vector<fs::path> result;
  std::error_code failure;
  fs::directory_iterator entry(folder, failure);
  for (; !failure && entry != fs::directory_iterator(); entry.increment(failure)) {
    std::error_code ignored;
    if (entry->is_directory(ignored)) {
      result.push_back(entry->path());
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace

Descriptor read_descriptor(const fs::path& file) {
  const std::string content = read_file(file);
  try {
    return descriptor_from(file, toml::parse(content, file.string()));
  } catch (const toml::parse_error& error) {
    const toml::source_position& at = error.source().begin;
    throw Error(fmt::format("{}:{}:{}", file.string(), at.line, at.column),
                std::string(error.description()), {});
  }
}

std::optional<Descriptor> find_descriptor(const std::string& name) {
  if (name.empty() || name.find('/') != std::string::npos || name[0] == '.') {
    return std::nullopt;
  }
  const fs::path file = descriptor_folder() / (name + ".toml");
  return fs::exists(file) ? std::optional(read_descriptor(file)) : std::nullopt;
}

std::vector<Descriptor> all_descriptors() {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(descriptor_folder())) {
    if (entry.path().extension() == ".toml") {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  std::vector<Descriptor> descriptors;
  for (const fs::path& file : files) {
    descriptors.push_back(read_descriptor(file));
  }
  return descriptors;
}

std::optional<fs::path> find_real_file(const Descriptor& descriptor) {
  for (const fs::path& folder : search_folders()) {
    std::vector<fs::path> candidates = {folder};
    const std::vector<fs::path> below = subfolders(folder);
    candidates.insert(candidates.end(), below.begin(), below.end());
    for (const fs::path& candidate : candidates) {
      std::error_code ignored;
      if (fs::is_regular_file(candidate / descriptor.file_name, ignored)) {
        return candidate / descriptor.file_name;
      }
    }
  }
  return std::nullopt;
}

}  // namespace foveola::scenes
