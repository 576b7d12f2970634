#include <cmath>
#include <utility>

#include "scenes/modelling/canvas.h"
#include "scenes/modelling/patterns.h"
#include "scenes/studio_car/studio.h"

namespace foveola::scenes {
namespace {

int metal(Model& model, const char* name, const Rgb& color, float roughness) {
  return add_material(
      model, {.name = name, .base_color = color, .metallic = 1.0F, .roughness = roughness});
}

int plain(Model& model, const char* name, const Rgb& color, float roughness) {
  return add_material(model, {.name = name, .base_color = color, .roughness = roughness});
}

/// Black letters on white inside a black line.
Image number_plate(int height) {
  const double unit = height / 110.0;
  Canvas canvas(blank(height * 52 / 11, height, DVec3(236.0, 236.0, 228.0)));
  const Pen line{Ink{DVec3(16.0)}, 2.5 * unit};
  const double right = canvas.width() - 6.0 * unit;
  const double low = height - 6.0 * unit;
  canvas.draw_lines({{6.0 * unit, 6.0 * unit},
                     {right, 6.0 * unit},
                     {right, low},
                     {6.0 * unit, low},
                     {6.0 * unit, 6.0 * unit}},
                    line);
  canvas.fill_rectangle({8.0 * unit, 8.0 * unit}, {50.0 * unit, low - 2.0 * unit},
                        Ink{DVec3(28.0, 74.0, 130.0)});
  canvas.write("STUDIO", {11.0 * unit, 94.0 * unit},
               {.pen = {Ink{DVec3(240.0)}, 1.3 * unit}, .height = 8.0 * unit});
  canvas.write("FV 0360", {72.0 * unit, 87.0 * unit},
               {.pen = {Ink{DVec3(18.0)}, 9.5 * unit}, .height = 64.0 * unit});
  return std::move(canvas).finished();
}

/// What a tethered camera's software shows: a picture, a histogram, lists of values.
Image display(int height) {
  Canvas canvas(blank(height * 16 / 10, height, DVec3(34.0, 36.0, 40.0)));
  const double unit = height / 100.0;
  canvas.fill_rectangle({4.0 * unit, 8.0 * unit}, {112.0 * unit, 78.0 * unit},
                        Ink{DVec3(150.0, 152.0, 156.0)});
  canvas.fill_polygon({{18.0 * unit, 60.0 * unit},
                       {24.0 * unit, 46.0 * unit},
                       {44.0 * unit, 42.0 * unit},
                       {58.0 * unit, 32.0 * unit},
                       {78.0 * unit, 33.0 * unit},
                       {92.0 * unit, 44.0 * unit},
                       {100.0 * unit, 48.0 * unit},
                       {101.0 * unit, 60.0 * unit}},
                      Ink{DVec3(30.0, 62.0, 132.0)});
  for (const double x : {34.0, 84.0}) {
    canvas.fill_circle({x * unit, 60.0 * unit}, 9.0 * unit, Ink{DVec3(22.0)});
    canvas.fill_circle({x * unit, 60.0 * unit}, 5.5 * unit, Ink{DVec3(170.0)});
  }
  std::vector<DVec2> histogram = {{118.0 * unit, 34.0 * unit}};
  for (int i = 0; i <= 36; ++i) {
    const double height_share = 0.5 + 0.5 * std::sin(0.35 * i) * std::sin(0.12 * i + 0.4);
    histogram.emplace_back((118.0 + i) * unit, (34.0 - 22.0 * height_share) * unit);
  }
  histogram.emplace_back(154.0 * unit, 34.0 * unit);
  canvas.fill_polygon(histogram, Ink{DVec3(190.0)});
  const Pen text{Ink{DVec3(205.0)}, 0.8 * unit};
  double y = 46.0;
  for (const char* row : {"ISO 100", "1/125 s", "f/11", "85 mm", "5600 K"}) {
    canvas.write(row, {119.0 * unit, y * unit}, {.pen = text, .height = 4.5 * unit});
    y += 8.0;
  }
  for (int i = 0; i < 8; ++i) {
    canvas.fill_rectangle({(4.0 + 19.0 * i) * unit, 84.0 * unit},
                          {(21.0 + 19.0 * i) * unit, 96.0 * unit},
                          Ink{DVec3(90.0 + 12.0 * i, 96.0, 128.0 - 8.0 * i)});
  }
  return std::move(canvas).finished();
}

}  // namespace

CarMaterials add_car_materials(Model& model) {
  CarMaterials m;
  m.paint = add_material(model, {.name = "metallic paint",
                                 .base_color = {0.05F, 0.14F, 0.42F},
                                 .metallic = 0.7F,
                                 .roughness = 0.38F,
                                 .clearcoat = 1.0F,
                                 .double_sided = true});
  const auto glass = [&](const char* name, const Rgb& color, float transmission) {
    return add_material(model, {.name = name,
                                .base_color = color,
                                .roughness = 0.0F,
                                .transmission = transmission,
                                .double_sided = true});
  };
  m.glass = glass("tinted glass", {0.55F, 0.62F, 0.6F}, 1.0F);
  m.lamp_glass = glass("lamp glass", Rgb(0.95F), 1.0F);
  m.red_glass = glass("red glass", {0.75F, 0.02F, 0.02F}, 1.0F);
  m.rubber = plain(model, "rubber", Rgb(0.022F), 0.7F);
  m.alloy = metal(model, "alloy", Rgb(0.68F), 0.28F);
  m.chrome = metal(model, "chrome", Rgb(0.82F), 0.08F);
  m.mirror = metal(model, "mirror", Rgb(0.9F), 0.02F);
  m.iron = metal(model, "brake disc", Rgb(0.42F), 0.35F);
  m.black_plastic = add_material(model, {.name = "black plastic",
                                         .base_color = Rgb(0.025F),
                                         .roughness = 0.55F,
                                         .double_sided = true});
  m.gloss_black = plain(model, "gloss black", Rgb(0.012F), 0.12F);
  m.lamp = add_material(model,
                        {.name = "lamp", .base_color = Rgb(0.8F), .emission = {5.0F, 5.2F, 5.5F}});
  m.red_lamp = add_material(
      model,
      {.name = "red lamp", .base_color = {0.6F, 0.02F, 0.02F}, .emission = {2.5F, 0.1F, 0.06F}});
  m.screen = add_textured_material(model, "dashboard screen", display(200), 0.2F);
  m.leather = add_textured_material(model, "dark leather",
                                    plaster(256, Rgb(0.035F), 0.4, model.stream(41)), 0.5F);
  m.stitched_leather = add_textured_material(
      model, "tan leather", plaster(256, {0.32F, 0.15F, 0.065F}, 0.3, model.stream(42)), 0.45F);
  m.lining = plain(model, "lining", Rgb(0.3F), 0.95F);
  m.carpet = plain(model, "carpet", Rgb(0.03F), 1.0F);
  m.caliper = plain(model, "caliper", {0.55F, 0.02F, 0.015F}, 0.25F);
  m.number_plate = add_textured_material(model, "number plate", number_plate(220), 0.35F);
  return m;
}

namespace studio {

Materials add_materials(Model& model) {
  Materials m;
  m.concrete =
      add_textured_material(model, "polished concrete",
                            plaster(1024, {0.36F, 0.35F, 0.335F}, 0.4, model.stream(31)), 0.3F);
  m.brick = add_textured_material(model, "painted brick",
                                  masonry(1024,
                                          {.courses = 16,
                                           .stones = 6,
                                           .joint = 0.08,
                                           .variation = 0.12,
                                           .stone = {0.5F, 0.49F, 0.47F},
                                           .mortar = {0.42F, 0.41F, 0.39F}},
                                          model.stream(32)),
                                  0.85F);
  m.ceiling = add_textured_material(model, "ceiling",
                                    plaster(512, Rgb(0.5F), 0.1, model.stream(33)), 0.95F);
  m.backdrop = add_material(model, {.name = "backdrop",
                                    .base_color = {0.62F, 0.6F, 0.57F},
                                    .roughness = 0.9F,
                                    .double_sided = true});
  m.turntable = plain(model, "turntable", Rgb(0.13F), 0.18F);
  m.steel = metal(model, "steel", Rgb(0.55F), 0.35F);
  m.black_steel = plain(model, "black steel", Rgb(0.03F), 0.35F);
  m.black_cloth = plain(model, "black cloth", Rgb(0.03F), 1.0F);
  m.black_laminate = add_textured_material(model, "laminate",
                                           plaster(256, Rgb(0.035F), 0.35, model.stream(35)), 0.4F);
  m.red_lacquer = add_material(model, {.name = "red lacquer",
                                       .base_color = {0.5F, 0.03F, 0.02F},
                                       .roughness = 0.4F,
                                       .clearcoat = 0.8F});
  m.aluminium = metal(model, "aluminium", Rgb(0.8F), 0.4F);
  m.galvanised = metal(model, "galvanised steel", Rgb(0.6F), 0.5F);
  m.white_paint = plain(model, "white paint", Rgb(0.75F), 0.5F);
  m.wood = add_textured_material(
      model, "wood", wood(512, 6, {0.4F, 0.25F, 0.13F}, {0.22F, 0.12F, 0.06F}, model.stream(34)),
      0.5F);
  m.cable = plain(model, "cable", Rgb(0.02F), 0.5F);
  m.sandbag = plain(model, "sandbag", {0.5F, 0.16F, 0.03F}, 0.9F);
  m.camera_body = plain(model, "camera body", Rgb(0.025F), 0.45F);
  m.lens = add_material(model, {.name = "lens coating",
                                .base_color = {0.02F, 0.01F, 0.04F},
                                .roughness = 0.05F,
                                .clearcoat = 1.0F});
  m.display = add_textured_material(model, "display", display(512), 0.2F);
  m.poster = add_textured_material(model, "poster", landscape(512, model.stream(36)), 0.3F);
  m.clock = add_textured_material(model, "clock", clock_face(256), 0.4F);
  m.softbox = add_material(model, {.name = "softbox", .emission = Rgb(13.0F)});
  m.warm_softbox = add_material(model, {.name = "warm softbox", .emission = {14.0F, 11.5F, 9.0F}});
  m.work_light = add_material(model, {.name = "work light", .emission = {6.0F, 6.5F, 7.0F}});
  m.plant = add_plant_materials(model);
  m.car = add_car_materials(model);
  return m;
}

}  // namespace studio
}  // namespace foveola::scenes
