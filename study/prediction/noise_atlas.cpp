#include "study/prediction/noise_atlas.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/error.h"
#include "renderer/base/work/work_scope.h"
#include "study/prediction/aim_dependence.h"
#include "study/prediction/pilot.h"

namespace foveola::study {
namespace {

/// For an object at full size: samples per pixel of each of its two converged pictures, and the
/// maximum number of noisy ones. A scaled film has so few pixels that more of both are needed.
constexpr double object_convergence = 8.0;
constexpr double object_pictures = 4.0;

/// A rating averages many places, so that fewer samples per place suffice.
constexpr double surround_convergence = 4.0;
constexpr SampleCountLevels pilot_levels{};
/// Pixels beside its own that resampling reads.
constexpr int margin_px = 2;

/// Incremented whenever the same settings give different tables.
constexpr int tables_version = 7;

void require_predictable(const Protocol& protocol) {
  for (const SceneEntry& scene : protocol.scenes) {
    for (const std::string& method : protocol.methods) {
      if (settings_of(protocol, scene.name, method).film.adaptive_contrast > 0.0) {
        throw Error(protocol.path.string(), "asks for adaptive sampling (adaptive_contrast)",
                    "simulate it without --predicted");
      }
    }
  }
}

struct JudgedObject {
  const OfferedObject* object = nullptr;
  JudgedView view;
  Cone cone;  ///< cone around all judged cells
  /// By the display settings.
  std::map<std::string, ConvergedMeans> expected;
};

std::vector<const OfferedObject*> wanted_objects(const AtlasSetting& setting,
                                                 const std::string& scene) {
  std::vector<const OfferedObject*> wanted;
  for (const OfferedObject& object : setting.stages.at(scene)->objects()) {
    const auto is_of_object = [&](const auto& pictures) {
      const auto& [wanted_scene, method, name] = pictures.first;
      return wanted_scene == scene && name == object.name;
    };
    if (std::ranges::any_of(setting.wanted, is_of_object)) {
      wanted.push_back(&object);
    }
  }
  return wanted;
}

/// Number of a scene's independent items: its surround, and each such object.
std::int64_t item_count(const AtlasSetting& setting, const std::string& scene) {
  return 1 + std::ssize(wanted_objects(setting, scene));
}

class SceneAtlas {
 public:
  SceneAtlas(const AtlasSetting& setting, const std::string& scene, const std::stop_token& stop)
      : setting_(setting),
        scene_(scene),
        stage_(*setting.stages.at(scene)),
        cache_(setting.cache),
        stop_(stop) {
    for (const OfferedObject* const object : wanted_objects(setting, scene)) {
      const double radius_deg = std::max(1.0, setting.vision.surround_factor) * object->radius_deg;
      objects_.push_back({.object = object,
                          .view = view_of_object(setting.vision, *object, setting.protocol.display),
                          .cone = {.middle = object->direction,
                                   .radius_rad = radians(radius_deg) + cell_reach_rad(*object)},
                          .expected = {}});
    }
  }

  /// Makes the items that are not in the cache, the surround and then the objects. Returns their
  /// number. progress: called with the fraction done.
  std::int64_t make(const ItemRange& items, const std::function<void(double)>& progress) {
    std::int64_t made = 0;
    if (items.begin == 0 && items.end > 0) {
      made += make_surround() ? 1 : 0;
    }
    const double steps = 1.0 + static_cast<double>(setting_.protocol.methods.size());
    double done = 1.0;
    progress(done / steps);
    const ItemRange objects{.begin = std::max<std::int64_t>(0, items.begin - 1),
                            .end = std::max<std::int64_t>(0, items.end - 1)};
    std::set<std::size_t> objects_made;
    for (const std::string& method : setting_.protocol.methods) {
      make_objects(method, objects, objects_made);
      progress(++done / steps);
    }
    return made + std::ssize(objects_made);
  }

