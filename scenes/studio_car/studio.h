// The photographer's studio around the car, in groups of objects.
#pragma once

#include <vector>

#include "scenes/modelling/props.h"
#include "scenes/studio_car/car.h"

namespace foveola::scenes::studio {

constexpr double half_room = 8.0;
constexpr double ceiling = 5.5;
constexpr double turntable_height = 0.06;
constexpr double lower_chord = ceiling - 0.55;  ///< height of the trusses from which lights hang

struct Materials {
  int concrete = 0;
  int brick = 0;
  int ceiling = 0;
  int backdrop = 0;
  int turntable = 0;
  int steel = 0;
  int black_steel = 0;
  int black_cloth = 0;
  int black_laminate = 0;
  int red_lacquer = 0;
  int aluminium = 0;
  int galvanised = 0;
  int white_paint = 0;
  int wood = 0;
  int cable = 0;
  int sandbag = 0;
  int camera_body = 0;
  int lens = 0;
  int display = 0;
  int poster = 0;
  int clock = 0;
  int softbox = 0;
  int warm_softbox = 0;
  int work_light = 0;
  PlantMaterials plant;
  CarMaterials car;
};

Materials add_materials(Model& model);

void add_room(Model& model, const Materials& m);
void add_ceiling_rig(Model& model, const Materials& m);
void add_backdrop(Model& model, const Materials& m);
void add_softboxes(Model& model, const Materials& m);
void add_cables(Model& model, const Materials& m);
void add_tool_trolley(Model& model, const Materials& m, const DVec3& place, double turn_deg);
void add_workbench(Model& model, const Materials& m);
void add_flight_cases(Model& model, const Materials& m);
void add_camera(Model& model, const Materials& m, const DVec3& place);
void add_desk(Model& model, const Materials& m);
void add_set_pieces(Model& model, const Materials& m);
void add_ladder(Model& model, const Materials& m, const DVec3& place, double turn_deg);

/// A castor of `height` under the origin, its wheel rolling along X.
struct Castor {
  Shape fork;
  Shape wheel;
};
Castor castor(double height);

/// Parts turned about the Y axis and put somewhere.
std::vector<Part> placed(std::vector<Part> parts, double turn_deg, const DVec3& place);

}  // namespace foveola::scenes::studio
