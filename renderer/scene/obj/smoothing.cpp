#include "renderer/scene/obj/smoothing.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <map>
#include <span>
#include <utility>

#include "renderer/base/work/work_scope.h"
#include "renderer/scene/obj/polygon.h"
#include "renderer/scene/obj/text_lines.h"

namespace foveola {
namespace {

/// "off" is 0, as is what is no number.
unsigned group_in(std::string_view text) {
  unsigned group = 0;
  std::from_chars(text.data(), text.data() + text.size(), group);
  return group;
}

}  // namespace

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

}  // namespace foveola
