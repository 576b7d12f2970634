#include "renderer/trace/ray_scene.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <embree3/rtcore.h>

#include "renderer/base/error.h"
#include "renderer/base/random.h"
#include "renderer/trace/mesh_attributes.h"
#include "renderer/trace/opacity.h"
#include "renderer/trace/ray_query.h"

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
static_assert(sizeof(HitQuery) == sizeof(RTCRayHit));
static_assert(alignof(HitQuery) == alignof(RTCRayHit));
static_assert(offsetof(HitQuery, u) == offsetof(RTCRayHit, hit.u));
static_assert(offsetof(HitQuery, triangle) == offsetof(RTCRayHit, hit.primID));
static_assert(offsetof(HitQuery, geometry) == offsetof(RTCRayHit, hit.geomID));
static_assert(offsetof(HitQuery, instance) == offsetof(RTCRayHit, hit.instID));
static_assert(Hit::nothing == RTC_INVALID_GEOMETRY_ID);

struct Release {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
template <typename Handle>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Release>;

/// What the filters know of a mesh that does not stop every ray.
struct FilteredMesh {
  const Scene* scene = nullptr;
  const Mesh* mesh = nullptr;
};

/// Calls `passes(mesh, ray id, hit)` for each hit that Embree asks about, and rejects those
/// that it is true for. Embree may ask about the same hit more than once, so the answer must not
/// change.
template <typename Passes>
void reject_hits(const RTCFilterFunctionNArguments* arguments, Passes passes) {
  const auto& filtered = *static_cast<const FilteredMesh*>(arguments->geometryUserPtr);
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
    if (passes(filtered, RTCRayN_id(arguments->ray, count, i), hit)) {
      arguments->valid[i] = 0;
    }
  }
}

const RayQueryContext& context_of(const RTCFilterFunctionNArguments* arguments) {
  return *static_cast<const RayQueryContext*>(arguments->context);
}

/// Every pair of a ray and a triangle has one random number that decides.
bool passes_opacity(const FilteredMesh& filtered, std::uint32_t id, const Hit& hit,
                    const RayQueryContext& context) {
  const float opaque = opacity(*filtered.scene, *filtered.mesh, hit.triangle, hit.barycentric);
  if (context.meets_any_opacity) {
    return opaque <= 0.0F;
  }
  const std::uint32_t key = context.keys != nullptr ? context.keys[id] : id;
  return opaque < 1.0F && unit_float(mix(mix(key, hit.object), hit.triangle)) >= opaque;
}

void filter_by_opacity(const RTCFilterFunctionNArguments* arguments) {
  const RayQueryContext& context = context_of(arguments);
  reject_hits(arguments,
              [&context](const FilteredMesh& filtered, std::uint32_t id, const Hit& hit) {
                return passes_opacity(filtered, id, hit, context);
              });
}

/// Also for thin transmissive surfaces with cut-outs: what they tint is found later, by closest
/// hits.
void filter_thin_surfaces(const RTCFilterFunctionNArguments* arguments) {
  std::uint32_t* met_thin_surface = context_of(arguments).met_thin_surface;
  reject_hits(arguments, [met_thin_surface](const FilteredMesh&, std::uint32_t id, const Hit&) {
    if (met_thin_surface != nullptr) {
      met_thin_surface[id] = 1;
    }
    return true;
  });
}

void keep_first_error(void* text, RTCError, const char* message) {
  auto& first = *static_cast<std::string*>(text);
  if (first.empty()) {
    first = message;
  }
}

/// Embree calls it from all its threads. True: it may go on.
bool count_bytes(void* total, ssize_t bytes, bool /*is_done*/) {
  *static_cast<std::atomic<std::ptrdiff_t>*>(total) += bytes;
  return true;
}

}  // namespace

struct RayScene::Embree {
  std::atomic<std::ptrdiff_t> memory_bytes = 0;
  std::string error;
  bool has_thin_surfaces = false;
  bool asks_for_keys = false;
  std::vector<std::unique_ptr<FilteredMesh>> filtered_meshes;  ///< Embree keeps their addresses
  Owned<RTCDevice> device;
  std::vector<Owned<RTCScene>> prototypes;  ///< null where invisible
  Owned<RTCScene> scene;

  void throw_if_failed() const {
    if (!error.empty()) {
      throw Error("ray tracing (Embree)", error,
                  "try a smaller scene or a machine with more memory");
    }
  }

