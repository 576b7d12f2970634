// Items of a HID report descriptor (HID 1.11, section 6.2.2), and numbers in reports.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "renderer/gaze/hid/hid_report_descriptor.h"

namespace foveola {

/// What a number must measure, so that it is read in the unit named here.
enum class HidQuantity {
  count,         ///< as sent, whatever its unit and its physical range
  length_m,      ///< sent in centimetres or inches, times a power of ten
  time_s,        ///< sent in a unit of time
  frequency_hz,  ///< sent in a unit of frequency
};

/// One HID unit (HID 1.11, section 6.2.2.7: a nibble for the system of units and one for the
/// exponent of each base unit) times 10^unit_exponent, in the unit of `quantity`. Empty if a number
/// with this unit measures something else, or says nothing of what it measures.
std::optional<double> si_units_in(std::uint32_t unit, int unit_exponent, HidQuantity quantity);

/// A number that is outside its limits has no value (a null value, section 6.2.2.5).
struct HidNumber {
  std::uint32_t bit_offset = 0;  ///< from the report's first byte, which is its id if it has one
  std::uint32_t bit_size = 0;    ///< 1 to 64
  bool is_signed = false;
  bool has_limits = false;   ///< whether the next two mean anything; never with more than 32 bits
  std::int64_t minimum = 0;  ///< as sent
  std::int64_t maximum = 0;
  double scale = 1.0;  ///< value = scale * (as sent) + offset, in the quantity's unit
  double offset = 0.0;
};

/// The numbers `run` of a field, which are one number sent in pieces, the least significant first,
/// if there are several. Empty if it has no bits, more than 64, or does not measure `quantity`.
/// A logical range is heeded, and a physical one scales, only if there is one piece of at most 32
/// bits: no item could give them for more.
std::optional<HidNumber> number_in(const HidReport& report, const HidField& field,
                                   const HidNumberRun& run, HidQuantity quantity);

/// Its value in a report. Empty if it is outside the limits or the report ends before it.
std::optional<double> value_of(const HidNumber& number, std::span<const std::uint8_t> report);

/// Writes the bits of a number, as sent; those that do not fit into it are lost. The report must
/// not end before it.
void put_bits(const HidNumber& number, std::uint64_t bits, std::span<std::uint8_t> report);

/// The kinds that say something about the numbers of a report. The value is an item's prefix
/// without the two bits of its data's size (section 6.2.2.2).
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

/// Whether an item's data have a sign depends on its kind, and for some on other items.
struct HidItemData {
  std::uint32_t bits = 0;
  unsigned size_bytes = 0;  ///< 0, 1, 2 or 4

  std::int64_t as_signed() const;
};

struct HidItem {
  std::size_t offset = 0;  ///< offset of its first byte in the descriptor
  HidItemKind kind{};      ///< or another
  HidItemData data;
};

/// Takes the items off a descriptor, one by one.
class HidItemReader {
 public:
  /// bytes: must outlive the reader.
  explicit HidItemReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  /// The next item; empty at the end. Long items, of which no kind was ever defined, are skipped.
  /// Throws Error if the item is cut off.
  std::optional<HidItem> next();

 private:
  std::uint8_t take_byte(std::size_t item_offset);
  void skip_long_item();

  std::span<const std::uint8_t> bytes_;
  std::size_t position_ = 0;
};

/// Throws the Error of a descriptor that makes no sense at the byte with this offset.
[[noreturn]] void refuse_descriptor(std::size_t offset, const std::string& what);

}  // namespace foveola
