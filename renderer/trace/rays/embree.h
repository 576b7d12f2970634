// One interface for Embree 3 and 4, whichever the system has.
//
// Embree 4 passes a query's flags beside its context, and has no ray streams.
#pragma once

#if FOVEOLA_EMBREE >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace foveola::embree {

#if FOVEOLA_EMBREE >= 4

using QueryContext = RTCRayQueryContext;
using QueryFlags = RTCRayQueryFlags;
inline constexpr QueryFlags coherent = RTC_RAY_QUERY_FLAG_COHERENT;
inline constexpr QueryFlags incoherent = RTC_RAY_QUERY_FLAG_INCOHERENT;

inline void init(QueryContext& context) { rtcInitRayQueryContext(&context); }

inline RTCIntersectArguments intersect_arguments(QueryContext& context, QueryFlags flags) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context;
  arguments.flags = flags;
  return arguments;
}

inline RTCOccludedArguments occluded_arguments(QueryContext& context, QueryFlags flags) {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &context;
  arguments.flags = flags;
  return arguments;
}

inline void intersect_1(RTCScene scene, QueryContext& context, QueryFlags flags, RTCRayHit& query) {
  RTCIntersectArguments arguments = intersect_arguments(context, flags);
  rtcIntersect1(scene, &query, &arguments);
}

/// valid: -1 for active rays, 0 for others.
inline void intersect_8(const int* valid, RTCScene scene, QueryContext& context, QueryFlags flags,
                        RTCRayHit8& queries) {
  RTCIntersectArguments arguments = intersect_arguments(context, flags);
  rtcIntersect8(valid, scene, &queries, &arguments);
}

inline void occluded_1(RTCScene scene, QueryContext& context, QueryFlags flags, RTCRay& ray) {
  RTCOccludedArguments arguments = occluded_arguments(context, flags);
  rtcOccluded1(scene, &ray, &arguments);
}

inline void occluded_8(const int* valid, RTCScene scene, QueryContext& context, QueryFlags flags,
                       RTCRay8& rays) {
  RTCOccludedArguments arguments = occluded_arguments(context, flags);
  rtcOccluded8(valid, scene, &rays, &arguments);
}

#else

using QueryContext = RTCIntersectContext;
using QueryFlags = RTCIntersectContextFlags;
inline constexpr QueryFlags coherent = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
inline constexpr QueryFlags incoherent = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;

inline void init(QueryContext& context) { rtcInitIntersectContext(&context); }

inline void intersect_1(RTCScene scene, QueryContext& context, QueryFlags flags, RTCRayHit& query) {
  context.flags = flags;
  rtcIntersect1(scene, &context, &query);
}

/// valid: -1 for active rays, 0 for others.
inline void intersect_8(const int* valid, RTCScene scene, QueryContext& context, QueryFlags flags,
                        RTCRayHit8& queries) {
  context.flags = flags;
  rtcIntersect8(valid, scene, &context, &queries);
}

inline void occluded_1(RTCScene scene, QueryContext& context, QueryFlags flags, RTCRay& ray) {
  context.flags = flags;
  rtcOccluded1(scene, &context, &ray);
}

inline void occluded_8(const int* valid, RTCScene scene, QueryContext& context, QueryFlags flags,
                       RTCRay8& rays) {
  context.flags = flags;
  rtcOccluded8(valid, scene, &context, &rays);
}

#endif

}  // namespace foveola::embree
