#include "renderer/trace/rays/embree_alone.h"

#include <algorithm>
#include <array>
#include <cstring>

#include <fmt/format.h>

#include "renderer/base/clock.h"
#include "renderer/trace/rays/embree_device.h"

namespace foveola {
namespace {

constexpr std::size_t packet_size = 8;
/// Rays per task: whole packets and whole streams.
constexpr std::size_t task_rays = 8192;

RTCRay embree_ray(const Ray& ray) {
  RTCRay copy;
  static_assert(sizeof(copy) == sizeof(ray));
  std::memcpy(&copy, &ray, sizeof(copy));
  return copy;
}

void set_lane(RTCRay8& packet, std::size_t lane, const Ray& ray) {
  packet.org_x[lane] = ray.origin.x;
  packet.org_y[lane] = ray.origin.y;
  packet.org_z[lane] = ray.origin.z;
  packet.tnear[lane] = ray.t_min;
  packet.dir_x[lane] = ray.direction.x;
  packet.dir_y[lane] = ray.direction.y;
  packet.dir_z[lane] = ray.direction.z;
  packet.time[lane] = ray.time;
  packet.tfar[lane] = ray.t_max;
  packet.mask[lane] = ray.mask;
  packet.id[lane] = ray.key;
  packet.flags[lane] = ray.flags;
}

/// The closest-hit calls, and their ray layouts.
struct ClosestHit {
  using Single = RTCRayHit;
  using Packet = RTCRayHit8;
  static constexpr const char* name = "rtcIntersect";
  static constexpr auto trace_one = embree::intersect_1;
  static constexpr auto trace_eight = embree::intersect_8;
#if FOVEOLA_EMBREE < 4
  static constexpr auto trace_many = rtcIntersect1M;
#endif

  static Single single(const Ray& ray) {
    Single query{.ray = embree_ray(ray), .hit = {}};
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    return query;
  }
  static Packet packet() {
    Packet query{};
    std::fill_n(query.hit.geomID, packet_size, RTC_INVALID_GEOMETRY_ID);
    std::fill_n(query.hit.instID[0], packet_size, RTC_INVALID_GEOMETRY_ID);
    return query;
  }
  static RTCRay8& rays_of(Packet& packet) { return packet.ray; }
};

/// The occlusion calls.
struct AnyHit {
  using Single = RTCRay;
  using Packet = RTCRay8;
  static constexpr const char* name = "rtcOccluded";
  static constexpr auto trace_one = embree::occluded_1;
  static constexpr auto trace_eight = embree::occluded_8;
#if FOVEOLA_EMBREE < 4
  static constexpr auto trace_many = rtcOccluded1M;
#endif

  static Single single(const Ray& ray) { return embree_ray(ray); }
  static Packet packet() { return {}; }
  static RTCRay8& rays_of(Packet& packet) { return packet; }
};

/// Repeats one query for the same rays.
template <typename Query>
class Replay {
 public:
  Replay(const RayScene& scene, std::span<const Ray> rays, const Workers& workers)
      : source_(scene.scene()), scene_(scene.embree_scene()), rays_(rays), workers_(workers) {}

  EmbreeTime one_by_one() const {
    std::vector<typename Query::Single> singles = all_singles();
    const double time_s = timed(singles.size(), task_rays, [&](std::size_t begin, std::size_t end) {
      RayQueryContext context(source_);
      for (std::size_t i = begin; i < end; ++i) {
        Query::trace_one(scene_, context, embree::incoherent, singles[i]);
      }
    });
    return {fmt::format("{}1", Query::name), time_s};
  }

  EmbreeTime in_packets(embree::QueryFlags flags) const {
    const std::size_t count = (rays_.size() + packet_size - 1) / packet_size;
    std::vector<typename Query::Packet> packets(count, Query::packet());
    for (std::size_t i = 0; i < rays_.size(); ++i) {
      set_lane(Query::rays_of(packets[i / packet_size]), i % packet_size, rays_[i]);
    }
    const double time_s =
        timed(count, task_rays / packet_size, [&](std::size_t begin, std::size_t end) {
          RayQueryContext context(source_);
          for (std::size_t i = begin; i < end; ++i) {
            alignas(32) std::array<int, packet_size> valid{};
            std::fill_n(valid.begin(), std::min(packet_size, rays_.size() - i * packet_size), -1);
            Query::trace_eight(valid.data(), scene_, context, flags, packets[i]);
          }
        });
    return {fmt::format("{}8, {}", Query::name, name_of(flags)), time_s};
  }

#if FOVEOLA_EMBREE < 4
  EmbreeTime in_streams(std::size_t length, embree::QueryFlags flags) const {
    std::vector<typename Query::Single> singles = all_singles();
    const double time_s = timed(singles.size(), task_rays, [&](std::size_t begin, std::size_t end) {
      RayQueryContext context(source_);
      context.flags = flags;
      for (std::size_t i = begin; i < end; i += length) {
        Query::trace_many(scene_, &context, &singles[i],
                          static_cast<unsigned>(std::min(length, end - i)),
                          sizeof(typename Query::Single));
      }
    });
    return {fmt::format("{}1M of {}, {}", Query::name, length, name_of(flags)), time_s};
  }
#endif

 private:
  static const char* name_of(embree::QueryFlags flags) {
    return flags == embree::coherent ? "coherent" : "incoherent";
  }

  std::vector<typename Query::Single> all_singles() const {
    std::vector<typename Query::Single> singles;
    singles.reserve(rays_.size());
    std::transform(rays_.begin(), rays_.end(), std::back_inserter(singles), Query::single);
    return singles;
  }

  template <typename Trace>
  double timed(std::size_t count, std::size_t task, const Trace& trace) const {
    const SteadyClock clock;
    const Nanoseconds start = clock.now();
    workers_.for_each_block(count, task, trace);
    return seconds(clock.now() - start);
  }

  const Scene& source_;
  RTCScene scene_;
  std::span<const Ray> rays_;
  const Workers& workers_;
};

template <typename Query>
std::vector<EmbreeTime> time_all(const Replay<Query>& replay) {
  std::vector<EmbreeTime> times = {replay.one_by_one(), replay.in_packets(embree::coherent),
                                   replay.in_packets(embree::incoherent)};
#if FOVEOLA_EMBREE < 4
  times.push_back(replay.in_streams(64, embree::coherent));
  times.push_back(replay.in_streams(1024, embree::incoherent));
#endif
  return times;
}

}  // namespace

std::vector<EmbreeTime> time_embree(const RayScene& scene, std::span<const Ray> rays,
                                    RayQuery query, const Workers& workers) {
  return query == RayQuery::closest_hit ? time_all(Replay<ClosestHit>(scene, rays, workers))
                                        : time_all(Replay<AnyHit>(scene, rays, workers));
}

}  // namespace foveola