  /// Adds all items, which must have been made.
  void add_to(NoiseAtlas& atlas) const {
    atlas.surround[scene_] = known_.at(key_of_surround());
    for (const std::string& method : setting_.protocol.methods) {
      for (const auto& [picture, objects] : wanted_pictures(method)) {
        for (const std::size_t i : objects) {
          const ScaleTables& tables = known_.at(key_of(objects_[i], method, picture));
          atlas.objects[{scene_, method, objects_[i].object->name}][picture] = {
              .outline = tables.front(), .material = {tables.begin() + 1, tables.end()}};
        }
      }
    }
  }

 private:
  /// Returns whether it was not in the cache.
  bool make_surround() {
    const std::string key = key_of_surround();
    if (is_known(key)) {
      return false;
    }
    keep(key, measure_surround(shown_with(first_method())));
    return true;
  }

  /// Makes the wanted pictures of some objects with `method`. Their noise is that of the protocol's
  /// first method after as many samples in the same place. Methods differ in the places of their
  /// samples, and hardly in the noise of a given number of samples. One pilot serves all objects if
  /// the first method's samples do not depend on the object.
  void make_objects(const std::string& method, const ItemRange& objects,
                    std::set<std::size_t>& made) {
    const auto sampler = make_sampler(setting_.protocol, first_method());
    for (const auto& [picture, wanted] : wanted_pictures(method)) {
      std::vector<std::size_t> unknown;
      for (const std::size_t i : wanted) {
        const auto number = static_cast<std::int64_t>(i);
        if (number >= objects.begin && number < objects.end &&
            !is_known(key_of(objects_[i], method, picture))) {
          unknown.push_back(i);
        }
      }
      const bool together = unknown.size() > 1 && goes_everywhere_alike(*sampler);
      const std::size_t step = together ? unknown.size() : 1;
      for (std::size_t first = 0; first < unknown.size(); first += step) {
        const std::span<const std::size_t> group(&unknown[first], step);
        const std::vector<ScaleTables> tables = measure(group, method, picture, *sampler);
        for (std::size_t i = 0; i < group.size(); ++i) {
          keep(key_of(objects_[group[i]], method, picture), tables[i]);
        }
      }
      made.insert(unknown.begin(), unknown.end());
    }
  }

  bool goes_everywhere_alike(ViewSampler& sampler) const {
    const Vec3 ahead = objects_.front().object->direction;
    return !follows_aim(sampler, aim_to(ahead), aim_to(-ahead));
  }

  /// Returns whether they are in the cache. Methods with the same display share tables, which are
  /// read once.
  bool is_known(const std::string& key) {
    if (known_.contains(key)) {
      return true;
    }
    std::optional<ScaleTables> cached = cache_.find(key);
    if (cached) {
      known_.emplace(key, std::move(*cached));
    }
    return cached.has_value();
  }

  void keep(const std::string& key, const ScaleTables& tables) {
    cache_.keep(key, tables);
    known_[key] = tables;
  }

  /// Returns the objects of each wanted picture, by the picture's number.
  std::map<std::uint32_t, std::vector<std::size_t>> wanted_pictures(
      const std::string& method) const {
    std::map<std::uint32_t, std::vector<std::size_t>> wanted;
    for (std::size_t i = 0; i < objects_.size(); ++i) {
      const auto found = setting_.wanted.find({scene_, method, objects_[i].object->name});
      if (found != setting_.wanted.end()) {
        for (const std::uint32_t picture : found->second) {
          wanted[picture].push_back(i);
        }
      }
    }
    return wanted;
  }

  const std::string& first_method() const { return setting_.protocol.methods.front(); }

  double coarseness() const { return setting_.vision.coarseness; }

  TrialSettings shown_with(const std::string& method) const {
    return settings_of(setting_.protocol, scene_, method);
  }

  Aim aim_to(const Vec3& direction) const { return aim_at(direction, setting_.protocol.display); }

