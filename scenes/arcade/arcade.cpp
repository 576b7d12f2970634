// The arcade's materials and its assembly.
#include <cmath>

#include "scenes/arcade/parts.h"
#include "scenes/arcade/patterns.h"
#include "scenes/builtin.h"
#include "scenes/modelling/patterns.h"
#include "scenes/modelling/pavements.h"

namespace foveola::scenes {
namespace arcade {
namespace {

int add_cloth(Model& model, const char* name, Image weave) {
  const int image = add_image(model, std::move(weave));
  return add_material(model, {.name = name,
                              .base_color = Rgb(1.0F),
                              .roughness = 0.95F,
                              .base_color_image = image,
                              .double_sided = true});
}

void add_stones(Model& model, Materials& m) {
  m.limestone = add_textured_material(
      model, "limestone", weathered_stone(768, {0.6F, 0.54F, 0.44F}, model.stream(11)), 0.8F);
  model.materials[m.limestone].double_sided = true;  // the capitals' leaves curl
  m.ashlar = add_textured_material(model, "ashlar",
                                   masonry(1024,
                                           {.courses = 6,
                                            .stones = 4,
                                            .joint = 0.02,
                                            .variation = 0.1,
                                            .stone = {0.64F, 0.58F, 0.48F},
                                            .mortar = {0.44F, 0.4F, 0.33F}},
                                           model.stream(15)),
                                   0.9F);
  m.paving = add_textured_material(model, "paving", stone_slabs(1024, model.stream(12)), 0.6F);
  m.rosette =
      add_textured_material(model, "inlaid rosette", inlaid_rosette(1024, model.stream(18)), 0.4F);
  m.walk_tiles = add_textured_material(
      model, "walk tiles",
      floor_tiles(1024, 8, {0.5F, 0.46F, 0.4F}, {0.22F, 0.1F, 0.07F}, model.stream(13)), 0.4F);
  m.brick = add_textured_material(model, "brick",
                                  masonry(1024,
                                          {.courses = 24,
                                           .stones = 8,
                                           .joint = 0.14,
                                           .variation = 0.35,
                                           .stone = {0.58F, 0.4F, 0.28F},
                                           .mortar = {0.58F, 0.54F, 0.47F}},
                                          model.stream(14)),
                                  0.9F);
  m.plaster = add_textured_material(
      model, "plaster", plaster(512, {0.68F, 0.63F, 0.54F}, 0.12, model.stream(19)), 0.95F);
  m.roof_tile = add_textured_material(
      model, "roof tile", weathered_stone(256, {0.5F, 0.22F, 0.12F}, model.stream(20)), 0.85F);
  m.basin_tiles = add_textured_material(
      model, "basin tiles",
      floor_tiles(256, 16, {0.1F, 0.36F, 0.4F}, {0.06F, 0.24F, 0.36F}, model.stream(21)), 0.3F);
}

void add_woods_and_metals(Model& model, Materials& m) {
  m.wood = add_textured_material(
      model, "wood", wood(512, 4, {0.3F, 0.17F, 0.08F}, {0.13F, 0.065F, 0.03F}, model.stream(16)),
      0.6F);
  m.old_wood = add_textured_material(
      model, "old wood",
      wood(512, 3, {0.2F, 0.1F, 0.045F}, {0.09F, 0.045F, 0.022F}, model.stream(22)), 0.5F);
  m.bronze = add_material(model, {.name = "bronze",
                                  .base_color = {0.55F, 0.36F, 0.17F},
                                  .metallic = 1.0F,
                                  .roughness = 0.35F});
  m.iron = add_material(
      model, {.name = "iron", .base_color = Rgb(0.1F), .metallic = 1.0F, .roughness = 0.5F});
}

void add_small_things(Model& model, Materials& m) {
  m.water = add_material(model, {.name = "water",
                                 .base_color = {0.72F, 0.9F, 0.9F},
                                 .roughness = 0.0F,
                                 .transmission = 1.0F,
                                 .double_sided = true});
  m.falling_water = add_material(model, {.name = "falling water",
                                         .base_color = {0.92F, 0.96F, 0.97F},
                                         .roughness = 0.0F,
                                         .transmission = 0.75F,
                                         .double_sided = true});
  m.lantern_glass = add_material(model, {.name = "lantern glass",
                                         .base_color = {0.9F, 0.86F, 0.7F},
                                         .roughness = 0.0F,
                                         .transmission = 1.0F,
                                         .double_sided = true});
  m.candle = add_material(model, {.name = "candle", .base_color = {0.8F, 0.74F, 0.6F}});
  m.rope = add_material(model, {.name = "gold rope", .base_color = {0.6F, 0.42F, 0.13F}});
  m.red_banner = add_cloth(model, "red banner cloth",
                           banner_cloth(768, {0.48F, 0.04F, 0.035F}, model.stream(41)));
  m.blue_banner = add_cloth(model, "blue banner cloth",
                            banner_cloth(768, {0.035F, 0.1F, 0.36F}, model.stream(42)));
  m.red_cloth =
      add_cloth(model, "red cloth",
                cloth(512, 3, {0.5F, 0.05F, 0.04F}, {0.6F, 0.42F, 0.12F}, model.stream(43)));
  m.blue_cloth =
      add_cloth(model, "blue cloth",
                cloth(512, 3, {0.05F, 0.13F, 0.4F}, {0.62F, 0.6F, 0.55F}, model.stream(44)));
  m.orange =
      add_material(model, {.name = "orange", .base_color = {0.8F, 0.3F, 0.03F}, .roughness = 0.4F});
  m.plant = add_plant_materials(model);
}

}  // namespace

Materials add_materials(Model& model) {
  Materials m;
  add_stones(model, m);
  add_woods_and_metals(model, m);
  add_small_things(model, m);
  return m;
}

}  // namespace arcade

Model make_arcade(std::uint32_t seed) {
  using namespace arcade;  // NOLINT(google-build-using-namespace): the arcade's own parts
  Model model{.seed = seed};
  const Materials materials = add_materials(model);
  add_floors(model, materials);
  add_walls(model, materials);
  add_arches(model, materials);
  add_vaults(model, materials);
  add_upper_ceiling(model, materials);
  add_roof_edge(model, materials);
  add_columns(model, materials);
  add_balustrade(model, materials);
  add_doors(model, materials);
  add_lanterns(model, materials);
  add_fountain(model, materials);
  add_urn(model, materials);
  add_sundial(model, materials);
  add_benches(model, materials);
  add_plants(model, materials);
  add_cloths(model, materials);
  model.cameras.push_back({"Court", {-4.0F, 1.5F, 1.0F}, {radians(78.0), 0.0}});
  return model;
}

}  // namespace foveola::scenes
