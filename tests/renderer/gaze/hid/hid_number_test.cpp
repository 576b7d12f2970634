#include <string>

#include <gtest/gtest.h>

#include "renderer/gaze/hid/hid_items.h"
#include "tests/renderer/gaze/hid_reference.h"

namespace foveola {
namespace {

using test::Bytes;
using test::from_hex;

/// What the first field of a descriptor says as one number of the quantity.
std::optional<HidNumber> first_number(const std::string& digits, HidQuantity quantity) {
  const HidReportDescriptor descriptor = parse_report_descriptor(from_hex(digits));
  const HidReport& report = descriptor.reports.at(0);
  const HidField& field = report.fields.at(0);
  return number_in(report, field, {.first = 0, .count = field.count}, quantity);
}

// The units of the reference device, and those that HID 1.11 gives as examples in 6.2.2.7.
TEST(SiUnits, OfCommonUnits) {
  EXPECT_NEAR(*si_units_in(0x11, -4, HidQuantity::length_m), 1e-6, 1e-18);
  EXPECT_NEAR(*si_units_in(0x1001, -6, HidQuantity::time_s), 1e-6, 1e-18);
  EXPECT_DOUBLE_EQ(*si_units_in(0xF001, 0, HidQuantity::frequency_hz), 1.0);
  EXPECT_DOUBLE_EQ(*si_units_in(0x11, 0, HidQuantity::length_m), 0.01);
  EXPECT_DOUBLE_EQ(*si_units_in(0x13, -3, HidQuantity::length_m), 0.0254e-3);
  EXPECT_DOUBLE_EQ(*si_units_in(0x1003, -3, HidQuantity::time_s), 1e-3);
  EXPECT_DOUBLE_EQ(*si_units_in(0xF001, 3, HidQuantity::frequency_hz), 1e3);
}

TEST(SiUnits, NoneIfSomethingElseIsMeasured) {
  EXPECT_FALSE(si_units_in(0, 0, HidQuantity::length_m));
  EXPECT_FALSE(si_units_in(0, -6, HidQuantity::time_s));
  EXPECT_FALSE(si_units_in(0x1001, -6, HidQuantity::length_m));
  EXPECT_FALSE(si_units_in(0x14, 0, HidQuantity::length_m));    // degrees
  EXPECT_FALSE(si_units_in(0x21, 0, HidQuantity::length_m));    // square centimetres
  EXPECT_FALSE(si_units_in(0xF011, 0, HidQuantity::length_m));  // centimetres per second
  EXPECT_FALSE(si_units_in(0x111, 0, HidQuantity::length_m));   // gram centimetres
  EXPECT_FALSE(si_units_in(0x101001, 0, HidQuantity::time_s));  // ampere seconds
  EXPECT_FALSE(si_units_in(0x1001, 0, HidQuantity::frequency_hz));
  EXPECT_FALSE(si_units_in(0x101F, 0, HidQuantity::time_s));  // a vendor's own
  EXPECT_DOUBLE_EQ(*si_units_in(0x11, -4, HidQuantity::count), 1.0);
}

// Twelve bits from the fourth on of A5 3C 7E = 0111 1110 0011 1100 1010 0101: 3CA.
TEST(HidNumber, TakesBitsFromTheLowestOn) {
  const Bytes report = from_hex("a5 3c 7e");
  EXPECT_EQ(value_of({.bit_offset = 4, .bit_size = 12}, report), 0x3CA);
  EXPECT_EQ(value_of({.bit_offset = 0, .bit_size = 24}, report), 0x7E3CA5);
  EXPECT_EQ(value_of({.bit_offset = 23, .bit_size = 1}, report), 0);
  EXPECT_EQ(value_of({.bit_offset = 22, .bit_size = 1}, report), 1);
}

TEST(HidNumber, TheHighestBitIsTheSignIfItHasOne) {
  const Bytes report = from_hex("f0 0f ff ff ff ff ff ff ff ff");
  EXPECT_EQ(value_of({.bit_offset = 4, .bit_size = 8, .is_signed = true}, report), -1);
  EXPECT_EQ(value_of({.bit_offset = 4, .bit_size = 9, .is_signed = true}, report), 255);
  EXPECT_EQ(value_of({.bit_offset = 16, .bit_size = 64, .is_signed = true}, report), -1);
  EXPECT_EQ(value_of({.bit_offset = 16, .bit_size = 64}, report), 18446744073709551615.0);
}

TEST(HidNumber, HasNoValueOutsideItsLimits) {
  const HidNumber number{.bit_offset = 0,
                         .bit_size = 8,
                         .is_signed = true,
                         .has_limits = true,
                         .minimum = -2,
                         .maximum = 3,
                         .scale = 0.5,
                         .offset = 10.0};
  EXPECT_EQ(value_of(number, from_hex("fe")), 9.0);
  EXPECT_EQ(value_of(number, from_hex("03")), 11.5);
  EXPECT_FALSE(value_of(number, from_hex("fd")));
  EXPECT_FALSE(value_of(number, from_hex("04")));
}

TEST(HidNumber, HasNoValueBehindTheReportsEnd) {
  EXPECT_TRUE(value_of({.bit_offset = 8, .bit_size = 8}, from_hex("00 00")));
  EXPECT_FALSE(value_of({.bit_offset = 9, .bit_size = 8}, from_hex("00 00")));
  EXPECT_FALSE(value_of({.bit_offset = 0, .bit_size = 1}, {}));
}

TEST(HidNumber, PutBitsLeavesTheOthers) {
  Bytes report = from_hex("a5 3c 7e");
  put_bits({.bit_offset = 4, .bit_size = 12}, 0xF0F5, report);
  EXPECT_EQ(test::to_hex(report), "550F7E");
}

// Ten bits, -512 to 511, that stand for -10 to 10.46 degrees (HID 1.11 section 6.2.2.7: the
// resolution is 1023 / 20.46 counts per degree).
TEST(HidNumber, IsScaledToItsPhysicalRange) {
  const auto number =
      first_number("16 00 fe 26 ff 01 36 18 fc 46 16 04 65 11 55 0e 75 0a 95 01 09 01 81 02",
                   HidQuantity::length_m);
  ASSERT_TRUE(number);
  EXPECT_NEAR(*value_of(*number, from_hex("00 02")), -0.1, 1e-12);
  EXPECT_NEAR(*value_of(*number, from_hex("ff 01")), 0.1046, 1e-12);
  EXPECT_NEAR(*value_of(*number, from_hex("00 00")), 0.0024, 1e-12);
}

TEST(HidNumber, ACountIsNeverScaled) {
  const auto number = first_number("15 00 25 64 35 00 46 e8 03 65 11 55 0c 75 08 95 01 09 01 81 02",
                                   HidQuantity::count);
  ASSERT_TRUE(number);
  EXPECT_EQ(value_of(*number, from_hex("64")), 100.0);
  EXPECT_FALSE(value_of(*number, from_hex("65")));
}

TEST(HidNumber, BeginsBehindTheReportsId) {
  const std::string field = "66 01 10 75 08 95 01 09 01 81 02";
  EXPECT_EQ(first_number(field, HidQuantity::time_s)->bit_offset, 0U);
  EXPECT_EQ(first_number("85 05 " + field, HidQuantity::time_s)->bit_offset, 8U);
}

// The limits are those of each piece, not of the number.
TEST(HidNumber, InPiecesHasNoLimits) {
  const auto number = first_number("15 00 25 7f 35 00 45 01 66 01 10 55 0d 75 08 95 08 09 20 81 02",
                                   HidQuantity::time_s);
  ASSERT_TRUE(number);
  EXPECT_EQ(number->bit_size, 64U);
  EXPECT_NEAR(*value_of(*number, from_hex("e8 03 00 00 01 00 00 00")), 4294968.296, 1e-6);
}

// No item could say more of it than 32 bits.
TEST(HidNumber, OfMoreThan32BitsHasNoLimits) {
  const auto number = first_number("25 7f 66 01 10 75 40 95 01 09 20 81 02", HidQuantity::time_s);
  ASSERT_TRUE(number);
  EXPECT_EQ(value_of(*number, from_hex("00 00 00 00 00 00 00 80")), 9223372036854775808.0);
}

TEST(HidNumber, IsNoneOfMoreThan64Bits) {
  EXPECT_FALSE(first_number("66 01 10 75 08 95 09 09 20 81 02", HidQuantity::time_s));
  EXPECT_FALSE(first_number("66 01 10 75 41 95 01 09 20 81 02", HidQuantity::time_s));
}

}  // namespace
}  // namespace foveola
