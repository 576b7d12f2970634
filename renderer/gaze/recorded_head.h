// Head poses from a file: recordings as comma-separated values, read and replayed.
//
// The first line is "time_ns,azimuth_rad,elevation_rad". Each further line is a pose: its time in
// whole nanoseconds from 0 on, later than the one before, and where the head points in the world,
// the elevation in [-pi/2, pi/2]. The azimuth may go round several times. A file may have a fourth
// field, roll_rad: how far the head is tilted to the right, in [-pi, pi].
//
//   time_ns,azimuth_rad,elevation_rad
//   0,1.361356816555577,0
//   14285714,1.3788101090755202,-0.017453292519943295
#pragma once

#include <filesystem>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/gaze/head_tracker.h"

namespace foveola {

/// At least one pose, bit for bit as written; azimuths of at most 1000 either way, and no roll
/// where the file has none. Throws Error with file:line for anything else than the above; lines may
/// end with CR LF.
std::vector<HeadPose> read_head_file(const std::filesystem::path& file);

/// Replays poses: one of time t is taken at start + t. poses: at least one, times ascending. Throws
/// Error otherwise.
ScriptedHeadTracker replayed_head(std::vector<HeadPose> poses, Nanoseconds start);

}  // namespace foveola
