// Everything that the school room is made of.
#include "scenes/modelling/patterns.h"
#include "scenes/schoolroom/parts.h"
#include "scenes/schoolroom/patterns.h"

namespace foveola::scenes::school {
namespace {

int add_paint(Model& model, const char* name, const Rgb& color, float roughness) {
  return add_material(model, {.name = name, .base_color = color, .roughness = roughness});
}

int add_metal(Model& model, const char* name, const Rgb& color, float roughness) {
  return add_material(
      model, {.name = name, .base_color = color, .metallic = 1.0F, .roughness = roughness});
}

/// Cloth of one colour that is seen from both sides.
int add_cloth(Model& model, const char* name, const Rgb& ground, const Rgb& stripe, int stripes,
              const Seed& seed) {
  const int image = add_image(model, cloth(512, stripes, ground, stripe, seed));
  return add_material(model, {.name = name,
                              .base_color = Rgb(1.0F),
                              .roughness = 0.95F,
                              .base_color_image = image,
                              .double_sided = true});
}

int add_two_sided(Model& model, const char* name, Image image) {
  const int index = add_image(model, std::move(image));
  return add_material(model, {.name = name,
                              .base_color = Rgb(1.0F),
                              .roughness = 0.9F,
                              .base_color_image = index,
                              .double_sided = true});
}

void add_room_materials(Model& model, Materials& m) {
  m.parquet = add_textured_material(model, "parquet", parquet(2048, 32, model.stream(401)), 0.35F);
  m.ceiling = add_textured_material(model, "ceiling panels",
                                    ceiling_panels(1024, 2, model.stream(402)), 0.95F);
  m.wall = add_textured_material(
      model, "wall", plaster(512, {0.72F, 0.67F, 0.54F}, 0.07, model.stream(403)), 0.95F);
  m.dado = add_textured_material(model, "dado",
                                 plaster(512, {0.24F, 0.36F, 0.3F}, 0.1, model.stream(404)), 0.4F);
  m.white_paint = add_paint(model, "white paint", {0.74F, 0.73F, 0.69F}, 0.4F);
  m.stone = add_textured_material(model, "sill stone",
                                  plaster(512, {0.5F, 0.48F, 0.45F}, 0.5, model.stream(405)), 0.3F);
  m.radiator = add_paint(model, "radiator enamel", {0.7F, 0.67F, 0.58F}, 0.35F);
  m.curtain =
      add_cloth(model, "curtain", {0.62F, 0.45F, 0.2F}, {0.5F, 0.2F, 0.1F}, 5, model.stream(406));
  m.lamp = add_material(
      model, {.name = "opal glass", .base_color = Rgb(0.8F), .emission = {24.0F, 22.0F, 18.5F}});
}

void add_furniture_materials(Model& model, Materials& m) {
  m.desk_top = add_textured_material(
      model, "desk top",
      wood(1024, 3, {0.52F, 0.36F, 0.19F}, {0.38F, 0.23F, 0.1F}, model.stream(410)), 0.35F);
  m.plywood = add_textured_material(
      model, "plywood",
      wood(512, 2, {0.55F, 0.37F, 0.19F}, {0.42F, 0.25F, 0.11F}, model.stream(411)), 0.4F);
  m.dark_wood = add_textured_material(
      model, "dark wood",
      wood(1024, 4, {0.22F, 0.11F, 0.05F}, {0.1F, 0.05F, 0.025F}, model.stream(412)), 0.35F);
  m.steel = add_metal(model, "steel", Rgb(0.6F), 0.35F);
  m.green_steel = add_paint(model, "green enamel", {0.06F, 0.16F, 0.14F}, 0.35F);
  m.black_plastic = add_paint(model, "black plastic", Rgb(0.025F), 0.4F);
  m.brass = add_metal(model, "brass", {0.72F, 0.52F, 0.24F}, 0.3F);
}

void add_printed_materials(Model& model, Materials& m) {
  m.board_middle =
      add_textured_material(model, "board, middle", board_middle(1024, model.stream(71)), 0.85F);
  m.board_left =
      add_textured_material(model, "board, left", board_left(1024, model.stream(75)), 0.85F);
  m.board_right =
      add_textured_material(model, "board, right", board_right(1024, model.stream(76)), 0.85F);
  m.chalk = add_paint(model, "chalk", Rgb(0.85F), 1.0F);
  m.wall_map = add_textured_material(model, "wall map", wall_map(1024), 0.7F);
  m.globe = add_textured_material(model, "globe", world(512), 0.25F);
  m.spines = add_textured_material(model, "book covers", book_spines(512, model.stream(72)), 0.55F);
  m.paper = add_paint(model, "paper", {0.78F, 0.75F, 0.66F}, 0.95F);
  m.page = add_textured_material(model, "page", written_page(1024, model.stream(420)), 0.95F);
  m.other_page =
      add_textured_material(model, "other page", written_page(1024, model.stream(421)), 0.95F);
  m.notices = add_two_sided(model, "notices", notices(1024, model.stream(80)));
  m.drawings = add_two_sided(model, "drawings", drawings(1024, model.stream(90)));
  m.alphabet = add_textured_material(model, "alphabet", alphabet_strip(128), 0.8F);
  m.clock = add_textured_material(model, "clock face", clock_face(512), 0.4F);
  m.cork = add_textured_material(
      model, "cork", plaster(512, {0.42F, 0.26F, 0.13F}, 0.8, model.stream(422)), 0.95F);
}

void add_colours(Model& model, Materials& m) {
  m.red = add_paint(model, "red", {0.5F, 0.05F, 0.04F}, 0.35F);
  m.blue = add_paint(model, "blue", {0.05F, 0.13F, 0.45F}, 0.35F);
  m.yellow = add_paint(model, "yellow", {0.75F, 0.5F, 0.06F}, 0.45F);
  m.green = add_paint(model, "green", {0.06F, 0.3F, 0.09F}, 0.35F);
  m.bone = add_paint(model, "bone", {0.72F, 0.66F, 0.52F}, 0.45F);
  m.red_cloth = add_cloth(model, "red cloth", {0.48F, 0.05F, 0.04F}, {0.48F, 0.05F, 0.04F}, 1,
                          model.stream(430));
  m.blue_cloth = add_cloth(model, "blue cloth", {0.07F, 0.13F, 0.32F}, {0.07F, 0.13F, 0.32F}, 1,
                           model.stream(431));
  m.grey_cloth = add_cloth(model, "grey cloth", {0.2F, 0.21F, 0.2F}, {0.3F, 0.28F, 0.2F}, 4,
                           model.stream(432));
  m.plant = add_plant_materials(model);
}

void add_outside_materials(Model& model, Materials& m) {
  m.grass = add_textured_material(model, "grass",
                                  plaster(512, {0.1F, 0.2F, 0.045F}, 0.7, model.stream(440)), 1.0F);
  m.paving = add_textured_material(
      model, "paving",
      floor_tiles(512, 4, {0.4F, 0.38F, 0.35F}, {0.36F, 0.35F, 0.33F}, model.stream(441)), 0.9F);
  m.facade = add_textured_material(model, "facade", facade(1024, model.stream(73)), 0.9F);
  m.roof = add_textured_material(model, "roof tiles",
                                 masonry(512,
                                         {.courses = 10,
                                          .stones = 14,
                                          .joint = 0.12,
                                          .variation = 0.35,
                                          .stone = {0.3F, 0.1F, 0.06F},
                                          .mortar = {0.08F, 0.04F, 0.03F}},
                                         model.stream(442)),
                                 0.9F);
  m.bark = add_textured_material(
      model, "bark", wood(256, 1, {0.18F, 0.13F, 0.09F}, {0.08F, 0.055F, 0.04F}, model.stream(443)),
      0.95F);
  const int leaf_image = add_image(model, leaf(128, {0.12F, 0.26F, 0.05F}, model.stream(444)));
  m.foliage = add_material(model, {.name = "foliage",
                                   .base_color = Rgb(1.0F),
                                   .roughness = 0.8F,
                                   .base_color_image = leaf_image,
                                   .alpha_cutoff = 0.5F,
                                   .double_sided = true});
}

}  // namespace

Materials add_materials(Model& model) {
  Materials m;
  add_room_materials(model, m);
  add_furniture_materials(model, m);
  add_printed_materials(model, m);
  add_colours(model, m);
  add_outside_materials(model, m);
  return m;
}

}  // namespace foveola::scenes::school
