// The eye tracker of Microsoft's reference code (GazeHid, drivers/driver.c and inc/Tracker.h): its
// report descriptor, and its reports laid out by hand as the packed structures there.
#pragma once

#include <cctype>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace foveola::test {

using Bytes = std::vector<std::uint8_t>;

/// The bytes of pairs of hexadecimal digits, between which there may be blanks.
inline Bytes from_hex(std::string_view digits) {
  Bytes bytes;
  for (std::size_t i = 0; i < digits.size();) {
    if (digits[i] == ' ') {
      ++i;
      continue;
    }
    bytes.push_back(
        static_cast<std::uint8_t>(std::stoul(std::string(digits.substr(i, 2)), nullptr, 16)));
    i += 2;
  }
  return bytes;
}

inline std::string to_hex(const Bytes& bytes) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string text;
  for (const std::uint8_t byte : bytes) {
    text += {digits[byte >> 4], digits[byte & 15]};
  }
  return text;
}

inline Bytes operator+(Bytes a, const Bytes& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// The 340 bytes of the reference device.
inline Bytes reference_descriptor() {
  return from_hex(
      "05 12 09 01 a1 01 09 10 a1 02 85 10 15 00 26 ff 00 75 08 09 20 66 01 10 55 0a 95 08 81 02 "
      "95 01 75 20 65 11 55 0c 17 80 7b e1 ff 27 80 84 1e 00 09 24 a1 00 95 02 09 21 09 22 81 03 "
      "c0 09 25 a1 00 95 03 09 21 09 22 09 23 81 03 c0 09 26 a1 00 95 03 09 21 09 22 09 23 81 03 "
      "c0 95 06 81 03 c0 "
      "09 11 a1 02 85 11 75 08 95 01 0a 00 01 15 00 25 01 65 00 55 00 b1 03 a1 00 95 05 75 20 17 "
      "80 7b e1 ff 27 80 84 1e 00 65 11 55 0c 0a 01 01 0a 02 01 0a 03 01 0a 04 01 0a 05 01 b1 03 "
      "c0 c0 "
      "09 12 a1 02 85 12 75 08 15 00 26 ff 00 95 01 75 10 27 ff ff 00 00 65 00 55 00 0a 00 02 b1 "
      "03 0a 01 02 b1 03 75 20 27 ff ff ff 7f 0a 02 02 b1 03 75 10 15 00 27 ff ff 00 00 0a 03 02 "
      "b1 03 a1 00 65 11 55 0c 27 ff ff ff 7f 75 20 0a 04 02 b1 03 0a 05 02 b1 03 c0 c0 "
      "09 13 a1 02 85 13 75 08 65 00 55 00 25 04 0a 01 03 b1 02 75 10 27 ff ff 00 00 66 01 f0 55 "
      "00 0a 00 03 b1 02 c0 "
      "09 13 a1 02 85 13 75 08 65 00 55 00 25 04 0a 01 03 81 02 75 10 27 ff ff 00 00 66 01 f0 55 "
      "00 0a 00 03 81 02 c0 "
      "09 14 a1 02 85 14 75 08 25 07 65 00 55 00 0a 00 04 b1 02 c0 c0");
}

/// The `size_bytes` lowest bytes of `value`, the lowest first.
inline Bytes little_endian(std::uint64_t value, std::size_t size_bytes) {
  Bytes bytes;
  for (std::size_t i = 0; i < size_bytes; ++i) {
    bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  }
  return bytes;
}

inline Bytes int32_bytes(std::int32_t value) {
  return little_endian(static_cast<std::uint32_t>(value), 4);
}

constexpr std::int32_t no_position = std::numeric_limits<std::int32_t>::max();

/// GAZE_REPORT, 65 bytes: an id, the time and fourteen numbers, the first two of which are the gaze
/// point, the next six the eyes, and the rest the head.
inline Bytes tracking_report(std::uint64_t time_us, std::int32_t gaze_x_um,
                             std::int32_t gaze_y_um) {
  Bytes report =
      Bytes{0x10} + little_endian(time_us, 8) + int32_bytes(gaze_x_um) + int32_bytes(gaze_y_um);
  for (int i = 0; i < 12; ++i) {
    report = report + int32_bytes(i < 6 ? 0 : no_position);
  }
  return report;
}

/// TRACKER_STATUS_REPORT, 4 bytes.
inline Bytes status_report(std::uint8_t status, std::uint16_t frequency_hz) {
  return Bytes{0x13, status} + little_endian(frequency_hz, 2);
}

/// CONFIGURATION_REPORT, 19 bytes: what the display is and how large.
inline Bytes configuration_report(std::uint32_t width_um, std::uint32_t height_um) {
  return Bytes{0x12} + little_endian(0x1111, 2) + little_endian(0x2222, 2) +
         little_endian(0x33333333, 4) + little_endian(0x4444, 2) + little_endian(width_um, 4) +
         little_endian(height_um, 4);
}

}  // namespace foveola::test
