// The church's materials, and its assembly.
#include "renderer/base/angles.h"
#include "scenes/builtin.h"
#include "scenes/church/parts.h"
#include "scenes/church/patterns.h"
#include "scenes/modelling/patterns.h"
#include "scenes/modelling/pavements.h"

namespace foveola::scenes {
namespace church {
namespace {

/// A thin pane whose colours are those of light that has passed it. Smooth, so that the renderer
/// lets light pass straight.
int add_glass(Model& model, const char* name, Image image) {
  const int index = add_image(model, std::move(image));
  return add_material(model, {.name = name,
                              .base_color = Rgb(1.0F),
                              .roughness = 0.0F,
                              .base_color_image = index,
                              .transmission = 1.0F,
                              .double_sided = true});
}

void add_stones(Model& model, Materials& m) {
  m.masonry = add_textured_material(model, "masonry",
                                    masonry(1024,
                                            {.courses = 8,
                                             .stones = 4,
                                             .joint = 0.03,
                                             .variation = 0.22,
                                             .stone = {0.66F, 0.6F, 0.5F},
                                             .mortar = {0.52F, 0.47F, 0.39F}},
                                            model.stream(51)),
                                    0.95F);
  m.limestone = add_textured_material(
      model, "church limestone", plaster(512, {0.7F, 0.65F, 0.57F}, 0.22, model.stream(52)), 0.85F);
  model.materials[m.limestone].double_sided = true;  // the capitals' leaves curl
  m.vault = add_textured_material(model, "vault",
                                  masonry(1024,
                                          {.courses = 12,
                                           .stones = 5,
                                           .joint = 0.05,
                                           .variation = 0.1,
                                           .stone = {0.7F, 0.67F, 0.61F},
                                           .mortar = {0.6F, 0.55F, 0.47F}},
                                          model.stream(53)),
                                  0.95F);
  m.sky_vault =
      add_textured_material(model, "starry vault", starry_sky(1024, model.stream(54)), 0.9F);
  m.slabs = add_textured_material(model, "floor slabs", stone_slabs(1024, model.stream(55)), 0.5F);
  m.rosette =
      add_textured_material(model, "rosette", inlaid_rosette(1024, model.stream(56)), 0.35F);
  m.band = add_textured_material(model, "inlaid band", inlaid_band(512, model.stream(57)), 0.35F);
  m.white_marble = add_textured_material(
      model, "white marble",
      veined_marble(512, {0.62F, 0.6F, 0.56F}, {0.3F, 0.3F, 0.31F}, model.stream(58)), 0.3F);
  m.red_marble = add_textured_material(
      model, "red marble",
      veined_marble(512, {0.3F, 0.09F, 0.06F}, {0.55F, 0.42F, 0.36F}, model.stream(59)), 0.25F);
  m.dark_stone = add_textured_material(
      model, "dark stone", plaster(256, {0.16F, 0.15F, 0.14F}, 0.3, model.stream(60)), 0.6F);
}

void add_woods_and_metals(Model& model, Materials& m) {
  m.oak = add_textured_material(
      model, "oak", wood(512, 4, {0.34F, 0.2F, 0.09F}, {0.17F, 0.09F, 0.04F}, model.stream(61)),
      0.5F);
  m.dark_oak = add_textured_material(
      model, "dark oak",
      wood(512, 4, {0.15F, 0.08F, 0.04F}, {0.07F, 0.035F, 0.018F}, model.stream(62)), 0.45F);
  m.gold = add_material(
      model,
      {.name = "gold", .base_color = {0.9F, 0.62F, 0.25F}, .metallic = 1.0F, .roughness = 0.5F});
  m.brass = add_material(
      model,
      {.name = "brass", .base_color = {0.8F, 0.56F, 0.24F}, .metallic = 1.0F, .roughness = 0.45F});
  m.iron = add_material(
      model, {.name = "iron", .base_color = Rgb(0.12F), .metallic = 1.0F, .roughness = 0.6F});
  m.tin = add_material(
      model,
      {.name = "tin", .base_color = {0.72F, 0.7F, 0.66F}, .metallic = 1.0F, .roughness = 0.3F});
}

void add_small_things(Model& model, Materials& m) {
  m.wax =
      add_material(model, {.name = "wax", .base_color = {0.78F, 0.7F, 0.52F}, .roughness = 0.5F});
  m.linen = add_material(model, {.name = "linen", .base_color = {0.75F, 0.73F, 0.68F}});
  m.frontal =
      add_textured_material(model, "altar frontal", altar_frontal(512, model.stream(63)), 0.8F);
  m.book = add_textured_material(model, "open book", open_book(512, model.stream(64)), 0.9F);
  m.blue_saint = add_textured_material(
      model, "saint in blue", painted_saint(256, {0.06F, 0.13F, 0.4F}, model.stream(65)), 0.5F);
  m.red_saint = add_textured_material(
      model, "saint in red", painted_saint(256, {0.42F, 0.06F, 0.05F}, model.stream(66)), 0.5F);
  m.water = add_material(
      model, {.name = "font water", .base_color = {0.06F, 0.1F, 0.1F}, .roughness = 0.1F});
  m.flame = add_material(model, {.name = "flame", .emission = {40.0F, 23.0F, 8.5F}});
  m.lamp = add_material(model, {.name = "lamp glass", .emission = {27.0F, 19.0F, 11.3F}});
}

/// The upper windows see open sky, hazy where the sun is; trees and houses shade the lower ones.
void add_skies(Model& model, Materials& m) {
  const auto sky = [&](const char* name, const Rgb& radiance) {
    return add_material(model, {.name = name, .base_color = Rgb(0.0F), .emission = radiance});
  };
  m.northern_sky = sky("northern sky", {4.6F, 5.3F, 6.3F});
  m.southern_sky = sky("southern sky", {10.0F, 9.7F, 9.2F});
  m.shaded_sky = sky("shaded sky", {3.2F, 3.3F, 3.4F});
}

}  // namespace

Materials add_materials(Model& model) {
  Materials m;
  add_stones(model, m);
  add_woods_and_metals(model, m);
  add_small_things(model, m);
  add_skies(model, m);
  m.grisaille = add_glass(model, "grisaille", grisaille_window(320, model.stream(67)));
  m.blue_glass = add_glass(model, "window with a blue saint",
                           figure_window(256, {0.02F, 0.08F, 0.4F}, model.stream(68)));
  m.green_glass = add_glass(model, "window with a green saint",
                            figure_window(256, {0.01F, 0.2F, 0.04F}, model.stream(69)));
  m.white_glass = add_glass(model, "window with a white saint",
                            figure_window(256, {0.5F, 0.42F, 0.28F}, model.stream(71)));
  m.rose_glass = add_glass(model, "rose window", rose_window(1024, model.stream(70)));
  return m;
}

}  // namespace church

Model make_church(std::uint32_t seed) {
  using namespace church;  // NOLINT(google-build-using-namespace): the church's own parts
  Model model{.seed = seed};
  const Materials materials = add_materials(model);
  add_floor(model, materials);
  add_walls(model, materials);
  add_apse_walls(model, materials);
  add_columns(model, materials);
  add_vaults(model, materials);
  add_windows(model, materials);
  add_west_door(model, materials);
  add_organ(model, materials);
  add_altar(model, materials);
  add_pulpit(model, materials);
  add_font(model, materials);
  add_pews(model, materials);
  add_statues(model, materials);
  add_aisle_furniture(model, materials);
  add_chandeliers(model, materials);
  add_candles(model, materials);
  model.cameras.push_back({"Nave", {-5.2F, 1.6F, 0.5F}, {radians(92.0), 0.0}});
  return model;
}

}  // namespace foveola::scenes
