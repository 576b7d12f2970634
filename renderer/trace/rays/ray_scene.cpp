#include "renderer/trace/rays/ray_scene.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "renderer/base/files/digest.h"
#include "renderer/base/numbers/random.h"
#include "renderer/base/work/work_scope.h"
#include "renderer/trace/rays/embree_device.h"
#include "renderer/trace/rays/mesh_attributes.h"
#include "renderer/trace/rays/opacity.h"

namespace foveola {
namespace {

static_assert(sizeof(Ray) == sizeof(RTCRay));
static_assert(alignof(Ray) == alignof(RTCRay));
static_assert(offsetof(Ray, origin) == offsetof(RTCRay, org_x));
static_assert(offsetof(Ray, t_min) == offsetof(RTCRay, tnear));
static_assert(offsetof(Ray, direction) == offsetof(RTCRay, dir_x));
static_assert(offsetof(Ray, t_max) == offsetof(RTCRay, tfar));
static_assert(offsetof(Ray, mask) == offsetof(RTCRay, mask));
static_assert(offsetof(Ray, flags) == offsetof(RTCRay, flags));
static_assert(sizeof(RayLanes) == sizeof(RTCRay8));
static_assert(alignof(RayLanes) == alignof(RTCRay8));
static_assert(offsetof(RayLanes, t_min) == offsetof(RTCRay8, tnear));
static_assert(offsetof(RayLanes, direction) == offsetof(RTCRay8, dir_x));
static_assert(offsetof(RayLanes, t_max) == offsetof(RTCRay8, tfar));
static_assert(offsetof(RayLanes, mask) == offsetof(RTCRay8, mask));
static_assert(offsetof(RayLanes, key) == offsetof(RTCRay8, id));
// Embree 4 writes one column more than Embree 3.
static_assert(sizeof(HitQueries) >= sizeof(RTCRayHit8));
static_assert(alignof(HitQueries) == alignof(RTCRayHit8));
static_assert(offsetof(HitQueries, u) == offsetof(RTCRayHit8, hit.u));
static_assert(offsetof(HitQueries, triangle) == offsetof(RTCRayHit8, hit.primID));
static_assert(offsetof(HitQueries, geometry) == offsetof(RTCRayHit8, hit.geomID));
static_assert(offsetof(HitQueries, instance) == offsetof(RTCRayHit8, hit.instID));
static_assert(Hit::nothing == RTC_INVALID_GEOMETRY_ID);

/// Calls `passes(ray id, hit)` for each hit that Embree filters, and rejects the hits for which it
/// is true. Embree may filter a hit more than once, so the answer must not change.
template <typename Passes>
void reject_hits(const RTCFilterFunctionNArguments* arguments, Passes passes) {
  const unsigned count = arguments->N;
  for (unsigned i = 0; i < count; ++i) {
    if (arguments->valid[i] == 0) {
      continue;
    }
    const Hit hit{
        .barycentric = {RTCHitN_u(arguments->hit, count, i), RTCHitN_v(arguments->hit, count, i)},
        .object = object_number(RTCHitN_instID(arguments->hit, count, i, 0),
                                RTCHitN_geomID(arguments->hit, count, i)),
        .triangle = RTCHitN_primID(arguments->hit, count, i)};
    if (passes(RTCRayN_id(arguments->ray, count, i), hit)) {
      arguments->valid[i] = 0;
    }
  }
}

const RayQueryContext& context_of(const RTCFilterFunctionNArguments* arguments) {
  return *static_cast<const RayQueryContext*>(arguments->context);
}

/// One random number per pair of ray and triangle decides.
bool passes_opacity(std::uint32_t id, const Hit& hit, const RayQueryContext& context) {
  const Scene& scene = *context.scene;
  const float opaque = opacity(scene, scene.mesh_of(hit.object), hit.triangle, hit.barycentric);
  if (context.meets_any_opacity) {
    return opaque <= 0.0F;
  }
  const std::uint32_t key = context.keys != nullptr ? context.keys[id] : id;
  return opaque < 1.0F && unit_float(mix(mix(key, hit.object), hit.triangle)) >= opaque;
}

void filter_by_opacity(const RTCFilterFunctionNArguments* arguments) {
  const RayQueryContext& context = context_of(arguments);
  reject_hits(arguments, [&context](std::uint32_t id, const Hit& hit) {
    return passes_opacity(id, hit, context);
  });
}

/// Also for thin transmissive surfaces with cut-outs: their tint is found later, by closest hits.
void filter_thin_surfaces(const RTCFilterFunctionNArguments* arguments) {
  std::uint32_t* met_thin_surface = context_of(arguments).met_thin_surface;
  reject_hits(arguments, [met_thin_surface](std::uint32_t id, const Hit&) {
    if (met_thin_surface != nullptr) {
      met_thin_surface[id] = 1;
    }
    return true;
  });
}

/// A mesh's use of the filters.
struct Filtering {
  bool by_opacity = false;       ///< only some rays hit it
  bool by_thin_surface = false;  ///< it tints shadow rays

