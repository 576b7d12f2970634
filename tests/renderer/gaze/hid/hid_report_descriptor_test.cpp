#include "renderer/gaze/hid/hid_report_descriptor.h"

#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "renderer/base/error.h"
#include "tests/matchers.h"
#include "tests/renderer/gaze/hid_reference.h"

namespace foveola {
namespace {

using test::Bytes;
using test::from_hex;
using test::operator+;

HidReportDescriptor parse(const std::string& digits) {
  return parse_report_descriptor(from_hex(digits));
}

/// The one field of a descriptor's one report.
HidField only_field(const std::string& digits) {
  const HidReportDescriptor descriptor = parse(digits);
  EXPECT_EQ(descriptor.reports.size(), 1U);
  EXPECT_EQ(descriptor.reports.at(0).fields.size(), 1U);
  return descriptor.reports.at(0).fields.at(0);
}

Bytes repeated(const Bytes& bytes, int times) {
  Bytes result;
  for (int i = 0; i < times; ++i) {
    result.insert(result.end(), bytes.begin(), bytes.end());
  }
  return result;
}

// The sizes are those of the structures in Tracker.h.
TEST(ReportDescriptor, HasTheReportsOfTheReferenceDevice) {
  const HidReportDescriptor descriptor = parse_report_descriptor(test::reference_descriptor());
  struct Expected {
    HidReportKind kind;
    int id;
    std::size_t size_bytes;
  };
  const std::vector<Expected> expected = {
      {HidReportKind::input, 0x10, 65},   {HidReportKind::feature, 0x11, 22},
      {HidReportKind::feature, 0x12, 19}, {HidReportKind::feature, 0x13, 4},
      {HidReportKind::input, 0x13, 4},    {HidReportKind::feature, 0x14, 2}};
  ASSERT_EQ(descriptor.reports.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(descriptor.reports[i].kind, expected[i].kind) << i;
    EXPECT_EQ(descriptor.reports[i].id, expected[i].id) << i;
    EXPECT_EQ(descriptor.reports[i].size_bytes, expected[i].size_bytes) << i;
  }
}

TEST(ReportDescriptor, HasTheTrackingDataOfTheReferenceDevice) {
  const HidReportDescriptor descriptor = parse_report_descriptor(test::reference_descriptor());
  const HidReport& tracking = descriptor.reports.at(0);
  ASSERT_EQ(tracking.fields.size(), 5U);

  const HidField& time = tracking.fields[0];
  EXPECT_EQ(time.bit_offset, 0U);
  EXPECT_EQ(time.bit_size, 8U);
  EXPECT_EQ(time.count, 8U);
  EXPECT_EQ(time.unit, 0x1001U);
  EXPECT_EQ(time.unit_exponent, -6);
  EXPECT_EQ(time.logical_maximum, 255);
  EXPECT_FALSE(time.is_signed());
  EXPECT_THAT(time.collections, ElementsAre(HidUsage{0x12, 0x01}, HidUsage{0x12, 0x10}));

  const HidField& gaze = tracking.fields[1];
  EXPECT_EQ(gaze.bit_offset, 64U);
  EXPECT_EQ(gaze.bit_size, 32U);
  EXPECT_EQ(gaze.count, 2U);
  EXPECT_EQ(gaze.unit, 0x11U);
  EXPECT_EQ(gaze.unit_exponent, -4);
  EXPECT_EQ(gaze.logical_minimum, -2'000'000);
  EXPECT_EQ(gaze.logical_maximum, 2'000'000);
  EXPECT_TRUE(gaze.is_signed());
  EXPECT_TRUE(gaze.is_variable);
  EXPECT_THAT(gaze.collections,
              ElementsAre(HidUsage{0x12, 0x01}, HidUsage{0x12, 0x10}, HidUsage{0x12, 0x24}));
  ASSERT_EQ(gaze.usages.size(), 2U);
  EXPECT_EQ(gaze.usages[1].first, (HidUsage{0x12, 0x22}));

  EXPECT_EQ(tracking.fields[2].bit_offset, 128U);
  EXPECT_EQ(tracking.fields[3].bit_offset, 224U);
  const HidField& head = tracking.fields[4];
  EXPECT_EQ(head.bit_offset, 320U);
  EXPECT_EQ(head.count, 6U);
  EXPECT_TRUE(head.usages.empty());
  EXPECT_EQ(tracking.bit_size, 512U);
}

TEST(ReportDescriptor, AUsageOfFourBytesCarriesItsPage) {
  const HidField field =
      only_field("05 01 0b 01 00 12 00 a1 01 0b 20 00 12 00 75 08 95 01 81 02 c0");
  EXPECT_EQ(field.collections.at(0), (HidUsage{0x12, 0x01}));
  EXPECT_EQ(field.usages.at(0).first, (HidUsage{0x12, 0x20}));
}

TEST(ReportDescriptor, AShortUsageTakesThePageThatHoldsAtTheMainItem) {
  const HidField field = only_field("05 01 09 20 05 12 75 08 95 01 81 02");
  EXPECT_EQ(field.usages.at(0).first, (HidUsage{0x12, 0x20}));
}

TEST(ReportDescriptor, UsagesHoldForOneMainItemOnly) {
  const HidReportDescriptor descriptor = parse("05 12 75 08 95 01 09 20 81 02 81 02");
  EXPECT_EQ(descriptor.reports.at(0).fields.at(0).usages.size(), 1U);
  EXPECT_TRUE(descriptor.reports.at(0).fields.at(1).usages.empty());
}

TEST(ReportDescriptor, RangesOfUsages) {
  const HidField field = only_field("05 09 19 01 29 05 1b 30 00 01 00 29 32 75 01 95 08 81 02");
  ASSERT_EQ(field.usages.size(), 2U);
  EXPECT_EQ(field.usages[0].first, (HidUsage{0x09, 0x01}));
  EXPECT_EQ(field.usages[0].last_id, 0x05);
  EXPECT_EQ(field.usages[1].first, (HidUsage{0x01, 0x30}));
  EXPECT_EQ(field.usages[1].last_id, 0x32);
}

TEST(ReportDescriptor, OfDelimitedUsagesTheFirstCounts) {
  const HidField field = only_field("05 12 a9 01 09 21 09 22 a9 00 09 23 75 08 95 02 81 02");
  ASSERT_EQ(field.usages.size(), 2U);
  EXPECT_EQ(field.usages[0].first.id, 0x21);
  EXPECT_EQ(field.usages[1].first.id, 0x23);
}

TEST(ReportDescriptor, PopBringsBackWhatWasPushed) {
  const HidReportDescriptor descriptor =
      parse("05 12 75 08 95 01 85 07 a4 75 10 95 03 15 ff 65 11 85 08 81 02 b4 81 02");
  ASSERT_EQ(descriptor.reports.size(), 2U);
  const HidField& inner = descriptor.reports[0].fields.at(0);
  EXPECT_EQ(descriptor.reports[0].id, 8);
  EXPECT_EQ(inner.bit_size, 16U);
  EXPECT_EQ(inner.unit, 0x11U);
  const HidField& outer = descriptor.reports[1].fields.at(0);
  EXPECT_EQ(descriptor.reports[1].id, 7);
  EXPECT_EQ(outer.bit_size, 8U);
  EXPECT_EQ(outer.count, 1U);
  EXPECT_EQ(outer.unit, 0U);
  EXPECT_EQ(outer.logical_minimum, 0);
}

TEST(ReportDescriptor, AReportGoesOnWhereItStopped) {
  const HidReportDescriptor descriptor =
      parse("75 08 95 01 85 01 81 02 85 02 81 02 85 01 95 02 81 02 91 02");
  ASSERT_EQ(descriptor.reports.size(), 3U);
  ASSERT_EQ(descriptor.reports[0].fields.size(), 2U);
  EXPECT_EQ(descriptor.reports[0].fields[1].bit_offset, 8U);
  EXPECT_EQ(descriptor.reports[0].size_bytes, 4U);
  EXPECT_EQ(descriptor.reports[1].size_bytes, 2U);
  EXPECT_EQ(descriptor.reports[2].kind, HidReportKind::output);
  EXPECT_EQ(descriptor.reports[2].fields[0].bit_offset, 0U);
}

TEST(ReportDescriptor, WithoutIdsAReportIsItsFieldsRoundedUpToBytes) {
  const HidReportDescriptor descriptor = parse("75 03 95 03 81 02");
  EXPECT_EQ(descriptor.reports.at(0).id, 0);
  EXPECT_EQ(descriptor.reports.at(0).bit_size, 9U);
  EXPECT_EQ(descriptor.reports.at(0).size_bytes, 2U);
}

TEST(ReportDescriptor, AMaximumHasASignIfTheMinimumIsNegative) {
  EXPECT_EQ(only_field("15 00 25 ff 75 08 95 01 81 02").logical_maximum, 255);
  EXPECT_EQ(only_field("25 ff 15 80 75 08 95 01 81 02").logical_maximum, -1);
  EXPECT_EQ(only_field("35 00 45 ff 75 08 95 01 81 02").physical_maximum, 255);
  EXPECT_EQ(only_field("35 80 45 ff 75 08 95 01 81 02").physical_maximum, -1);
  EXPECT_EQ(only_field("27 ff ff ff ff 75 20 95 01 81 02").logical_maximum, 4294967295);
}

TEST(ReportDescriptor, UnitExponentsAreNibblesOrWholeBytes) {
  EXPECT_EQ(only_field("55 07 75 08 95 01 81 02").unit_exponent, 7);
  EXPECT_EQ(only_field("55 08 75 08 95 01 81 02").unit_exponent, -8);
  EXPECT_EQ(only_field("55 0f 75 08 95 01 81 02").unit_exponent, -1);
  EXPECT_EQ(only_field("55 fc 75 08 95 01 81 02").unit_exponent, -4);
}

TEST(ReportDescriptor, AFieldIsVariableOrAnArray) {
  const auto is_variable = [](const std::string& main_item) {
    return only_field("75 08 95 01 " + main_item).is_variable;
  };
  EXPECT_FALSE(is_variable("80"));
  EXPECT_FALSE(is_variable("81 01"));
  EXPECT_TRUE(is_variable("81 02"));
  EXPECT_TRUE(is_variable("81 06"));
}

TEST(ReportDescriptor, SkipsWhatSaysNothingOfNumbers) {
  const HidField field =
      only_field("39 01 79 02 89 03 c4 fe 02 f0 aa bb 05 12 09 20 75 08 95 01 81 02");
  EXPECT_EQ(field.usages.size(), 1U);
  EXPECT_TRUE(parse("").reports.empty());
  EXPECT_TRUE(parse("75 00 95 08 81 02 75 08 95 00 81 02").reports.empty());
}

TEST(ReportDescriptor, IsRefusedWhereItMakesNoSense) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"05 12 09", "byte 2: the item is cut off"},
      {"05 12 fe 05 00 aa", "byte 2: the long item is cut off"},
      {"a1 01 c0 c0", "byte 3: no collection is open"},
      {"a1 01", "byte 2: a collection has no end"},
      {"75 08 b4", "byte 2: no state was pushed"},
      {"75 08 85 00", "byte 2: a report's id"},
      {"86 00 01", "byte 0: a report's id"},
      {"07 00 00 01 00", "byte 0: a usage page"},
      {"75 08 29 05", "byte 2: a usage maximum follows no usage minimum"},
      {"19 05 29 04", "byte 2: a usage maximum is below"},
      {"1b 01 00 12 00 2b 02 00 13 00", "byte 5: a usage maximum is below"},
      {"a9 00", "byte 0: delimiters"},
      {"a9 01 a9 01", "byte 2: delimiters"},
      {"55 40", "byte 0: no unit has an exponent of 64"},
      {"15 05 25 04 75 08 95 01 81 02", "byte 8: the logical maximum"},
      {"75 08 95 01 81 02 85 01 81 02", "byte 10: some reports have an id"},
      {"77 ff ff ff ff 97 ff ff ff ff 81 02", "byte 10: a report is longer"}};
  for (const auto& bad : cases) {
    EXPECT_THAT([&] { parse(bad.first); }, ThrowsMessage<Error>(HasSubstr(bad.second)))
        << bad.first;
  }
}

