// The Open Gaze API's text (Gazepoint, version 2.0): what is sent to a tracker's program, and what
// its stream says.
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

/// Where Gazepoint's program listens.
struct OpenGazeAddress {
  std::string host = "127.0.0.1";
  std::uint16_t port = 4242;
};

/// What has to be sent before records come: each eye's point of gaze and the better one, the
/// tracker's time and a counter, and then that they be sent at all.
std::string open_gaze_requests();

enum class OpenGazeKind {
  record,           ///< REC: one sample
  acknowledgement,  ///< ACK: a request that was understood
  refusal,          ///< NACK
  other             ///< others, such as CAL, a calibration's
};

/// One line of the stream: an XML element without content.
struct OpenGazeElement {
  OpenGazeKind kind = OpenGazeKind::other;
  std::map<std::string, std::string, std::less<>> attributes;  ///< as sent, entities and all
};

/// Empty where the line, without its end, is no such element: a quote is missing, an attribute
/// comes twice, there are control characters, or anything else.
std::optional<OpenGazeElement> parse_open_gaze(std::string_view line);

/// Puts lines, which end in CR, LF or both, together from bytes that arrive in any portions.
class OpenGazeStream {
 public:
  /// Longer lines are garbage, of which no more than this is kept.
  static constexpr std::size_t longest_line_bytes = 8192;

  /// The elements whose lines end in `bytes`.
  std::vector<OpenGazeElement> take(std::string_view bytes);
  /// The lines so far that were no elements; empty ones do not count.
  std::uint64_t garbage() const { return garbage_; }

 private:
  void append(std::string_view part);
  void end_line(std::vector<OpenGazeElement>& elements);

  std::string line_;
  bool is_too_long_ = false;
  std::uint64_t garbage_ = 0;
};

/// A point of a screen in fractions of its width and height, from its top left corner.
struct PointOfGaze {
  DVec2 fraction{0.0, 0.0};
  bool valid = false;
  bool is_unreadable = false;  ///< the tracker calls it valid, and its coordinates are no numbers
};

/// The numbers of a record that are used here, with a decimal point or comma; empty are those that
/// it has not, or not as numbers.
struct OpenGazeRecord {
  std::optional<std::int64_t> count;  ///< CNT: one more for each of the tracker's samples
  std::optional<double> time_s;       ///< TIME, by the tracker's clock, in [0, 1e9]
  std::optional<PointOfGaze> best;    ///< BPOGX, BPOGY, BPOGV
  std::optional<PointOfGaze> left;    ///< LPOGX, LPOGY, LPOGV
  std::optional<PointOfGaze> right;   ///< RPOGX, RPOGY, RPOGV
};

/// A point whose coordinates are no numbers, or lie a hundred screens away, is invalid.
OpenGazeRecord record_from(const OpenGazeElement& element);

/// Where both eyes look, by what is valid: the middle of both, one of them, or none. A record
/// without single eyes says it itself.
PointOfGaze combined_gaze(const OpenGazeRecord& record);

}  // namespace foveola
