// Gaze from a file: recordings as comma-separated values, written, read and replayed.
//
// The first line is "time_ns,x,y,z,valid". Each further line is a sample: its time in whole
// nanoseconds from 0 on, later than the one before; the direction's components, of unit length in
// the head's axes; and 1. Where the tracker saw no eye, x, y and z are empty, and the last is 0:
//
//   time_ns,x,y,z,valid
//   0,0.6,0,-0.8,1
//   8333333,,,,0
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/gaze/eye_tracker.h"

namespace foveola {

/// At least one sample. Throws Error with file:line for anything else than the above; lines may end
/// with CR LF, and a direction may be off unit length by a thousandth.
std::vector<GazeSample> read_gaze_file(const std::filesystem::path& file);

/// Directions come back bit for bit. samples: at least one, times from 0 ascending, directions of
/// unit length where valid. Throws Error if they are not so, or the file cannot be written.
void write_gaze_file(const std::filesystem::path& file, std::span<const GazeSample> samples);

/// Samples that arrived one after the other, as they can be written and replayed: times count from
/// the first one's, and what is not later than all before it is left out.
std::vector<GazeSample> replayable(std::span<const GazeSample> arrived);

/// Replays samples: one of time t is delivered at start + t + latency, as of start + t.
class RecordedEyeTracker final : public EyeTracker {
 public:
  /// samples: times ascending; there may be none. Throws Error otherwise.
  RecordedEyeTracker(std::vector<GazeSample> samples, Nanoseconds start, Nanoseconds latency);
  void poll(Nanoseconds now, std::vector<GazeSample>& arrived) override;

 private:
  std::vector<GazeSample> samples_;
  Nanoseconds start_;
  Nanoseconds latency_;
  std::size_t next_ = 0;  ///< the index of the sample to be delivered next
};

}  // namespace foveola