  /// Returns the tables of some objects in one picture, with samples aimed at the first of them.
  std::vector<ScaleTables> measure(std::span<const std::size_t> group, const std::string& method,
                                   std::uint32_t picture, ViewSampler& sampler) {
    const TrialSettings shown = shown_with(method);
    const PilotSetting pilot = pilot_of(shown);
    SampleMask mask(shown.film.width, shown.film.height);
    std::vector<JudgedView> views;
    ConvergedMeans expected;
    for (const std::size_t i : group) {
      JudgedObject& judged = objects_[i];
      mask.add(judged.cone.middle, judged.cone.radius_rad, margin_px, setting_.workers);
      views.push_back(judged.view);
      const ConvergedMeans& means = expected_of(judged, shown);
      expected.first.push_back(means.first.front());
      expected.second.push_back(means.second.front());
    }
    sampler.aim(aim_to(objects_[group.front()].object->direction));
    return measure_noise(pilot, sampler, pilot_levels, picture, mask, views, expected);
  }

  /// Distance by which cells exceed the radius of their centres.
  double cell_reach_rad(const OfferedObject& object) const {
    const Vision& vision = setting_.vision;
    const double outline_deg = object.radius_deg / vision.recognition_line_pairs;
    const double material_deg = scales_deg(vision, vision.material_cell_deg).back();
    return radians(0.5 * std::numbers::sqrt2 * std::max(outline_deg, material_deg));
  }

  PilotSetting pilot_of(const TrialSettings& shown) const {
    return {.tracer = stage_.tracer(),
            .workers = setting_.workers,
            .viewpoint = stage_.viewpoint(),
            .film = shown.film,
            .unsampled = shown.fill_unsampled ? UnsampledPixels::filled : UnsampledPixels::black,
            .exposure_stops = stage_.source().exposure_stops.value_or(0.0),
            .jnd_lab = setting_.vision.jnd_lab,
            .stop = stop_};
  }

  /// Computed once for all methods with the same display.
  const ConvergedMeans& expected_of(JudgedObject& judged, const TrialSettings& shown) const {
    const auto [found, is_new] = judged.expected.try_emplace(key_of_setting(shown));
    if (is_new) {
      found->second = converged(judged, pilot_of(shown));
    }
    return found->second;
  }

  ConvergedMeans converged(const JudgedObject& judged, const PilotSetting& pilot) const {
    SampleMask mask(pilot.film.width, pilot.film.height);
    mask.add(judged.cone.middle, judged.cone.radius_rad, margin_px, setting_.workers);
    const auto sampler = make_view_sampler(crop_sampler(judged.cone));
    sampler->aim(aim_to(judged.object->direction));
    return converged_means(pilot, *sampler, judged.object->direction,
                           object_convergence * std::sqrt(coarseness()), mask, {&judged.view, 1});
  }

  std::vector<NoiseTable> measure_surround(const TrialSettings& shown) const {
    const std::vector<Vec3> places = surround_places(setting_.vision, setting_.highest_seen_deg);
    const std::vector<JudgedView> views =
        surround_views(setting_.vision, setting_.protocol.display, places);
    SampleMask mask(shown.film.width, shown.film.height);
    for (std::size_t i = 0; i < views.size(); ++i) {
      const double to_corner_rad =
          std::atan(std::numbers::sqrt2 * double{views[i].viewport.half_size().x});
      mask.add(places[i], to_corner_rad, margin_px, setting_.workers);
    }
    const PilotSetting pilot = pilot_of(shown);
    const auto sampler = make_view_sampler("od");
    const Vec3 ahead(0.0F, 0.0F, -1.0F);
    sampler->aim(aim_at(ahead, setting_.protocol.display));
    const ConvergedMeans expected =
        converged_means(pilot, *sampler, ahead, surround_convergence, mask, views);
    return mean_patches(measure_noise(pilot, *sampler, pilot_levels, 0, mask, views, expected),
                        places);
  }

  std::string key_of(const JudgedObject& judged, const std::string& method,
                     std::uint32_t picture) const {
    std::string key =
        fmt::format("object {} {} {} radius {}\nmethod {}\npicture {}\n",
                    judged.object->direction.x, judged.object->direction.y,
                    judged.object->direction.z, judged.object->radius_deg, first_method(), picture);
    for (const MethodFile& file : setting_.protocol.method_files) {
      if (file.method == first_method()) {
        key += fmt::format("file {} {}\n", file.file, file.sha256);
      }
    }
    return key + key_of_setting(shown_with(method));
  }

