#include "scenes/studio_car/car.h"

#include "scenes/modelling/props.h"
#include "scenes/studio_car/body_surface.h"
#include "scenes/studio_car/parts.h"

namespace foveola::scenes {
namespace {

struct Wheel {
  const char* name;
  double x;
  double side;
};

void add_wheels(Model& model, const CarMaterials& materials, double ground) {
  const std::vector<Part> lying = car::wheel(materials);
  for (const Wheel& wheel :
       {Wheel{"Front wheel", car::front_axle, 1.0}, Wheel{"Rear wheel", car::rear_axle, 1.0},
        Wheel{"Far front wheel", car::front_axle, -1.0},
        Wheel{"Far rear wheel", car::rear_axle, -1.0}}) {
    std::vector<Part> standing = lying;
    for (Part& part : standing) {
      part.shape = turned(std::move(part.shape), 90.0 * wheel.side, {1, 0, 0});
    }
    const DVec3 place(wheel.x, ground + car::wheel_radius, wheel.side * car::wheel_middle_z);
    add_object(model, wheel.name, moved(std::move(standing), place));
  }
}

}  // namespace

void add_car(Model& model, const CarMaterials& m, double ground) {
  const car::Body body = car::make_body();
  const auto add = [&](const char* name, std::vector<Part> parts) {
    add_object(model, name, moved(std::move(parts), {0.0, ground, 0.0}));
  };
  add("Car body", car::bodywork(body, m));
  add("Car windows", car::window_panes(body, m));
  add_wheels(model, m, ground);
  add("Car underbody and grille", car::underbody_and_grille(body, m));
  add("Car trim", car::trim(body, m));
  add("Headlights", car::headlights(body, m));
  add("Tail lights", car::tail_lights(body, m));
  add("Car mirrors", car::mirrors(m));
  add("Number plate", car::front_number_plate(m));
  add("Rear number plate", car::rear_number_plate(m));
  add("Steering wheel", car::steering_wheel(m));
  add("Dashboard", car::dashboard(m));
  add("Car seats", car::seats(m));
  add("Cabin lining", car::cabin_lining(body, m));
}

}  // namespace foveola::scenes
