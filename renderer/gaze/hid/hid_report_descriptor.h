// What a HID device says that its reports hold: a report descriptor (Device Class Definition for
// Human Interface Devices, version 1.11, section 6.2.2) as plain values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foveola {

/// What a number or a collection is: a page of the HID Usage Tables and an entry on it.
struct HidUsage {
  std::uint16_t page = 0;
  std::uint16_t id = 0;
  bool operator==(const HidUsage&) const = default;
};

/// The usages from `first` to the one on its page with `last_id`, both included.
struct HidUsageRange {
  HidUsage first;
  std::uint16_t last_id = 0;
};

/// What one main item (Input, Output or Feature) adds to a report: numbers of one size, one behind
/// the other.
struct HidField {
  /// The numbers of a variable field take them in turn, those left over take the last; the numbers
  /// of an array each choose among them. Empty if nobody says what the numbers are.
  std::vector<HidUsageRange> usages;
  std::vector<HidUsage> collections;  ///< those it is in, the outermost first
  std::uint32_t bit_offset = 0;  ///< offset of the first number; the report's id does not count
  std::uint32_t bit_size = 0;    ///< size of one number
  std::uint32_t count = 0;
  std::int64_t logical_minimum = 0;  ///< least value of the numbers as sent
  std::int64_t logical_maximum = 0;  ///< not less; if equal, nothing is known
  std::int64_t physical_minimum = 0;
  std::int64_t physical_maximum = 0;  ///< both 0: the physical range is the logical one
  std::uint32_t unit = 0;             ///< as sent, see hid_number.h
  int unit_exponent = 0;              ///< exponent of ten, in [-20, 20]
  bool is_variable = false;           ///< else an array

  /// Negative numbers are in two's complement (section 5.8).
  bool is_signed() const { return logical_minimum < 0; }
};

enum class HidReportKind { input, output, feature };

struct HidReport {
  HidReportKind kind = HidReportKind::input;
  std::uint8_t id = 0;         ///< 0: the device's reports have no ids
  std::uint32_t bit_size = 0;  ///< size of all fields together
  std::size_t size_bytes = 0;  ///< size as it travels: with its id, if it has one
  std::vector<HidField> fields;
};

struct HidReportDescriptor {
  std::vector<HidReport> reports;  ///< in the order of their first fields
};

/// What a descriptor may ask for; one that asks for more is refused.
struct HidLimits {
  static constexpr std::uint32_t report_bits = 8 * 65536;
  static constexpr std::size_t fields = 4096;  ///< fields of all reports together
  static constexpr std::size_t collection_depth = 64;
  static constexpr std::size_t pushed_states = 64;
};

/// Reads a whole descriptor. Throws Error with the offset of the byte where it makes no sense or
/// asks for more than HidLimits.
HidReportDescriptor parse_report_descriptor(std::span<const std::uint8_t> bytes);

/// Some of the numbers of a field, one behind the other.
struct HidNumberRun {
  std::uint32_t first = 0;  ///< index in the field
  std::uint32_t count = 0;
};

/// Those that stand for `usage`; none if the field has no such usage or is an array of choices.
HidNumberRun numbers_with(const HidField& field, const HidUsage& usage);

}  // namespace foveola