// From its sixth byte to its last but one, a collection is open.
TEST(ReportDescriptor, IsRefusedIfItIsCutOff) {
  const Bytes whole = test::reference_descriptor();
  for (std::size_t size = 6; size < whole.size(); ++size) {
    EXPECT_THROW(parse_report_descriptor(std::span(whole).first(size)), Error) << size;
  }
}

TEST(ReportDescriptor, HasItsLimits) {
  // 64 KiB in a report, as sixteen fields of 256 numbers of 16 bytes, and one bit more.
  const Bytes largest = from_hex("75 80 96 00 01") + repeated(from_hex("81 02"), 16);
  EXPECT_EQ(parse_report_descriptor(largest).reports.at(0).size_bytes, 65536U);
  EXPECT_THAT([&] { parse_report_descriptor(largest + from_hex("75 01 95 01 81 02")); },
              ThrowsMessage<Error>(HasSubstr("byte 41: a report is longer")));

  const Bytes fields = from_hex("75 01 95 01") + repeated(from_hex("81 02"), 4096);
  EXPECT_EQ(parse_report_descriptor(fields).reports.at(0).fields.size(), 4096U);
  EXPECT_THAT([&] { parse_report_descriptor(fields + from_hex("b1 02")); },
              ThrowsMessage<Error>(HasSubstr("more than 4096 fields")));

  EXPECT_NO_THROW(
      parse_report_descriptor(repeated(from_hex("a1 00"), 64) + repeated(from_hex("c0"), 64)));
  EXPECT_THAT([&] { parse_report_descriptor(repeated(from_hex("a1 00"), 65)); },
              ThrowsMessage<Error>(HasSubstr("byte 128: collections are nested too deeply")));

  EXPECT_NO_THROW(parse_report_descriptor(repeated(from_hex("a4"), 64)));
  EXPECT_THAT([&] { parse_report_descriptor(repeated(from_hex("a4"), 65)); },
              ThrowsMessage<Error>(HasSubstr("byte 64: too many states")));
}

