#include "study/prediction/noise_atlas.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/error.h"
#include "renderer/base/progress.h"
#include "study/prediction/pilot.h"
#include "study/prediction/table_cache.h"

namespace foveola::study {
namespace {

constexpr double object_convergence = 128.0;  ///< samples a pixel
constexpr PilotLadder object_ladder{};
/// A look around tells one number of a hundred patches: fewer samples will do for each.
constexpr double around_convergence = 16.0;
constexpr PilotLadder around_ladder{.first_per_pixel = 1.0 / 32.0, .rungs = 15, .repetitions = 2};
/// What resampling reads beside a pixel.
constexpr int margin_px = 2;

/// Counted up whenever the tables of the same settings come out differently.
constexpr int tables_version = 2;

/// A cone of directions.
struct Cone {
  Vec3 middle{0.0F};
  double radius_rad = 0.0;
};

/// Uniform over a rectangle of the image that the cone lies in.
std::string crop_around(const Cone& cone) {
  const AzimuthElevation middle = azimuth_elevation(cone.middle);
  const double ratio = std::sin(cone.radius_rad) / std::cos(middle.elevation_rad);
  const bool holds_pole =
      std::abs(middle.elevation_rad) + cone.radius_rad >= 0.5 * std::numbers::pi;
  const double half_width_rad = holds_pole ? std::numbers::pi : std::asin(std::min(1.0, ratio));
  return fmt::format("crop:azimuth={},elevation={},width={},height={}", degrees(middle.azimuth_rad),
                     degrees(middle.elevation_rad), 2.0 * degrees(half_width_rad),
                     2.0 * degrees(cone.radius_rad));
}

void require_predictable(const Protocol& protocol) {
  for (const SceneEntry& scene : protocol.scenes) {
    for (const std::string& method : protocol.methods) {
      if (settings_of(protocol, scene.name, method).film.spare_done_contrast > 0.0) {
        throw Error(protocol.path.string(), "spares pixels that are done (spare_done_contrast)",
                    "simulate it without --predicted");
      }
    }
  }
}

/// An object, ready to be judged.
struct JudgedObject {
  const OfferedObject* object = nullptr;
  std::vector<JudgedView> views;  ///< outline, material
  Cone cone;                      ///< that holds all that is judged
  std::optional<CellMeans> expected;
};

/// The tables of one scene.
class SceneAtlas {
 public:
  SceneAtlas(const AtlasSetting& setting, const std::string& scene, const std::stop_token& stop)
      : setting_(setting),
        scene_(scene),
        stage_(*setting.stages.at(scene)),
        cache_(setting.cache),
        stop_(stop) {
    for (const OfferedObject& object : stage_.objects()) {
      const double radius_deg = std::max(1.0, setting.vision.surround_factor) * object.radius_deg;
      objects_.push_back(
          {.object = &object,
           .views = {view_of_outline(setting.vision, object, setting.protocol.display),
                     view_of_material(setting.vision, object, setting.protocol.display)},
           .cone = {.middle = object.direction,
                    .radius_rad = radians(radius_deg) + cell_reach_rad(object)},
           .expected = std::nullopt});
    }
  }

  std::size_t count() const { return objects_.size(); }

  ObjectNoise noise_of(std::size_t index, const std::string& method) {
    JudgedObject& judged = objects_[index];
    const TrialSettings shown = settings_of(setting_.protocol, scene_, method);
    const std::vector<NoiseTable> tables = known_or(key_of(judged, method, shown), [&] {
      const PilotSetting pilot = pilot_of(shown);
      const SampleMask mask = mask_of(judged.cone, shown.film);
      expect(judged, pilot, mask);
      const auto sampler = make_sampler(setting_.protocol, method);
      sampler->aim(aim_at(judged.object->direction, setting_.protocol.display));
      return measure_noise(pilot, *sampler, object_ladder, mask, judged.views, *judged.expected);
    });
    return {.outline = tables.at(0), .material = tables.at(1)};
  }

  NoiseTable noise_around() {
    const TrialSettings shown =
        settings_of(setting_.protocol, scene_, setting_.protocol.methods.front());
    return known_or(fmt::format("around\n{}", key_of_setting(shown)),
                    [&] { return std::vector<NoiseTable>{measure_around(shown)}; })
        .at(0);
  }

 private:
  template <typename Make>
  std::vector<NoiseTable> known_or(const std::string& key, const Make& make) {
    if (std::optional<std::vector<NoiseTable>> known = cache_.find(key)) {
      return std::move(*known);
    }
    std::vector<NoiseTable> made = make();
    cache_.keep(key, made);
    return made;
  }

  /// How far cells reach beyond the radius that their middles are in.
  double cell_reach_rad(const OfferedObject& object) const {
    const double outline_deg =
        2.0 * object.radius_deg / (2.0 * setting_.vision.recognition_line_pairs);
    return radians(std::numbers::sqrt2 * std::max(outline_deg, setting_.vision.material_cell_deg));
  }

  PilotSetting pilot_of(const TrialSettings& shown) const {
    return {.tracer = stage_.tracer(),
            .workers = setting_.workers,
            .viewpoint = stage_.viewpoint(),
            .film = shown.film,
            .unsampled = shown.fill_unsampled ? UnsampledPixels::filled : UnsampledPixels::black,
            .exposure_stops = stage_.source().exposure_stops,
            .jnd_lab = setting_.vision.jnd_lab,
            .stop = stop_};
  }