  Owned<RTCGeometry> geometry_of(const Scene& source, const Mesh& mesh) {
    Owned<RTCGeometry> geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
    throw_if_failed();
    // A copy: Embree reads 16 bytes from every vertex, four beyond the end of the mesh's own array.
    void* vertices =
        rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                sizeof(Vec3), mesh.positions.size());
    throw_if_failed();
    std::copy(mesh.positions.begin(), mesh.positions.end(), static_cast<Vec3*>(vertices));
    rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               mesh.triangles.data(), 0, sizeof(mesh.triangles.front()),
                               mesh.triangles.size());
    set_filters(geometry.get(), source, mesh);
    rtcCommitGeometry(geometry.get());
    throw_if_failed();
    return geometry;
  }

  void set_filters(RTCGeometry geometry, const Scene& source, const Mesh& mesh) {
    const bool has_varying_opacity = has_opacity(source, mesh);
    const bool is_thin = is_thin_transmissive(material_of(source, mesh));
    if (has_varying_opacity || is_thin) {
      filtered_meshes.push_back(std::make_unique<FilteredMesh>(FilteredMesh{&source, &mesh}));
      rtcSetGeometryUserData(geometry, filtered_meshes.back().get());
    }
    if (has_varying_opacity) {
      asks_for_keys = true;
      rtcSetGeometryIntersectFilterFunction(geometry, filter_by_opacity);
      rtcSetGeometryOccludedFilterFunction(geometry, filter_by_opacity);
    }
    if (is_thin) {
      rtcSetGeometryOccludedFilterFunction(geometry, filter_thin_surfaces);
      has_thin_surfaces = true;
    }
  }

  Owned<RTCScene> new_scene() const {
    Owned<RTCScene> empty(rtcNewScene(device.get()));
    throw_if_failed();
    rtcSetSceneFlags(empty.get(), RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(empty.get(), RTC_BUILD_QUALITY_HIGH);
    return empty;
  }

  void find_blocked(std::span<Ray> rays, RayQueryContext& context) const {
    // Embree's ray and ours are the same bytes (asserted above).
    rtcOccluded1M(scene.get(), &context, reinterpret_cast<RTCRay*>(rays.data()),
                  static_cast<unsigned>(rays.size()), sizeof(Ray));
  }

  void commit(RTCScene ready, const Workers& workers) const {
    workers.for_each_block(1, 1, [&](std::size_t, std::size_t) { rtcCommitScene(ready); });
    throw_if_failed();
  }

  /// One scene for each prototype that is not invisible.
  void build_prototypes(const Scene& source, const Workers& workers) {
    for (const Mesh& mesh : source.prototypes) {
      prototypes.emplace_back();
      if (!is_invisible(source, mesh)) {
        prototypes.back() = new_scene();
        rtcAttachGeometryByID(prototypes.back().get(), geometry_of(source, mesh).get(), 0);
        commit(prototypes.back().get(), workers);
      }
    }
  }

  void attach_instance(const Instance& instance, unsigned object) const {
    RTCScene prototype = prototypes[instance.prototype].get();
    if (prototype == nullptr) {
      return;
    }
    const Owned<RTCGeometry> geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_INSTANCE));
    throw_if_failed();
    rtcSetGeometryInstancedScene(geometry.get(), prototype);
    rtcSetGeometryTransform(geometry.get(), 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR,
                            &instance.world_from_local);
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometryByID(scene.get(), geometry.get(), object);
    throw_if_failed();
  }
};

RayScene::RayScene(const Scene& scene, const Workers& workers)
    : embree_(std::make_unique<Embree>()) {
  Embree& embree = *embree_;
  embree.device.reset(rtcNewDevice(nullptr));
  if (!embree.device) {
    throw Error("ray tracing (Embree)", "cannot start on this machine");
  }
  rtcSetDeviceErrorFunction(embree.device.get(), keep_first_error, &embree.error);
  rtcSetDeviceMemoryMonitorFunction(embree.device.get(), count_bytes, &embree.memory_bytes);
  embree.build_prototypes(scene, workers);
  embree.scene = embree.new_scene();
  unsigned object = 0;
  for (const Mesh& mesh : scene.meshes) {
    if (!is_invisible(scene, mesh)) {
      rtcAttachGeometryByID(embree.scene.get(), embree.geometry_of(scene, mesh).get(), object);
    }
    ++object;
  }
  for (const Instance& instance : scene.instances) {
    embree.attach_instance(instance, object++);
  }
  embree.commit(embree.scene.get(), workers);
}

RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

Hit RayScene::closest_hit(const Ray& ray) const {
  HitQuery query(ray);
  find_hits({&query, 1});
  return query.hit();
}

void RayScene::find_hits(std::span<HitQuery> queries) const {
  RayQueryContext context;
  for (HitQuery& query : queries) {
    // The same bytes (asserted above).
    rtcIntersect1(embree_->scene.get(), &context, reinterpret_cast<RTCRayHit*>(&query));
  }
}

Hit RayScene::closest_hit_of_any_opacity(const Ray& ray) const {
  RayQueryContext context;
  context.meets_any_opacity = true;
  HitQuery query(ray);
  rtcIntersect1(embree_->scene.get(), &context, reinterpret_cast<RTCRayHit*>(&query));
  return query.hit();
}

bool RayScene::asks_for_keys() const { return embree_->asks_for_keys; }

std::size_t RayScene::memory_bytes() const {
  return static_cast<std::size_t>(embree_->memory_bytes);
}

RTCSceneTy* RayScene::embree_scene() const { return embree_->scene.get(); }

void RayScene::find_blocked(std::span<Ray> rays) const {
  if (!embree_->has_thin_surfaces) {
    RayQueryContext context;
    embree_->find_blocked(rays, context);
    return;
  }
  // The filters note thin transmissive surfaces by the ray's number, which takes the key's place.
  constexpr std::size_t most = 512;
  std::array<std::uint32_t, most> keys;
  for (; !rays.empty(); rays = rays.subspan(std::min(most, rays.size()))) {
    const std::span<Ray> some = rays.first(std::min(most, rays.size()));
    std::array<std::uint32_t, most> met_thin_surface{};
    for (std::size_t i = 0; i < some.size(); ++i) {
      keys[i] = std::exchange(some[i].key, static_cast<std::uint32_t>(i));
    }
    RayQueryContext context;
    context.keys = keys.data();
    context.met_thin_surface = met_thin_surface.data();
    embree_->find_blocked(some, context);
    for (std::size_t i = 0; i < some.size(); ++i) {
      some[i].key = keys[i];
      some[i].flags = met_thin_surface[i];
    }
  }
}

}  // namespace foveola
