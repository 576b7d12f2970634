#include "renderer/scene/obj/file.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <map>
#include <span>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include "renderer/base/error.h"
#include "renderer/base/files/digest.h"
#include "renderer/base/files/files.h"
#include "renderer/base/work/work_scope.h"
#include "renderer/scene/obj/colors.h"
#include "renderer/scene/obj/polygon.h"
#include "renderer/scene/obj/text_lines.h"

namespace foveola {
namespace {

/// tinyobjloader counts in int.
constexpr std::size_t largest_file = std::size_t{1} << 32;

/// An object takes far more memory than the line that names it.
constexpr std::size_t max_parts = std::size_t{1} << 20;

/// Collects tinyobjloader's results, line by line. Its own reader of whole files loses polygons
/// whose ears it cannot find, and cannot stop at a bad index.
class Collector {
 public:
  /// smoothing_groups: of smoothing_groups_in().
  Collector(std::string file_name, std::vector<unsigned> smoothing_groups, ObjFile& obj,
            Warnings& warnings)
      : file_name_(std::move(file_name)),
        smoothing_groups_(std::move(smoothing_groups)),
        obj_(obj),
        warnings_(warnings) {}

  static tinyobj::callback_t callbacks() {
    tinyobj::callback_t callbacks;
    callbacks.vertex_cb = [](void* self, float x, float y, float z, float /*w*/) {
      throw_if_work_stopped();
      of(self).obj_.positions.emplace_back(x, y, z);
    };
    callbacks.normal_cb = [](void* self, float x, float y, float z) {
      of(self).obj_.normals.emplace_back(x, y, z);
    };
    callbacks.texcoord_cb = [](void* self, float u, float v, float /*w*/) {
      of(self).obj_.uvs.emplace_back(u, v);
    };
    callbacks.index_cb = [](void* self, tinyobj::index_t* corners, int count) {
      of(self).add_face(corners, count);
    };
    callbacks.usemtl_cb = [](void* self, const char* name, int /*index*/) {
      of(self).change_part(of(self).object_, std::string(trimmed(name)));
    };
    callbacks.object_cb = [](void* self, const char* name) {
      of(self).has_objects_ = true;
      of(self).change_part(std::string(trimmed(name)), of(self).material_);
    };
    callbacks.group_cb = [](void* self, const char** names, int count) {
      if (!of(self).has_objects_) {
        of(self).change_part(count > 0 ? names[0] : "", of(self).material_);
      }
    };
    return callbacks;
  }

 private:
  static Collector& of(void* self) { return *static_cast<Collector*>(self); }

  void change_part(std::string object, std::string material) {
    object_ = std::move(object);
    material_ = std::move(material);
    part_ = no_part;
  }

  ObjPart& current_part() {
    if (part_ == no_part) {
      const auto [known, is_new] =
          index_of_part_.try_emplace({object_, material_}, obj_.parts.size());
      part_ = known->second;
      if (is_new) {
        if (part_ == max_parts) {
          fail(fmt::format("there are more than {} objects and materials in use", max_parts));
        }
        obj_.parts.push_back({.object = object_, .material = material_});
      }
    }
    return obj_.parts[part_];
  }

  void add_face(const tinyobj::index_t* corners, int count) {
    throw_if_work_stopped();
    ++faces_;
    if (count < 3) {
      warnings_.add("faces of fewer than three corners are not shown",
                    fmt::format("face {}", faces_));
      return;
    }
    ObjPart& part = current_part();
    part.begins.push_back(part.corners.size());
    if (faces_ <= smoothing_groups_.size()) {
      part.smoothing_groups.push_back(smoothing_groups_[faces_ - 1]);
    }
    for (int i = 0; i < count; ++i) {
      part.corners.push_back(
          {.position = resolved(corners[i].vertex_index, obj_.positions.size(), "vertex"),
           .uv = optional(corners[i].texcoord_index, obj_.uvs.size(), "texture coordinate"),
           .normal = optional(corners[i].normal_index, obj_.normals.size(), "normal")});
    }
  }

  /// OBJ counts from 1, or backwards from -1, the last element so far.
  int resolved(int index, std::size_t count, const char* what) const {
    const std::int64_t place =
        index > 0 ? std::int64_t{index} - 1 : static_cast<std::int64_t>(count) + index;
    if (index == 0 || place < 0 || place >= static_cast<std::int64_t>(count)) {
      fail(fmt::format("names {} {}, but {} come before it", what, index, count));
    }
    return static_cast<int>(place);
  }
  /// tinyobjloader gives 0 for an omitted index.
  int optional(int index, std::size_t count, const char* what) const {
    return index == 0 ? -1 : resolved(index, count, what);
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw Error(fmt::format("{}: face {}", file_name_, faces_), what, "export it again");
  }

  static constexpr std::size_t no_part = std::numeric_limits<std::size_t>::max();