  SampleMask mask_of(const Cone& cone, const FilmSettings& film) const {
    SampleMask mask(film.width, film.height);
    mask.add(cone.middle, cone.radius_rad, margin_px, setting_.workers);
    return mask;
  }

  /// Once for all methods: their films differ at most in overrides, which are rare.
  void expect(JudgedObject& judged, const PilotSetting& pilot, const SampleMask& mask) const {
    if (judged.expected) {
      return;
    }
    const auto sampler = make_view_sampler(crop_around(judged.cone));
    sampler->aim(aim_at(judged.object->direction, setting_.protocol.display));
    judged.expected = converged_means(pilot, *sampler, judged.object->direction, object_convergence,
                                      mask, judged.views);
  }

  NoiseTable measure_around(const TrialSettings& shown) const {
    const std::vector<JudgedView> views = views_around(setting_.vision, setting_.protocol.display);
    const std::vector<Cells::Patch> patches = view_cells(setting_.vision).patches();
    SampleMask mask(shown.film.width, shown.film.height);
    for (std::size_t i = 0; i < views.size(); ++i) {
      const double to_corner_rad =
          std::atan(std::numbers::sqrt2 * double{views[i].viewport.half_size().x});
      mask.add(patches[i].direction, to_corner_rad, margin_px, setting_.workers);
    }
    const PilotSetting pilot = pilot_of(shown);
    const auto sampler = make_view_sampler("od");
    const Vec3 ahead(0.0F, 0.0F, -1.0F);
    sampler->aim(aim_at(ahead, setting_.protocol.display));
    const CellMeans expected =
        converged_means(pilot, *sampler, ahead, around_convergence, mask, views);
    return gathered(measure_noise(pilot, *sampler, around_ladder, mask, views, expected), patches);
  }

  /// One table of all views, each standing for a patch.
  static NoiseTable gathered(const std::vector<NoiseTable>& views,
                             const std::vector<Cells::Patch>& patches) {
    NoiseTable table;
    for (std::size_t i = 0; i < views.size(); ++i) {
      if (!views[i].empty()) {
        table.push_back(mean_of(views[i]));
        table.back().direction = patches[i].direction;
        table.back().cells = patches[i].cells;
      }
    }
    return table;
  }

  std::string key_of(const JudgedObject& judged, const std::string& method,
                     const TrialSettings& shown) const {
    std::string key = fmt::format("object {} {} {} radius {}\nmethod {}\n",
                                  judged.object->direction.x, judged.object->direction.y,
                                  judged.object->direction.z, judged.object->radius_deg, method);
    for (const MethodFile& file : setting_.protocol.method_files) {
      if (file.method == method) {
        key += fmt::format("file {} {}\n", file.file, file.sha256);
      }
    }
    return key + key_of_setting(shown);
  }

  std::string key_of_setting(const TrialSettings& shown) const {
    const Vec3 viewpoint = stage_.viewpoint();
    const DisplaySettings& display = setting_.protocol.display;
    const Vision& vision = setting_.vision;
    return fmt::format(
        "tables {}\nscene {}\nviewpoint {} {} {}\nexposure {}\nfilm {}x{} depth {} filled {}\n"
        "display {}x{} {} {} lens {} {} {} {}\n"
        "vision {} {} {} {} {} {} {} coarse {}\n"
        "margin {} objects {} {} {} {} around {} {} {} {}\n",
        tables_version, stage_.key(), viewpoint.x, viewpoint.y, viewpoint.z,
        stage_.source().exposure_stops, shown.film.width, shown.film.height, shown.film.max_depth,
        shown.fill_unsampled, display.view_width, display.view_height, display.horizontal_fov_deg,
        display.vertical_fov_deg, display.lens.axis.x, display.lens.axis.y, display.lens.k1,
        display.lens.k2, vision.jnd_lab, vision.recognition_line_pairs, vision.surround_factor,
        vision.material_cell_deg, vision.view_cell_deg, vision.object_patch_deg,
        vision.view_patch_deg, vision.coarseness, margin_px, object_convergence,
        object_ladder.first_per_pixel, object_ladder.rungs, object_ladder.repetitions,
        around_convergence, around_ladder.first_per_pixel, around_ladder.rungs,
        around_ladder.repetitions);
  }

  const AtlasSetting& setting_;
  std::string scene_;
  const SceneStage& stage_;
  TableCache cache_;
  std::stop_token stop_;
  std::vector<JudgedObject> objects_;
};

std::size_t pilots_in(const AtlasSetting& setting) {
  std::size_t pilots = 0;
  for (const auto& [name, stage] : setting.stages) {
    pilots += 1 + stage->objects().size() * setting.protocol.methods.size();
  }
  return pilots;
}

}  // namespace

NoiseAtlas make_noise_atlas(const AtlasSetting& setting, const std::stop_token& stop) {
  require_predictable(setting.protocol);
  NoiseAtlas atlas;
  Progress progress("Pilot renders");
  const auto pilots = static_cast<double>(pilots_in(setting));
  double done = 0.0;
  for (const auto& [name, stage] : setting.stages) {
    SceneAtlas scene(setting, name, stop);
    atlas.around[name] = scene.noise_around();
    progress.update(++done / pilots, name);
    for (std::size_t i = 0; i < scene.count(); ++i) {
      for (const std::string& method : setting.protocol.methods) {
        atlas.objects[{name, method, stage->objects()[i].name}] = scene.noise_of(i, method);
        progress.update(++done / pilots, name);
      }
    }
  }
  return atlas;
}

}  // namespace foveola::study
