#include "renderer/gaze/hid/hid_items.h"

#include <cassert>
#include <cmath>

#include "renderer/base/error.h"

namespace foveola {
namespace {

constexpr std::uint8_t long_item_prefix = 0xFE;

// The systems of units, in a unit's lowest nibble.
constexpr std::uint32_t si_linear = 1;
constexpr std::uint32_t english_linear = 3;
constexpr std::uint32_t english_rotation = 4;

// A unit in which only the exponent of the length or the time is not 0.
constexpr std::uint32_t centimetres_or_inches = 0x10;
constexpr std::uint32_t seconds_to_one = 0x1000;
constexpr std::uint32_t seconds_to_minus_one = 0xF000;

constexpr double metres_per_centimetre = 0.01;
constexpr double metres_per_inch = 0.0254;

/// One base unit of the number's system in the unit of the quantity; nullopt if they do not match.
std::optional<double> si_units_in_base(std::uint32_t unit, HidQuantity quantity) {
  const std::uint32_t system = unit & 0xFU;
  const std::uint32_t dimension = unit & ~0xFU;
  const bool is_known = system >= si_linear && system <= english_rotation;
  switch (quantity) {
    case HidQuantity::count:
      break;
    case HidQuantity::length_m:
      if (dimension == centimetres_or_inches && (system == si_linear || system == english_linear)) {
        return system == si_linear ? metres_per_centimetre : metres_per_inch;
      }
      return std::nullopt;
    case HidQuantity::time_s:
      return is_known && dimension == seconds_to_one ? std::optional(1.0) : std::nullopt;
    case HidQuantity::frequency_hz:
      return is_known && dimension == seconds_to_minus_one ? std::optional(1.0) : std::nullopt;
  }
  return std::nullopt;
}

bool says_range(const HidField& field) { return field.logical_minimum < field.logical_maximum; }

void set_limits(HidNumber& number, const HidField& field) {
  number.has_limits = says_range(field);
  number.minimum = field.logical_minimum;
  number.maximum = field.logical_maximum;
}

/// The straight line from the logical range to the physical one (section 6.2.2.7).
void set_physical_scale(HidNumber& number, const HidField& field) {
  if (!says_range(field) || (field.physical_minimum == 0 && field.physical_maximum == 0)) {
    return;
  }
  const auto logical = static_cast<double>(field.logical_maximum - field.logical_minimum);
  const auto physical = static_cast<double>(field.physical_maximum - field.physical_minimum);
  number.scale = physical / logical;
  number.offset = static_cast<double>(field.physical_minimum) -
                  number.scale * static_cast<double>(field.logical_minimum);
}

/// A report's bits are counted from the lowest of its first byte (section 5.8).
std::uint64_t bits_of(const HidNumber& number, std::span<const std::uint8_t> report) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < number.bit_size; ++i) {
    const std::size_t at = number.bit_offset + i;
    bits |= std::uint64_t{(report[at / 8] >> (at % 8)) & 1U} << i;
  }
  return bits;
}

bool ends_before(std::span<const std::uint8_t> report, const HidNumber& number) {
  return 8 * report.size() < std::size_t{number.bit_offset} + number.bit_size;
}

std::int64_t with_sign_of_bit(std::uint64_t bits, std::uint32_t bit_size) {
  const std::uint32_t unused = 64 - bit_size;
  return static_cast<std::int64_t>(bits << unused) >> unused;
}

}  // namespace

std::optional<double> si_units_in(std::uint32_t unit, int unit_exponent, HidQuantity quantity) {
  if (quantity == HidQuantity::count) {
    return 1.0;
  }
  const std::optional<double> base = si_units_in_base(unit, quantity);
  return base ? std::optional(*base * std::pow(10.0, unit_exponent)) : std::nullopt;
}

