// The part of BlockTracer that works on the vertices on the fast path, eight at a time.
#include "renderer/trace/paths/block_tracer.h"
#include "renderer/trace/paths/vertex_rules.h"
#include "renderer/trace/surfaces/surface.h"

namespace foveola {
namespace {

/// The direction in unused lanes.
constexpr Vec3 straight_up(0.0F, 0.0F, 1.0F);

}  // namespace

LaneMask BlockTracer::advance_on_fast_path(const Group& group, LaneMask lanes,
                                           const LaneMask& normal_mapped,
                                           const GroupNumbers& numbers) {
  SurfaceHits hits;
  for_each_lane(lanes, [&](std::size_t lane) {
    const std::size_t index = group.first + lane;
    hits.put(lane, object_at(index).view, hits_->triangle[index]);
  });
  const Vec3s direction = paths_->direction.load(group.first);
  SurfacePoints points =
      hits.points(direction, {hits_->u.load(group.first), hits_->v.load(group.first)},
                  hits_->t.load(group.first));
  LaneMask turned_out_other{};
  const FastPathLayersLanes layers = layers_of(group, points, lanes, turned_out_other);
  LaneMask goes_on{};
  if (any_lane(turned_out_other)) {
    goes_on = advance_alone(group, turned_out_other, numbers);
    lanes &= ~turned_out_other;
  }
  apply_normal_maps(group, direction, lanes & normal_mapped, points);
  const Frames frames(points.shading_normal);
  const Vec3s outgoing = chosen(lanes, frames.to_local(-direction), all_lanes(straight_up));
  const FastPathBsdfs bsdfs(layers, outgoing, traced_.tables.ggx());
  ShadingPoints shading_points;
  shading_points.position.store(points.position);
  shading_points.normal.store(points.horizon_normal);
  shading_points.region.store(traced_.lights.regions_of(points.position, points.horizon_normal));
  queue_lights(group, lanes, points, shading_points, frames, bsdfs, numbers);
  return goes_on | send(group, lanes, points, shading_points, frames, bsdfs, numbers);
}

FastPathLayersLanes BlockTracer::layers_of(const Group& group, const SurfacePoints& points,
                                           const LaneMask& lanes, LaneMask& others) const {
  FastPathLayersLanes layers;
  // All lanes' texels are prefetched before the first is read.
  for_each_lane(lanes, [&](std::size_t lane) {
    const std::size_t index = group.first + lane;
    if (!object_at(index).is_constant) {
      prefetch_textures(traced_.scene, mesh_point(index, points, lane));
    }
  });
  for_each_lane(lanes, [&](std::size_t lane) {
    const std::size_t index = group.first + lane;
    const TracedObject& object = object_at(index);
    if (object.is_constant) {
      layers.put(lane, object.layers);
      return;
    }
    const FastPathLayers here = fast_path_layers(
        reflectance_at(traced_.scene, mesh_point(index, points, lane), /*is_back=*/false));
    layers.put(lane, here);
    others[lane] = is_on_fast_path(here) ? 0 : -1;
  });
  return layers;
}

MeshPoint BlockTracer::mesh_point(std::size_t index, const SurfacePoints& points,
                                  std::size_t lane) const {
  const Hit hit = hits_->at(index);
  MeshPoint point{
      .mesh = *object_of(hit).view.mesh, .triangle = hit.triangle, .barycentric = hit.barycentric};
  const float width_m = paths_->width_m[index] + paths_->spread_rad[index] * hit.t;
  if (width_m > 0.0F) {
    point.relative_width = relative_width(width_m, points.facing[lane], points.double_area[lane]);
  }
  return point;
}

void BlockTracer::apply_normal_maps(const Group& group, const Vec3s& direction,
                                    const LaneMask& lanes, SurfacePoints& points) const {
  for_each_lane(lanes, [&](std::size_t lane) {
    const std::size_t index = group.first + lane;
    points.turn_shading_normal(
        lane, direction,
        mapped_normal(traced_.scene,
                      normal_map(material_of(traced_.scene, *object_at(index).view.mesh)),
                      mesh_point(index, points, lane), object_at(index).view.instance,
                      points.smooth_normal_at(lane)));
  });
}

void BlockTracer::queue_lights(const Group& group, const LaneMask& lanes,
                               const SurfacePoints& points, const ShadingPoints& shading_points,
                               const Frames& frames, const FastPathBsdfs& bsdfs,
                               const GroupNumbers& numbers) {
  if (traced_.lights.empty()) {
    return;
  }
  const LightSamples light = traced_.lights.sample(shading_points, numbers.light, lanes);
  const Vec3s incoming = frames.to_local(light.direction);
  LaneMask arrives = lanes & (light.pdf != 0.0F) & ~(incoming.z <= 0.0F) &
                     ~(dot(light.direction, points.horizon_normal) <= 0.0F);
  if (!any_lane(arrives)) {
    return;
  }
  const auto value = bsdfs.eval(chosen(arrives, incoming, all_lanes(straight_up)));
  const Vec3s gain = direct_light(paths_->throughput.load(group.first), value, light, light.pdf);
  arrives &= (gain.x != 0.0F) | (gain.y != 0.0F) | (gain.z != 0.0F);
  Vec3s origin = points.origin;
  arrives = lift_origins(group, arrives, light.direction, points, origin);
  const Vec3s to_light = shadow_direction(light, points.position, origin);
  arrives = finite(group, arrives, gain, to_light);
  shadow_rays_.add(LanePacking(bits_of(arrives)), origin, to_light, light.t_max,
                   numbers.shadow_key);
  Vec3Lanes radiance;
  radiance.store(gain);
  for_each_lane(arrives, [&](std::size_t lane) {
    pending_.push_back({.job = paths_->job[group.first + lane],
                        .radiance = radiance.at(lane),
                        .is_distant = light.is_delta[lane] == 0 && std::isinf(light.t_max[lane])});
  });
}

LaneMask BlockTracer::lift_origins(const Group& group, LaneMask lanes, const Vec3s& direction,
                                   const SurfacePoints& points, Vec3s& origin) {
  const LaneMask below_plane = lanes & (dot(direction, points.geometric_normal) <= 0.0F);
  if (!any_lane(below_plane)) {
    return lanes;
  }
  Vec3Lanes origins;
  origins.store(origin);
  Vec3Lanes normals;
  normals.store(points.geometric_normal);
  for_each_lane(below_plane, [&](std::size_t lane) {
    Vec3 lifted = origins.at(lane);
    if (lift_origin(hits_->at(group.first + lane), normals.at(lane), lifted)) {
      origins.put(lane, lifted);
    } else {
      lanes[lane] = 0;
    }
  });
  origin = origins.load();
  return lanes;
}

LaneMask BlockTracer::send(const Group& group, const LaneMask& lanes, const SurfacePoints& points,
                           const ShadingPoints& shading_points, const Frames& frames,
                           const FastPathBsdfs& bsdfs, const GroupNumbers& numbers) {
  PathStates& paths = *paths_;
  const std::size_t first = group.first;
  const auto sample = bsdfs.sample(numbers.lobe, numbers.scattering);
  const Vec3s direction = normalized(frames.to_world(sample.incoming));
  // Written so that NaN passes, and is found below.
  LaneMask goes_on = lanes & (sample.pdf != 0.0F) & ~(sample.incoming.z <= 0.0F) &
                     ~(dot(direction, points.horizon_normal) <= 0.0F);
  Vec3s origin = points.origin;
  goes_on = lift_origins(group, goes_on, direction, points, origin);
  Vec3s throughput = paths.throughput.load(first) * sample.weight;
  const Floats brightest = max_component(throughput) / paths.radiance_scale.load(first);
  goes_on = finite(group, goes_on, throughput, direction) & (brightest > 0.0F);
  if (vertex_ > settings_.vertices_before_roulette) {
    const Floats survives = survival(brightest);
    const LaneMask is_dim = survives < 1.0F;
    throughput = chosen(is_dim, (1.0F / survives) * throughput, throughput);
    goes_on &= ~is_dim | (numbers.roulette < survives);
  }
  paths.origin.store(first, goes_on, origin);
  paths.direction.store(first, goes_on, direction);
  paths.throughput.store(first, goes_on, throughput);
  paths.pdf.store(first, goes_on, sample.pdf);
  paths.shading_point_position.store(first, goes_on, points.position);
  paths.shading_point_normal.store(first, goes_on, points.horizon_normal);
  paths.shading_point_transmits.store(first, goes_on, Uints{});
  paths.shading_point_region.store(first, goes_on, shading_points.region.load());
  paths.key.store(first, goes_on, numbers.next_key);
  const Floats spread = paths.spread_rad.load(first);
  paths.width_m.store(first, goes_on, paths.width_m.load(first) + spread * hits_->t.load(first));
  paths.spread_rad.store(first, goes_on & (spread > 0.0F),
                         larger(spread, scattered_spread_rad(sample.pdf)));
  return goes_on;
}

LaneMask BlockTracer::finite(const Group& group, const LaneMask& lanes, const Vec3s& radiance,
                             const Vec3s& direction) {
  const LaneMask all_finite = is_finite(radiance) & is_finite(direction);
  for_each_lane(lanes & ~all_finite, [&](std::size_t lane) {
    radiance_[paths_->job[group.first + lane]] = not_a_number;
  });
  return lanes & all_finite;
}

}  // namespace foveola