  std::string file_name_;
  std::vector<unsigned> smoothing_groups_;
  ObjFile& obj_;
  Warnings& warnings_;
  std::string object_;
  std::string material_;
  bool has_objects_ = false;
  std::size_t part_ = no_part;
  std::map<std::pair<std::string, std::string>, std::size_t> index_of_part_;
  std::size_t faces_ = 0;
};

/// A backslash at its end continues a line, which tinyobjloader does not support.
void join_continued_lines(std::string& text) {
  for (std::size_t at = text.find('\\'); at != std::string::npos; at = text.find('\\', at + 1)) {
    const std::size_t end = at + 1 < text.size() && text[at + 1] == '\r' ? at + 2 : at + 1;
    if (end < text.size() && text[end] == '\n') {
      std::fill(text.begin() + static_cast<std::ptrdiff_t>(at),
                text.begin() + static_cast<std::ptrdiff_t>(end + 1), ' ');
    }
  }
}

/// tinyobjloader splits these at spaces, which file names may have, and removes backslashes.
std::vector<std::string> material_libraries_in(std::string_view text) {
  std::vector<std::string> libraries;
  for_each_line(text, [&](std::string_view line) {
    const Statement statement = statement_in(line);
    if (statement.keyword == "mtllib" && !statement.rest.empty()) {
      libraries.emplace_back(statement.rest);
    }
  });
  return libraries;
}

std::size_t coordinates_of(std::string_view keyword) {
  return keyword == "v" || keyword == "vn" ? 3 : keyword == "vt" ? 2 : 0;
}

/// The coordinates in the statements of `text` that are not numbers.
std::vector<std::string_view> no_numbers_in(std::string_view text) {
  std::vector<std::string_view> found;
  for_each_line(text, [&](std::string_view line) {
    Statement left = statement_in(line);
    for (std::size_t i = coordinates_of(left.keyword); i > 0; --i) {
      left = statement_in(left.rest);
      if (left.keyword.empty() || left.keyword.front() == '#') {
        break;
      }
      if (!is_number(left.keyword)) {
        found.push_back(left.keyword);
      }
    }
  });
  return found;
}

/// The text of an OBJ file with "1e999", which tinyobjloader reads as infinite, in place of each
/// coordinate of a v, vn or vt statement that is not a decimal number, such as "nan", "1.#INF" or
/// "0,5". Omitted coordinates stay omitted.
std::string with_infinities_for_no_numbers(std::string text) {
  const std::vector<std::string_view> no_numbers = no_numbers_in(text);
  if (no_numbers.empty()) {
    return text;
  }
  std::string result;
  std::size_t copied = 0;
  for (const std::string_view word : no_numbers) {
    const auto begin = static_cast<std::size_t>(word.data() - text.data());
    result.append(text, copied, begin - copied).append("1e999");
    copied = begin + word.size();
  }
  return result.append(text, copied);
}

/// "off" is 0, as is any text that is not a number.
unsigned group_in(std::string_view text) {
  unsigned group = 0;
  std::from_chars(text.data(), text.data() + text.size(), group);
  return group;
}

/// The smoothing group of each "f" statement of `text`, in order, 0: none; empty if no face has
/// one.
std::vector<unsigned> smoothing_groups_in(std::string_view text) {
  std::vector<unsigned> groups;
  unsigned group = 0;
  bool is_smooth = false;
  for_each_line(text, [&](std::string_view line) {
    const Statement statement = statement_in(line);
    if (statement.keyword == "s") {
      group = group_in(statement.rest);
    } else if (statement.keyword == "f" && !statement.rest.empty()) {
      groups.push_back(group);
      is_smooth = is_smooth || group != 0;
    }
  });
  return is_smooth ? groups : std::vector<unsigned>();
}

/// Adds vertex normals to faces of a smoothing group without normals: the mean of the group's faces
/// at a vertex, weighted by their areas.
void add_smooth_normals(ObjFile& obj) {
  const std::size_t stated = obj.normals.size();
  std::map<std::pair<unsigned, int>, int> index_of;  // by group and position
  std::vector<Vec3> positions;
  for (ObjPart& part : obj.parts) {
    const std::span<ObjCorner> corners(part.corners);
    for (std::size_t i = 0; i < part.smoothing_groups.size(); ++i) {
      throw_if_work_stopped();
      const unsigned group = part.smoothing_groups[i];
      const std::size_t end = i + 1 < part.begins.size() ? part.begins[i + 1] : corners.size();
      const std::span<ObjCorner> face = corners.subspan(part.begins[i], end - part.begins[i]);
      if (group == 0 || std::ranges::any_of(face, [](const auto& c) { return c.normal >= 0; })) {
        continue;
      }
      positions.clear();
      for (const ObjCorner& corner : face) {
        positions.push_back(obj.positions[static_cast<std::size_t>(corner.position)]);
      }
      const Vec3 area(area_vector(positions));
      for (ObjCorner& corner : face) {
        const auto [known, is_new] =
            index_of.try_emplace({group, corner.position}, static_cast<int>(obj.normals.size()));
        if (is_new) {
          obj.normals.emplace_back(0.0F);
        }
        corner.normal = known->second;
        obj.normals[static_cast<std::size_t>(corner.normal)] += area;
      }
    }
  }
  for (Vec3& normal : std::span(obj.normals).subspan(stated)) {
    normal = Vec3(glm::normalize(DVec3(normal)));
  }
}

}  // namespace

ObjFile read_obj_file(const std::filesystem::path& path, Warnings& warnings) {
  std::string bytes = read_bytes(path, largest_file);
  ObjFile obj;
  obj.sha256 = sha256(bytes);
  std::string text = utf8_text(path, std::move(bytes));
  join_continued_lines(text);
  obj.material_libraries = material_libraries_in(text);
  obj.colors = vertex_colors_in(text);
  std::vector<unsigned> smoothing_groups = smoothing_groups_in(text);
  std::istringstream stream(with_infinities_for_no_numbers(std::move(text)));
  Collector collector(path.string(), std::move(smoothing_groups), obj, warnings);
  tinyobj::LoadObjWithCallback(stream, Collector::callbacks(), &collector);
  add_smooth_normals(obj);
  obj.colors.resize(obj.colors.empty() ? 0 : obj.positions.size(), Rgb(1.0F));
  return obj;
}

}  // namespace foveola
