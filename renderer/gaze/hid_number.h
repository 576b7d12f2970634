// A number in a HID device's report: where its bits are, and its value in SI units.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "renderer/gaze/hid_report_descriptor.h"

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

}  // namespace foveola
