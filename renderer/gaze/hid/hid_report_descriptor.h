// Parses a HID report descriptor (Device Class Definition for Human Interface Devices, version
// 1.11, section 6.2.2) into plain values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foveola {

/// Identifies a number or a collection: a page of the HID Usage Tables and an entry on it.
struct HidUsage {
  std::uint16_t page = 0;
  std::uint16_t id = 0;
  bool operator==(const HidUsage&) const = default;
};

/// The usages from `first` to `last_id` on the same page, both included.
struct HidUsageRange {
  HidUsage first;
  std::uint16_t last_id = 0;
};

/// The numbers that one main item (Input, Output or Feature) adds to a report: contiguous, of one
/// size.
struct HidField {
  /// Assigned in turn to the numbers of a variable field, the last one to the rest; an array's
  /// numbers each choose among them. Empty if not stated.
  std::vector<HidUsageRange> usages;
  std::vector<HidUsage> collections;  ///< enclosing collections, the outermost first
  std::uint32_t bit_offset = 0;       ///< offset of the first number, without the report's id
  std::uint32_t bit_size = 0;         ///< size of one number
  std::uint32_t count = 0;
  std::int64_t logical_minimum = 0;  ///< minimum of the raw numbers
  std::int64_t logical_maximum = 0;  ///< not less; if equal, unknown
  std::int64_t physical_minimum = 0;
  std::int64_t physical_maximum = 0;  ///< both 0: the physical range is the logical one
  std::uint32_t unit = 0;             ///< as encoded, see si_units_in()
  int unit_exponent = 0;              ///< exponent of ten, in [-20, 20]
  bool is_variable = false;           ///< otherwise an array

  /// Negative numbers are in two's complement (section 5.8).
  bool is_signed() const { return logical_minimum < 0; }
};

enum class HidReportKind { input, output, feature };

struct HidReport {
  HidReportKind kind = HidReportKind::input;
  std::uint8_t id = 0;         ///< 0: without ids
  std::uint32_t bit_size = 0;  ///< size of all fields together
  std::size_t size_bytes = 0;  ///< including its id, if any
  std::vector<HidField> fields;
};

struct HidReportDescriptor {
  std::vector<HidReport> reports;  ///< in order of their first fields
};

/// Limits of a descriptor; beyond them it is refused.
struct HidLimits {
  static constexpr std::uint32_t report_bits = 8 * 65536;
  static constexpr std::size_t fields = 4096;  ///< of all reports together
  static constexpr std::size_t collection_depth = 64;
  static constexpr std::size_t pushed_states = 64;
};

/// Parses a whole descriptor. Throws Error with the offset of the byte that is invalid or exceeds
/// HidLimits.
HidReportDescriptor parse_report_descriptor(std::span<const std::uint8_t> bytes);

/// Contiguous numbers of a field.
struct HidNumberRun {
  std::uint32_t first = 0;  ///< index in the field
  std::uint32_t count = 0;
};

/// The numbers with `usage`; none if the field lacks the usage or is an array of choices.
HidNumberRun numbers_with(const HidField& field, const HidUsage& usage);

}  // namespace foveola
