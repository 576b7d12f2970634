// The items of which a HID report descriptor is a list (HID 1.11, section 6.2.2).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace foveola {

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