HidNumberRun run_of(const HidField& field, std::uint16_t id) {
  return numbers_with(field, {.page = 0x12, .id = id});
}

TEST(NumbersWith, TheUsagesInTurnAndTheLastForTheRest) {
  const HidField field = only_field("05 12 09 21 19 30 29 32 09 23 75 08 95 07 81 02");
  EXPECT_EQ(run_of(field, 0x21).first, 0U);
  EXPECT_EQ(run_of(field, 0x21).count, 1U);
  EXPECT_EQ(run_of(field, 0x31).first, 2U);
  EXPECT_EQ(run_of(field, 0x31).count, 1U);
  EXPECT_EQ(run_of(field, 0x32).count, 1U);
  EXPECT_EQ(run_of(field, 0x23).first, 4U);
  EXPECT_EQ(run_of(field, 0x23).count, 3U);
  EXPECT_EQ(run_of(field, 0x22).count, 0U);
}

TEST(NumbersWith, NoneForUsagesThatAreMoreThanTheNumbers) {
  const HidField field = only_field("05 12 09 21 09 22 09 23 75 08 95 02 81 02");
  EXPECT_EQ(run_of(field, 0x22).count, 1U);
  EXPECT_EQ(run_of(field, 0x23).count, 0U);
}

TEST(NumbersWith, NoneOnAnotherPageOrInAnArray) {
  EXPECT_EQ(run_of(only_field("05 13 09 21 75 08 95 01 81 02"), 0x21).count, 0U);
  EXPECT_EQ(run_of(only_field("05 12 09 21 75 08 95 01 81 00"), 0x21).count, 0U);
}

TEST(NumbersWith, TheWholeTimeStampOfTheReference) {
  const HidReportDescriptor descriptor = parse_report_descriptor(test::reference_descriptor());
  EXPECT_EQ(run_of(descriptor.reports.at(0).fields.at(0), 0x20).count, 8U);
}

}  // namespace
}  // namespace foveola