std::optional<HidNumber> number_in(const HidReport& report, const HidField& field,
                                   const HidNumberRun& run, HidQuantity quantity) {
  const std::optional<double> unit = si_units_in(field.unit, field.unit_exponent, quantity);
  const std::uint64_t bits = std::uint64_t{run.count} * field.bit_size;
  if (!unit || bits == 0 || bits > 64) {
    return std::nullopt;
  }
  const std::uint32_t id_bits = report.id != 0 ? 8 : 0;
  HidNumber number{.bit_offset = id_bits + field.bit_offset + run.first * field.bit_size,
                   .bit_size = static_cast<std::uint32_t>(bits),
                   .is_signed = field.is_signed()};
  const bool is_ranged = run.count == 1 && bits <= 32;
  if (is_ranged) {
    set_limits(number, field);
  }
  if (is_ranged && quantity != HidQuantity::count) {
    set_physical_scale(number, field);
  }
  number.scale *= *unit;
  number.offset *= *unit;
  return number;
}

std::optional<double> value_of(const HidNumber& number, std::span<const std::uint8_t> report) {
  if (ends_before(report, number)) {
    return std::nullopt;
  }
  const std::uint64_t bits = bits_of(number, report);
  if (!number.is_signed && !number.has_limits) {
    return number.scale * static_cast<double>(bits) + number.offset;
  }
  const std::int64_t sent =
      number.is_signed ? with_sign_of_bit(bits, number.bit_size) : static_cast<std::int64_t>(bits);
  if (number.has_limits && (sent < number.minimum || sent > number.maximum)) {
    return std::nullopt;
  }
  return number.scale * static_cast<double>(sent) + number.offset;
}

void put_bits(const HidNumber& number, std::uint64_t bits, std::span<std::uint8_t> report) {
  assert(!ends_before(report, number));
  for (std::size_t i = 0; i < number.bit_size; ++i) {
    const std::size_t at = number.bit_offset + i;
    const auto mask = static_cast<std::uint8_t>(1U << (at % 8));
    const bool is_set = ((bits >> i) & 1U) != 0;
    report[at / 8] =
        static_cast<std::uint8_t>(is_set ? report[at / 8] | mask : report[at / 8] & ~mask);
  }
}

std::int64_t HidItemData::as_signed() const {
  switch (size_bytes) {
    case 1:
      return static_cast<std::int8_t>(bits);
    case 2:
      return static_cast<std::int16_t>(bits);
    default:
      return static_cast<std::int32_t>(bits);
  }
}

std::optional<HidItem> HidItemReader::next() {
  while (position_ < bytes_.size() && bytes_[position_] == long_item_prefix) {
    skip_long_item();
  }
  if (position_ == bytes_.size()) {
    return std::nullopt;
  }
  HidItem item{.offset = position_};
  const unsigned prefix = take_byte(item.offset);
  item.kind = static_cast<HidItemKind>(prefix & 0xFCU);
  item.data.size_bytes = (prefix & 3U) == 3U ? 4U : prefix & 3U;
  for (unsigned i = 0; i < item.data.size_bytes; ++i) {
    item.data.bits |= std::uint32_t{take_byte(item.offset)} << (8U * i);
  }
  return item;
}

std::uint8_t HidItemReader::take_byte(std::size_t item_offset) {
  if (position_ == bytes_.size()) {
    refuse_descriptor(item_offset, "the item is cut off");
  }
  return bytes_[position_++];
}

// Section 6.2.2.3: the prefix, the size of the data, a tag, the data.
void HidItemReader::skip_long_item() {
  const std::size_t offset = position_++;
  const std::size_t data_size = take_byte(offset);
  take_byte(offset);
  if (data_size > bytes_.size() - position_) {
    refuse_descriptor(offset, "the long item is cut off");
  }
  position_ += data_size;
}

void refuse_descriptor(std::size_t offset, const std::string& what) {
  throw Error("HID report descriptor, byte " + std::to_string(offset), what,
              "the device cannot be used with this firmware");
}

}  // namespace foveola
