// Text of the Open Gaze API (Gazepoint, version 2.0): requests to a tracker's program, and its
// stream.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/base/vec.h"

namespace foveola {

/// Default address of Gazepoint's program.
struct OpenGazeAddress {
  std::string host = "127.0.0.1";
  std::uint16_t port = 4242;
};

/// The requests that start the records: each eye's point of gaze and the best one, the tracker's
/// time and a counter, and then the sending.
std::string open_gaze_requests();

enum class OpenGazeKind {
  record,           ///< REC: one sample
  acknowledgement,  ///< ACK: an accepted request
  refusal,          ///< NACK
  other             ///< others, such as CAL, a calibration
};

/// One line of the stream: an empty XML element.
struct OpenGazeElement {
  OpenGazeKind kind = OpenGazeKind::other;
  std::map<std::string, std::string, std::less<>> attributes;  ///< as sent, with entities
};

/// nullopt if the line, without its end, is not such an element: a quote is missing, an attribute
/// is repeated, it has control characters, or anything else.
std::optional<OpenGazeElement> parse_open_gaze(std::string_view line);

/// Assembles lines, ended by CR, LF or both, from bytes in any portions.
class OpenGazeStream {
 public:
  /// Longer lines are garbage, and cut to this length.
  static constexpr std::size_t longest_line_bytes = 8192;

  /// The elements whose lines end in `bytes`.
  std::vector<OpenGazeElement> take(std::string_view bytes);
  /// Number of non-empty lines so far that were not elements.
  std::uint64_t garbage() const { return garbage_; }

 private:
  void append(std::string_view part);
  void end_line(std::vector<OpenGazeElement>& elements);

  std::string line_;
  bool is_too_long_ = false;
  std::uint64_t garbage_ = 0;
};

/// A point as fractions of the screen's width and height, from its top left corner.
struct PointOfGaze {
  DVec2 fraction{0.0, 0.0};
  bool valid = false;
  bool is_unreadable = false;  ///< declared valid, with coordinates that are not numbers
};

/// The used numbers of a record, with a decimal point or comma; nullopt if absent or not a number.
struct OpenGazeRecord {
  std::optional<std::int64_t> count;  ///< CNT: increases by one per sample of the tracker
  std::optional<double> time_s;       ///< TIME, by the tracker's clock, in [0, 1e9]
  std::optional<PointOfGaze> best;    ///< BPOGX, BPOGY, BPOGV
  std::optional<PointOfGaze> left;    ///< LPOGX, LPOGY, LPOGV
  std::optional<PointOfGaze> right;   ///< RPOGX, RPOGY, RPOGV
};

/// A point with coordinates that are not numbers, or a hundred screens away, is invalid.
OpenGazeRecord record_from(const OpenGazeElement& element);

/// The gaze of both eyes: the mean of the valid ones, or invalid. Without single eyes, the record's
/// best point.
PointOfGaze combined_gaze(const OpenGazeRecord& record);

}  // namespace foveola
