#include <cmath>

#include "scenes/builtin.h"
#include "scenes/studio_car/studio.h"

namespace foveola::scenes {
namespace {

void add_tyre_stack(Model& model, const studio::Materials& m) {
  Shape tyres;
  for (int i = 0; i < 4; ++i) {
    append(tyres, moved(turned(tyre(), 40.0 * i),
                        {0.03 * std::sin(2.1 * i), 0.218 * i, 0.03 * std::cos(3.3 * i)}));
  }
  add_object(model, "Tyre stack", moved({{m.car.rubber, tyres, 35.0}}, {-1.6, 0.012, 2.95}));
}

void add_plant(Model& model, const studio::Materials& m) {
  const PlantSize size{
      .pot_radius = 0.3, .pot_height = 0.5, .stem_height = 1.0, .leaf_length = 0.4};
  add_object(model, "Plant",
             moved(potted_plant(size, m.plant, model.stream(400)), {7.1, 0.0, 4.6}));
}

}  // namespace

Model make_studio_car(std::uint32_t seed) {
  Model model{.seed = seed};
  const studio::Materials materials = studio::add_materials(model);
  studio::add_room(model, materials);
  studio::add_ceiling_rig(model, materials);
  studio::add_backdrop(model, materials);
  studio::add_softboxes(model, materials);
  studio::add_cables(model, materials);
  studio::add_tool_trolley(model, materials, {2.7, 0.006, -2.9}, 20.0);
  studio::add_workbench(model, materials);
  studio::add_flight_cases(model, materials);
  studio::add_camera(model, materials, {1.4, 0.0, 5.2});
  studio::add_desk(model, materials);
  studio::add_ladder(model, materials, {-5.6, 0.0, 5.9}, 35.0);
  studio::add_set_pieces(model, materials);
  add_tyre_stack(model, materials);
  add_plant(model, materials);
  add_car(model, materials.car, studio::turntable_height);
  model.cameras.push_back({"Three-quarter view", {3.9F, 1.45F, 3.3F}, {radians(-48.0), 0.0}});
  return model;
}

}  // namespace foveola::scenes
