// The meeting room's materials, and its assembly.
#include "scenes/builtin.h"
#include "scenes/meeting_room/parts.h"
#include "scenes/meeting_room/patterns.h"
#include "scenes/modelling/patterns.h"

namespace foveola::scenes {
namespace meeting {
namespace {

void add_surfaces(Model& model, Materials& m) {
  m.floor = add_textured_material(
      model, "floor boards",
      wood(1024, 12, {0.42F, 0.26F, 0.13F}, {0.24F, 0.13F, 0.06F}, model.stream(21)), 0.35F);
  m.ceiling = add_textured_material(model, "ceiling panels",
                                    ceiling_panels(1024, 2, model.stream(22)), 0.95F);
  m.wall = add_textured_material(
      model, "wall", plaster(512, {0.68F, 0.65F, 0.58F}, 0.06, model.stream(23)), 0.95F);
  m.accent_wall = add_textured_material(
      model, "accent wall", plaster(512, {0.2F, 0.33F, 0.36F}, 0.08, model.stream(24)), 0.95F);
  m.table = add_textured_material(
      model, "table top",
      wood(1024, 6, {0.36F, 0.17F, 0.07F}, {0.17F, 0.07F, 0.03F}, model.stream(25)), 0.2F);
  m.dark_wood = add_textured_material(
      model, "dark wood",
      wood(512, 2, {0.11F, 0.06F, 0.035F}, {0.05F, 0.03F, 0.02F}, model.stream(26)), 0.45F);
  m.light_wood = add_textured_material(
      model, "light wood",
      wood(512, 2, {0.5F, 0.34F, 0.19F}, {0.32F, 0.2F, 0.1F}, model.stream(31)), 0.4F);
  m.fabric = add_textured_material(
      model, "fabric", cloth(512, 1, {0.1F, 0.16F, 0.28F}, {0.1F, 0.16F, 0.28F}, model.stream(27)),
      0.95F);
  m.red_fabric = add_textured_material(
      model, "red fabric",
      cloth(512, 1, {0.5F, 0.06F, 0.04F}, {0.5F, 0.06F, 0.04F}, model.stream(28)), 0.95F);
}

void add_plain(Model& model, Materials& m) {
  const auto add = [&](const char* name, const Rgb& color, float roughness) {
    return add_material(model, {.name = name, .base_color = color, .roughness = roughness});
  };
  m.dark_piping = add("piping", Rgb(0.02F), 0.6F);
  m.chrome = add_material(
      model, {.name = "chrome", .base_color = Rgb(0.75F), .metallic = 1.0F, .roughness = 0.2F});
  m.aluminium = add_material(
      model, {.name = "aluminium", .base_color = Rgb(0.62F), .metallic = 1.0F, .roughness = 0.45F});
  m.white_plastic = add("white plastic", Rgb(0.7F), 0.4F);
  m.grey_plastic = add("grey plastic", Rgb(0.22F), 0.4F);
  m.black_plastic = add("black plastic", Rgb(0.03F), 0.45F);
  m.porcelain = add("porcelain", {0.7F, 0.68F, 0.62F}, 0.15F);
  m.coffee = add("coffee", {0.03F, 0.014F, 0.007F}, 0.1F);
  m.paper = add("paper", {0.75F, 0.73F, 0.66F}, 1.0F);
  m.red = add("red plastic", {0.5F, 0.03F, 0.025F}, 0.35F);
  m.blue = add("blue plastic", {0.03F, 0.09F, 0.35F}, 0.35F);
  m.green = add("green plastic", {0.03F, 0.25F, 0.08F}, 0.35F);
  m.glass = add_material(model, {.name = "glass",
                                 .base_color = {0.96F, 0.98F, 0.97F},
                                 .roughness = 0.0F,
                                 .transmission = 1.0F,
                                 .double_sided = true});
  m.blind = add_material(
      model, {.name = "blind", .base_color = Rgb(0.72F), .roughness = 0.4F, .double_sided = true});
  m.plant = add_plant_materials(model);
}

void add_pictures_and_lights(Model& model, Materials& m) {
  m.page = add_textured_material(model, "printed page", printed_page(512), 0.9F);
  m.board = add_textured_material(model, "whiteboard", discussed_board(1024), 0.3F);
  m.flip_chart = add_textured_material(model, "flip chart", flip_chart_sheet(768), 0.9F);
  m.picture = add_textured_material(model, "picture", landscape(512, model.stream(30)), 0.6F);
  m.abstract_picture = add_textured_material(model, "abstract picture",
                                             abstract_painting(512, model.stream(32)), 0.6F);
  m.clock = add_textured_material(model, "clock face", clock_face(512), 0.5F);
  const int desktop = add_image(model, laptop_desktop(512));
  m.screen = add_material(model, {.name = "screen",
                                  .base_color = Rgb(1.0F),
                                  .roughness = 0.3F,
                                  .emission = {0.1F, 0.12F, 0.16F},
                                  .base_color_image = desktop});
  m.lamp = add_material(model, {.name = "lamp", .emission = {4.6F, 4.3F, 3.9F}});
  m.daylight = add_material(model, {.name = "daylight", .emission = {2.6F, 3.1F, 3.8F}});
  m.far_building = add_material(model, {.name = "far building", .emission = {0.85F, 0.95F, 1.1F}});
  m.near_building =
      add_material(model, {.name = "near building", .emission = {0.5F, 0.47F, 0.42F}});
}

}  // namespace

Materials add_materials(Model& model) {
  Materials m;
  add_surfaces(model, m);
  add_plain(model, m);
  add_pictures_and_lights(model, m);
  return m;
}

}  // namespace meeting

Model make_meeting_room(std::uint32_t seed) {
  using namespace meeting;  // NOLINT(google-build-using-namespace): the room's own parts
  Model model{.seed = seed};
  const Materials materials = add_materials(model);
  add_shell(model, materials);
  add_ceiling(model, materials);
  add_windows(model, materials);
  add_door(model, materials);
  add_table(model, materials);
  add_chairs(model, materials);
  add_laptops(model, materials);
  add_tableware(model, materials);
  add_papers(model, materials);
  add_conference_phone(model, materials);
  add_whiteboard(model, materials);
  add_flip_chart(model, materials);
  add_wall_things(model, materials);
  add_cabinet(model, materials);
  add_plants(model, materials);
  add_projector(model, materials);
  model.cameras.push_back({"Seat side", {-4.2F, 1.55F, 1.9F}, {radians(68.0), 0.0}});
  return model;
}

}  // namespace foveola::scenes
