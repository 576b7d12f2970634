// A scene of one wall with an object on it, and studies of it that take no time.
#pragma once

#include <string>

#include "renderer/base/scene_source.h"
#include "tests/temporary_folder.h"

namespace foveola::study {

/// A wall with a square before it, whose shadow a large lamp makes noisy.
inline SceneSource wall_with_a_square(const test::TemporaryFolder& folder) {
  SceneSource source;
  source.name = "wall";
  folder.write("wall.mtl", "newmtl bright\nKd 0.8 0.8 0.7\nnewmtl dark\nKd 0.2 0.1 0.1\n");
  source.file = folder.write("wall.obj",
                             "mtllib wall.mtl\n"
                             "v -9 -9 -2\nv 9 -9 -2\nv 9 9 -2\nv -9 9 -2\n"
                             "v -.3 -.3 -1.5\nv .3 -.3 -1.5\nv .3 .3 -1.5\nv -.3 .3 -1.5\n"
                             "usemtl bright\nf 1 2 3\nf 1 3 4\n"
                             "usemtl dark\nf 5 6 7\nf 5 7 8\n");
  source.camera_position = Vec3(0.0F);
  source.environment_radiance = Rgb(0.2F);
  source.lights = {{.center = {1.0F, 1.5F, 0.0F},
                    .size = {2.0F, 2.0F},
                    .normal = {0.0F, 0.0F, -1.0F},
                    .radiance = Rgb(2.0F)}};
  source.objects = {{.name = "square", .position = {0.0F, 0.0F, -1.5F}, .radius_deg = 12.0F}};
  return source;
}

/// A study of it in two methods, with so many samples a second and marks that are waited for.
inline std::string wall_protocol_text(int samples_per_second, double mark_timeout_s) {
  return "name = \"wall\"\ntitle = \"A study of a wall\"\nscenes = [\"wall\"]\n"
         "methods = [\"od\", \"fv\"]\nphases = [\"trials\"]\n"
         "[machine]\nsamples_per_second = " +
         std::to_string(samples_per_second) +
         "\nframe_rate_hz = 20\n[film]\nwidth = 128\nheight = 64\nmax_depth = 1\n"
         "[display]\nview_width = 48\nview_height = 48\nfov_deg = 100\n"
         "[timing]\nrating_s = 0.4\nmark_timeout_s = " +
         std::to_string(mark_timeout_s) +
         "\n[reference]\nsamples_per_pixel = 64\nsamples_per_object = 200000\n";
}

}  // namespace foveola::study