  std::string key_of_surround() const {
    return fmt::format("around up to {} degrees\n{}", setting_.highest_seen_deg,
                       key_of_setting(shown_with(first_method())));
  }

  std::string key_of_setting(const TrialSettings& shown) const {
    const Vec3 viewpoint = stage_.viewpoint();
    const DisplaySettings& display = setting_.protocol.display;
    const Vision& vision = setting_.vision;
    return fmt::format(
        "tables {}\nscene {}\nviewpoint {} {} {}\nexposure {}\nfilm {}x{} depth {} filled {}\n"
        "display {}x{} {} {} lens {} {} {} {}\n"
        "vision {} {} {} {} {} scales {} {} {} coarse {}\n"
        "margin {} objects {} around {} levels {} {}\n",
        tables_version, stage_.key(), viewpoint.x, viewpoint.y, viewpoint.z,
        stage_.source().exposure_stops.value_or(0.0), shown.film.width, shown.film.height,
        shown.film.max_depth, shown.fill_unsampled, display.view_width, display.view_height,
        display.horizontal_fov_deg, display.vertical_fov_deg, display.lens.axis.x,
        display.lens.axis.y, display.lens.k1, display.lens.k2, vision.jnd_lab,
        vision.recognition_line_pairs, vision.surround_factor, vision.material_cell_deg,
        vision.view_cell_deg, vision.scale_count, vision.object_patch_deg, vision.view_patch_deg,
        vision.coarseness, margin_px, object_convergence, surround_convergence,
        pilot_levels.first_per_pixel, pilot_levels.count);
  }

  const AtlasSetting& setting_;
  std::string scene_;
  const SceneStage& stage_;
  TableCache cache_;
  std::map<std::string, ScaleTables> known_;
  std::stop_token stop_;
  std::vector<JudgedObject> objects_;
};

/// Makes the shard's items of all scenes that are not in the cache, and calls `use` with each scene
/// that has any.
PreparedItems make_pilots(const AtlasSetting& setting, const Shard& shard,
                          const std::stop_token& stop,
                          const std::function<void(const SceneAtlas& scene)>& use) {
  require_predictable(setting.protocol);
  std::int64_t items = 0;
  for (const auto& [name, stage] : setting.stages) {
    items += item_count(setting, name);
  }
  const ItemRange part = part_of(shard, items);
  PreparedItems prepared{.items = part.size(), .rendered = 0};
  Progress progress("Pilot renders");
  double items_done = 0.0;
  std::int64_t first = 0;
  for (const auto& [name, stage] : setting.stages) {
    const std::int64_t count = item_count(setting, name);
    const ItemRange own{.begin = std::max(first, part.begin) - first,
                        .end = std::min(first + count, part.end) - first};
    first += count;
    if (own.begin < own.end) {
      SceneAtlas scene(setting, name, stop);
      const std::string& scene_name = name;
      prepared.rendered += scene.make(own, [&](double fraction) {
        const double items_of_scene = fraction * static_cast<double>(own.size());
        progress.update((items_done + items_of_scene) / static_cast<double>(part.size()),
                        scene_name);
      });
      items_done += static_cast<double>(own.size());
      use(scene);
    }
  }
  return prepared;
}

}  // namespace

std::uint32_t picture_count(const Vision& vision) {
  return static_cast<std::uint32_t>(std::lround(object_pictures * vision.coarseness));
}

NoiseAtlas make_noise_atlas(const AtlasSetting& setting, const std::stop_token& stop) {
  NoiseAtlas atlas;
  make_pilots(setting, Shard{}, stop, [&](const SceneAtlas& scene) { scene.add_to(atlas); });
  return atlas;
}

PreparedItems prepare_pilots(const AtlasSetting& setting, const Shard& shard,
                             const std::stop_token& stop) {
  return make_pilots(setting, shard, stop, [](const SceneAtlas& /*scene*/) {});
}

}  // namespace foveola::study
