// Recordings of gaze and head poses as comma-separated values, and the trackers that replay them.
//
// A gaze recording's first line is "time_ns,x,y,z,valid". Each further line is a sample: its time
// in whole nanoseconds from 0 on, later than the one before; the direction's components, of unit
// length in the head's axes; and 1. For an invalid sample, x, y and z are empty, and the last is 0:
//
//   time_ns,x,y,z,valid
//   0,0.6,0,-0.8,1
//   8333333,,,,0
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/base/text/csv.h"
#include "renderer/gaze/eye_tracker.h"
#include "renderer/gaze/head_tracker.h"

namespace foveola {

/// Maximum duration of a recording: 10^9 seconds.
inline constexpr Nanoseconds longest_recording{1'000'000'000'000'000'000};

struct RecordingFormat {
  std::string_view name;    ///< "gaze recording", for errors
  std::string_view header;  ///< the fields' names: "time_ns,x,y"
  /// A longer header for files with more fields; empty: none.
  std::string_view longer_header = {};
};

/// A line after the first.
class RecordedLine {
 public:
  /// where: "FILE:LINE". header: must outlive it. Throws Error for other fields than the header's,
  /// or if the first is not a time.
  RecordedLine(CsvRow fields, std::string where, std::string_view header);

  Nanoseconds time() const { return time_; }
  std::size_t field_count() const { return fields_.size(); }
  /// The field's text; the time is number 0.
  std::string_view field(std::size_t number) const { return fields_[number]; }
  /// The field as a number. Throws Error if it is not one from `minimum` to `maximum`. Value:
  /// float, double or std::int64_t.
  template <typename Value>
  Value value(std::size_t number, Value minimum, Value maximum) const;

  [[noreturn]] void fail(const std::string& what, const std::string& remedy) const;

 private:
  std::string where_;
  std::string_view header_;
  CsvRow fields_;
  Nanoseconds time_{0};
};

/// Calls `take` with each line, at least one. Lines may end with CR LF. Throws Error with FILE:LINE
/// if the file has another format.
void read_recording(const std::filesystem::path& file, const RecordingFormat& format,
                    const std::function<void(const RecordedLine&)>& take);

/// Whether times strictly ascend. Moment: has a `time`.
template <typename Moment>
bool times_ascend(std::span<const Moment> moments) {
  const auto is_not_earlier = [](const Moment& a, const Moment& b) { return a.time >= b.time; };
  return std::ranges::adjacent_find(moments, is_not_earlier) == moments.end();
}

/// Whether these moments' times could be read from a file.
template <typename Moment>
bool has_recordable_times(std::span<const Moment> moments) {
  return !moments.empty() && times_ascend(moments) && moments.front().time >= Nanoseconds::zero() &&
         moments.back().time <= longest_recording;
}

/// At least one pose, bit for bit as written; azimuths within 1000 either way, roll 0 if the file
/// has none. Throws Error with file:line for another format; lines may end with CR LF.
std::vector<HeadPose> read_head_file(const std::filesystem::path& file);

/// Replays poses: the one of time t at start + t. poses: at least one, times ascending. Throws
/// Error otherwise.
ScriptedHeadTracker replayed_head(std::vector<HeadPose> poses, Nanoseconds start);

/// At least one sample. Throws Error with file:line for another format; lines may end with CR LF,
/// and a direction's length may deviate from 1 by a thousandth.
std::vector<GazeSample> read_gaze_file(const std::filesystem::path& file);

/// Directions are restored bit for bit. samples: at least one, times from 0 ascending, directions
/// of unit length if valid. Throws Error otherwise, or if the file cannot be written.
void write_gaze_file(const std::filesystem::path& file, std::span<const GazeSample> samples);

/// Converts arrived samples to ones that can be written and replayed: times relative to the first
/// one's; samples not later than all before are left out.
std::vector<GazeSample> replayable(std::span<const GazeSample> arrived);

/// Replays samples: the one of time t is delivered at start + t + latency, with the time start + t.
class RecordedEyeTracker final : public EyeTracker {
 public:
  /// samples: times ascending; may be empty. Throws Error otherwise.
  RecordedEyeTracker(std::vector<GazeSample> samples, Nanoseconds start, Nanoseconds latency);
  void poll(Nanoseconds now, std::vector<GazeSample>& arrived) override;

 private:
  std::vector<GazeSample> samples_;
  Nanoseconds start_;
  Nanoseconds latency_;
  std::size_t next_ = 0;  ///< index of the next sample to deliver
};

}  // namespace foveola