  Filtering(const Scene& scene, const Mesh& mesh)
      : by_opacity(has_opacity(scene, mesh)),
        by_thin_surface(is_thin_transmissive(material_of(scene, mesh))) {}
};

void set_filters(RTCGeometry geometry, const Filtering& filtering) {
  if (filtering.by_opacity) {
    rtcSetGeometryIntersectFilterFunction(geometry, filter_by_opacity);
    rtcSetGeometryOccludedFilterFunction(geometry, filter_by_opacity);
  }
  if (filtering.by_thin_surface) {
    rtcSetGeometryOccludedFilterFunction(geometry, filter_thin_surfaces);
  }
}

Hit closest_hit_of(RTCScene scene, const Ray& ray, RayQueryContext& context) {
  RTCRayHit query;
  std::memcpy(&query.ray, &ray, sizeof(query.ray));  // the same bytes (asserted above)
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  embree::intersect_1(scene, context, embree::incoherent, query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
    return {};
  }
  return {.t = query.ray.tfar,
          .barycentric = {query.hit.u, query.hit.v},
          .object = object_number(query.hit.instID[0], query.hit.geomID),
          .triangle = query.hit.primID};
}

/// Embree's source of a mesh's vertex indices.
enum class Indices { shared_with_mesh, copied };

FromEmbree<RTCGeometry> geometry_of(const EmbreeDevice& device, const Mesh& mesh, Indices indices,
                                    const Filtering& filtering) {
  FromEmbree<RTCGeometry> geometry = device.new_geometry(RTC_GEOMETRY_TYPE_TRIANGLE);
  // A copy: Embree reads 16 bytes from every vertex, four beyond the end of the mesh's own array.
  void* vertices = rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0,
                                           RTC_FORMAT_FLOAT3, sizeof(Vec3), mesh.positions.size());
  device.throw_if_failed();
  std::copy(mesh.positions.begin(), mesh.positions.end(), static_cast<Vec3*>(vertices));
  using Triangle = std::array<std::uint32_t, 3>;
  if (indices == Indices::copied) {
    void* triangles =
        rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                sizeof(Triangle), mesh.triangles.size());
    device.throw_if_failed();
    std::copy(mesh.triangles.begin(), mesh.triangles.end(), static_cast<Triangle*>(triangles));
  } else {
    rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               mesh.triangles.data(), 0, sizeof(Triangle), mesh.triangles.size());
  }
  set_filters(geometry.get(), filtering);
  rtcCommitGeometry(geometry.get());
  device.throw_if_failed();
  return geometry;
}

/// Equal for meshes with equal hierarchies.
std::string digest_of(const Mesh& mesh, const Filtering& filtering) {
  Sha256 digest;
  const std::array<std::uint64_t, 4> header = {mesh.positions.size(), mesh.triangles.size(),
                                               filtering.by_opacity ? 1U : 0U,
                                               filtering.by_thin_surface ? 1U : 0U};
  digest.update(std::as_bytes(std::span(header)));
  digest.update(std::as_bytes(std::span(mesh.positions)));
  digest.update(std::as_bytes(std::span(mesh.triangles)));
  return digest.hex();
}

/// Called by Embree from all its threads; true: continue. Embree counts triangles that it splits
/// more than once, so that its fraction may exceed 1.
bool may_go_on(void* scope, double /*fraction_done*/) {
  return !static_cast<const WorkScope*>(scope)->is_stopped();
}
bool report_build(void* scope, double fraction_done) {
  static_cast<const WorkScope*>(scope)->report("ray hierarchy", std::min(fraction_done, 1.0));
  return may_go_on(scope, fraction_done);
}

