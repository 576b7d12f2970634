#include <algorithm>

#include "scenes/builtin.h"
#include "scenes/schoolroom/parts.h"

namespace foveola::scenes {
namespace school {

std::vector<Part> placed(std::vector<Part> parts, const DVec3& offset, double turn_deg) {
  for (Part& part : parts) {
    part.shape = moved(turned(std::move(part.shape), turn_deg), offset);
  }
  return parts;
}

void append(std::vector<Part>& to, const std::vector<Part>& from) {
  for (const Part& part : from) {
    const auto same = std::find_if(to.begin(), to.end(), [&](const Part& candidate) {
      return candidate.material == part.material && candidate.crease_deg == part.crease_deg;
    });
    if (same == to.end()) {
      to.push_back(part);
    } else {
      append(same->shape, part.shape);
    }
  }
}

}  // namespace school

Model make_schoolroom(std::uint32_t seed) {
  Model model{.seed = seed};
  const school::Materials m = school::add_materials(model);
  school::add_shell(model, m);
  school::add_windows(model, m);
  school::add_curtains(model, m);
  school::add_radiators(model, m);
  school::add_lamps(model, m);
  school::add_door(model, m);
  school::add_desks_and_chairs(model, m);
  school::add_teachers_place(model, m);
  school::add_teachers_things(model, m);
  school::add_shelves(model, m);
  school::add_desk_things(model, m);
  school::add_bags(model, m);
  school::add_coats(model, m);
  school::add_board(model, m);
  school::add_wall_things(model, m);
  school::add_globe(model, m);
  school::add_planets(model, m);
  school::add_microscope(model, m);
  school::add_molecule(model, m);
  school::add_waste_basket(model, m);
  school::add_plants(model, m);
  school::add_skeleton(model, m);
  school::add_outside(model, m);
  model.cameras.push_back({"Between the desks", {-1.9F, 1.3F, 1.1F}, {radians(78.0), 0.0}});
  return model;
}

}  // namespace foveola::scenes
