// Parses items of a HID report descriptor (HID 1.11, section 6.2.2), and numbers in reports.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "renderer/gaze/hid/hid_report_descriptor.h"

namespace foveola {

/// The quantity of a number, which is read in the unit named here.
enum class HidQuantity {
  count,         ///< as sent, whatever its unit and its physical range
  length_m,      ///< sent in centimetres or inches, times a power of ten
  time_s,        ///< sent in a unit of time
  frequency_hz,  ///< sent in a unit of frequency
};

/// One HID unit (HID 1.11, section 6.2.2.7: a nibble for the system of units and one for the
/// exponent of each base unit) times 10^unit_exponent, in the unit of `quantity`. nullopt for a
/// unit of another quantity, or without one.
std::optional<double> si_units_in(std::uint32_t unit, int unit_exponent, HidQuantity quantity);

/// A number in a report. Outside its limits it has no value (a null value, section 6.2.2.5).
struct HidNumber {
  std::uint32_t bit_offset = 0;  ///< from the report's first byte, which is its id, if any
  std::uint32_t bit_size = 0;    ///< 1 to 64
  bool is_signed = false;
  bool has_limits = false;   ///< whether the next two are valid; never with more than 32 bits
  std::int64_t minimum = 0;  ///< as sent
  std::int64_t maximum = 0;
  double scale = 1.0;  ///< value = scale * (raw value) + offset, in the quantity's unit
  double offset = 0.0;
};

/// The numbers `run` of a field as one number; several are its pieces, the least significant first.
/// nullopt if it has no bits, more than 64, or another quantity. A logical range limits, and a
/// physical one scales, only a single piece of at most 32 bits: no item could give them for more.
std::optional<HidNumber> number_in(const HidReport& report, const HidField& field,
                                   const HidNumberRun& run, HidQuantity quantity);

/// Its value in a report. nullopt if it is outside the limits, or beyond the report's end.
std::optional<double> value_of(const HidNumber& number, std::span<const std::uint8_t> report);

/// Writes the raw bits of a number; excess bits are lost. The report must not end before it.
void put_bits(const HidNumber& number, std::uint64_t bits, std::span<std::uint8_t> report);

/// Kinds of items that describe a report's numbers. The value is an item's prefix without the two
/// size bits (section 6.2.2.2).
enum class HidItemKind : std::uint8_t {
  input = 0x80,
  output = 0x90,
  collection = 0xA0,
  feature = 0xB0,
  end_collection = 0xC0,
  usage_page = 0x04,
  logical_minimum = 0x14,
  logical_maximum = 0x24,
  physical_minimum = 0x34,
  physical_maximum = 0x44,
  unit_exponent = 0x54,
  unit = 0x64,
  report_size = 0x74,
  report_id = 0x84,
  report_count = 0x94,
  push = 0xA4,
  pop = 0xB4,
  usage = 0x08,
  usage_minimum = 0x18,
  usage_maximum = 0x28,
  delimiter = 0xA8,
};

/// Raw data of an item; the sign depends on the item's kind, and for some kinds on other items.
struct HidItemData {
  std::uint32_t bits = 0;
  unsigned size_bytes = 0;  ///< 0, 1, 2 or 4

  std::int64_t as_signed() const;
};

struct HidItem {
  std::size_t offset = 0;  ///< offset of its first byte in the descriptor
  HidItemKind kind{};      ///< or an unlisted value
  HidItemData data;
};

/// Reads the items of a descriptor, one by one.
class HidItemReader {
 public:
  /// bytes: must outlive the reader.
  explicit HidItemReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  /// The next item; nullopt at the end. Long items, for which no kind was ever defined, are
  /// skipped. Throws Error if the item is truncated.
  std::optional<HidItem> next();

 private:
  std::uint8_t take_byte(std::size_t item_offset);
  void skip_long_item();

  std::span<const std::uint8_t> bytes_;
  std::size_t position_ = 0;
};

/// Throws the Error for an invalid descriptor at the byte with this offset.
[[noreturn]] void refuse_descriptor(std::size_t offset, const std::string& what);

}  // namespace foveola