/// monitor: polled during building, if stopping or progress is watched. Throws WorkStopped.
void commit(const EmbreeDevice& device, RTCScene ready, const Workers& workers,
            RTCProgressMonitorFunction monitor) {
  if (const WorkScope* const scope = WorkScope::current()) {
    rtcSetSceneProgressMonitorFunction(ready, monitor, const_cast<WorkScope*>(scope));
  }
  workers.for_each_block(1, 1, [&](std::size_t, std::size_t) { rtcCommitScene(ready); });
  rtcSetSceneProgressMonitorFunction(ready, nullptr, nullptr);
  throw_if_work_stopped();
  device.throw_if_failed();
}

}  // namespace

struct KeptHierarchies::Embree {
  std::shared_ptr<const EmbreeDevice> device = std::make_shared<EmbreeDevice>();
  std::map<std::string, SharedFromEmbree<RTCScene>> of_meshes;  ///< by digest
  std::uint64_t built = 0;
};

KeptHierarchies::KeptHierarchies() : embree_(std::make_unique<Embree>()) {}
KeptHierarchies::~KeptHierarchies() = default;

std::uint64_t KeptHierarchies::built() const { return embree_->built; }

struct RayScene::Embree {
  const Scene* source;
  std::shared_ptr<const EmbreeDevice> device;
  bool has_thin_surfaces = false;
  bool asks_for_keys = false;
  std::vector<SharedFromEmbree<RTCScene>> prototypes;  ///< null where invisible
  FromEmbree<RTCScene> scene;

  Filtering filtering_of(const Mesh& mesh) {
    const Filtering filtering(*source, mesh);
    asks_for_keys = asks_for_keys || filtering.by_opacity;
    has_thin_surfaces = has_thin_surfaces || filtering.by_thin_surface;
    return filtering;
  }

  FromEmbree<RTCScene> scene_of(const Mesh& mesh, Indices indices, const Filtering& filtering,
                                const Workers& workers) const {
    FromEmbree<RTCScene> prototype = device->new_scene();
    rtcAttachGeometryByID(prototype.get(), geometry_of(*device, mesh, indices, filtering).get(), 0);
    commit(*device, prototype.get(), workers, may_go_on);
    return prototype;
  }

  /// One scene for each prototype that is not invisible.
  void build_prototypes(const Workers& workers) {
    for (const Mesh& mesh : source->prototypes) {
      prototypes.emplace_back();
      if (!is_invisible(*source, mesh)) {
        prototypes.back() = scene_of(mesh, Indices::shared_with_mesh, filtering_of(mesh), workers);
      }
    }
  }

  /// The same, reusing the hierarchies in `kept`, which then holds these.
  void build_prototypes(const Workers& workers, KeptHierarchies::Embree& kept) {
    std::map<std::string, SharedFromEmbree<RTCScene>> in_use;
    for (const Mesh& mesh : source->prototypes) {
      prototypes.emplace_back();
      if (!is_invisible(*source, mesh)) {
        const Filtering filtering = filtering_of(mesh);
        const std::string digest = digest_of(mesh, filtering);
        const auto known = kept.of_meshes.find(digest);
        if (known != kept.of_meshes.end()) {
          prototypes.back() = known->second;
        } else {
          prototypes.back() = scene_of(mesh, Indices::copied, filtering, workers);
          ++kept.built;
        }
        in_use[digest] = prototypes.back();
      }
    }
    kept.of_meshes = std::move(in_use);
  }

  /// Adds the objects at their places in the world. To be called after building their prototypes.
  void build_world(const Workers& workers) {
    scene = device->new_scene();
    unsigned object = 0;
    for (const Mesh& mesh : source->meshes) {
      if (!is_invisible(*source, mesh)) {
        const FromEmbree<RTCGeometry> geometry =
            geometry_of(*device, mesh, Indices::shared_with_mesh, filtering_of(mesh));
        rtcAttachGeometryByID(scene.get(), geometry.get(), object);
      }
      ++object;
    }
    for (const Instance& instance : source->instances) {
      attach_instance(instance, object++);
    }
    commit(*device, scene.get(), workers, report_build);
  }

