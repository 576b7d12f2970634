#include "renderer/trace/ray_scene.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

#include <embree3/rtcore.h>

#include "renderer/base/error.h"
#include "renderer/trace/cut_out.h"

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

struct Release {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
template <typename Handle>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Release>;

/// What the filter is told of a mesh that has holes.
struct CutOut {
  const Scene* scene = nullptr;
  const Mesh* mesh = nullptr;
};

/// Takes back hits in holes. Embree may ask about the same hit more than once.
void reject_holes(const RTCFilterFunctionNArguments* arguments) {
  const auto* cut_out = static_cast<const CutOut*>(arguments->geometryUserPtr);
  for (unsigned i = 0; i < arguments->N; ++i) {
    if (arguments->valid[i] == 0) {
      continue;
    }
    const Vec2 barycentric(RTCHitN_u(arguments->hit, arguments->N, i),
                           RTCHitN_v(arguments->hit, arguments->N, i));
    if (is_hole(*cut_out->scene, *cut_out->mesh, RTCHitN_primID(arguments->hit, arguments->N, i),
                barycentric)) {
      arguments->valid[i] = 0;
    }
  }
}

void keep_first_error(void* text, RTCError, const char* message) {
  auto& first = *static_cast<std::string*>(text);
  if (first.empty()) {
    first = message;
  }
}

}  // namespace

struct RayScene::Embree {
  std::string error;
  std::vector<CutOut> cut_outs;
  Owned<RTCDevice> device;
  Owned<RTCScene> scene;

  void throw_if_failed() const {
    if (!error.empty()) {
      throw Error("ray tracing (Embree)", error,
                  "try a smaller scene or a machine with more memory");
    }
  }

  Owned<RTCGeometry> geometry_of(const Mesh& mesh) const {
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
    return geometry;
  }

  void add(const Scene& source, unsigned mesh_index) {
    const Mesh& mesh = source.meshes[mesh_index];
    const Owned<RTCGeometry> geometry = geometry_of(mesh);
    if (has_varying_alpha(source, mesh)) {
      cut_outs.push_back({&source, &mesh});
      rtcSetGeometryUserData(geometry.get(), &cut_outs.back());
      rtcSetGeometryIntersectFilterFunction(geometry.get(), reject_holes);
      rtcSetGeometryOccludedFilterFunction(geometry.get(), reject_holes);
    }
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometryByID(scene.get(), geometry.get(), mesh_index);
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
  embree.scene.reset(rtcNewScene(embree.device.get()));
  embree.throw_if_failed();
  rtcSetSceneFlags(embree.scene.get(), RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(embree.scene.get(), RTC_BUILD_QUALITY_HIGH);

  embree.cut_outs.reserve(scene.meshes.size());
  for (unsigned i = 0; i < scene.meshes.size(); ++i) {
    if (!is_invisible(scene, scene.meshes[i])) {
      embree.add(scene, i);
    }
  }
  workers.for_each_block(1, 1,
                         [&](std::size_t, std::size_t) { rtcCommitScene(embree.scene.get()); });
  embree.throw_if_failed();
}

RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

Hit RayScene::closest_hit(const Vec3& origin, const Vec3& direction) const {
  RTCRayHit query;
  query.ray = {origin.x,    origin.y,    origin.z,
               0.0F,        direction.x, direction.y,
               direction.z, 0.0F,        std::numeric_limits<float>::infinity(),
               ~0U,         0,           0};
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(embree_->scene.get(), &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
    return {};
  }
  return {.t = query.ray.tfar,
          .barycentric = {query.hit.u, query.hit.v},
          .object = query.hit.geomID,
          .triangle = query.hit.primID};
}

void RayScene::find_blocked(std::span<Ray> rays) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  // Embree's ray and ours are the same bytes (asserted above).
  rtcOccluded1M(embree_->scene.get(), &context, reinterpret_cast<RTCRay*>(rays.data()),
                static_cast<unsigned>(rays.size()), sizeof(Ray));
}

}  // namespace foveola