  void attach_instance(const Instance& instance, unsigned object) const {
    RTCScene prototype = prototypes[instance.prototype].get();
    if (prototype == nullptr) {
      return;
    }
    const FromEmbree<RTCGeometry> geometry = device->new_geometry(RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(geometry.get(), prototype);
    rtcSetGeometryTransform(geometry.get(), 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR,
                            &instance.world_from_local);
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometryByID(scene.get(), geometry.get(), object);
    device->throw_if_failed();
  }
};

RayScene::RayScene(const Scene& scene, const Workers& workers, KeptHierarchies* kept)
    : embree_(std::make_unique<Embree>()) {
  embree_->source = &scene;
  if (kept != nullptr) {
    embree_->device = kept->embree_->device;
    embree_->build_prototypes(workers, *kept->embree_);
  } else {
    embree_->device = std::make_shared<EmbreeDevice>();
    embree_->build_prototypes(workers);
  }
  embree_->build_world(workers);
}

RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

Hit RayScene::closest_hit(const Ray& ray) const {
  RayQueryContext context(*embree_->source);
  return closest_hit_of(embree_->scene.get(), ray, context);
}

Hit RayScene::closest_hit_of_any_opacity(const Ray& ray) const {
  RayQueryContext context(*embree_->source);
  context.meets_any_opacity = true;
  return closest_hit_of(embree_->scene.get(), ray, context);
}

void RayScene::find_hits(HitQueries& queries, const LaneMask& lanes) const {
  RayQueryContext context(*embree_->source);
  // The same bytes (asserted above).
  embree::intersect_8(reinterpret_cast<const int*>(&lanes), embree_->scene.get(), context,
                      embree::incoherent, reinterpret_cast<RTCRayHit8&>(queries));
}

bool RayScene::asks_for_keys() const { return embree_->asks_for_keys; }

std::size_t RayScene::memory_bytes() const { return embree_->device->memory_bytes(); }

const Scene& RayScene::scene() const { return *embree_->source; }

RTCSceneTy* RayScene::embree_scene() const { return embree_->scene.get(); }

void RayScene::find_blocked(RayStream& rays) const {
  RayQueryContext context(*embree_->source);
  std::uint32_t* id = rays.key_.data();
  if (embree_->has_thin_surfaces) {
    // The filters mark thin transmissive surfaces by the ray's number, which replaces the key.
    id = rays.number_.data();
    context.keys = rays.key_.data();
    context.met_thin_surface = rays.met_thin_surface_.data();
    std::fill_n(context.met_thin_surface, rays.size(), 0U);
  }
#if FOVEOLA_EMBREE >= 4
  for (std::size_t first = 0; first < rays.size(); first += lane_count) {
    const std::size_t count = std::min(lane_count, rays.size() - first);
    RTCRay8 packet{};
    alignas(32) std::array<int, lane_count> valid{};
    std::fill_n(valid.begin(), count, -1);
    std::copy_n(rays.origin_.data(0) + first, count, packet.org_x);
    std::copy_n(rays.origin_.data(1) + first, count, packet.org_y);
    std::copy_n(rays.origin_.data(2) + first, count, packet.org_z);
    std::copy_n(rays.direction_.data(0) + first, count, packet.dir_x);
    std::copy_n(rays.direction_.data(1) + first, count, packet.dir_y);
    std::copy_n(rays.direction_.data(2) + first, count, packet.dir_z);
    std::copy_n(rays.t_max_.data() + first, count, packet.tfar);
    std::copy_n(id + first, count, packet.id);
    std::fill_n(packet.mask, lane_count, ~0U);
    embree::occluded_8(valid.data(), embree_->scene.get(), context, embree::incoherent, packet);
    std::copy_n(packet.tfar, count, rays.t_max_.data() + first);
  }
#else
  context.flags = embree::incoherent;
  RTCRayNp stream{.org_x = rays.origin_.data(0),
                  .org_y = rays.origin_.data(1),
                  .org_z = rays.origin_.data(2),
                  .tnear = rays.zero_.data(),
                  .dir_x = rays.direction_.data(0),
                  .dir_y = rays.direction_.data(1),
                  .dir_z = rays.direction_.data(2),
                  .time = rays.zero_.data(),
                  .tfar = rays.t_max_.data(),
                  .mask = rays.mask_.data(),
                  .id = id,
                  .flags = rays.met_thin_surface_.data()};
  rtcOccludedNp(embree_->scene.get(), &context, &stream, static_cast<unsigned>(rays.size()));
#endif
}

}  // namespace foveola
