#include "study/person/forms/typed_number.h"

#include "tests/matchers.h"

namespace foveola::study {
namespace {

// By how numbers are written (BIPM, The International System of Units, 5.4.4; ISO 80000-1, 7.3.2):
// with either decimal mark; and by custom with the other one before each three digits.
TEST(TypedNumber, HasOneReadingWhereItsSeparatorsSayWhatTheyAre) {
  EXPECT_THAT(readings_of("1500"), ElementsAre(1500.0));
  EXPECT_THAT(readings_of("007"), ElementsAre(7.0));
  EXPECT_THAT(readings_of("1,5"), ElementsAre(1.5));
  EXPECT_THAT(readings_of("1.50"), ElementsAre(1.5));
  EXPECT_THAT(readings_of("-0,25"), ElementsAre(-0.25));
  EXPECT_THAT(readings_of("0,500"), ElementsAre(0.5)) << "no thousands begin with 0";
  EXPECT_THAT(readings_of("1500,125"), ElementsAre(1500.125));
  EXPECT_THAT(readings_of("1,500.25"), ElementsAre(1500.25));
  EXPECT_THAT(readings_of("1.500,25"), ElementsAre(1500.25));
  EXPECT_THAT(readings_of("1.234.567"), ElementsAre(1234567.0));
  EXPECT_THAT(readings_of("12,345,678.9"), ElementsAre(12345678.9));
  EXPECT_THAT(readings_of(".5"), ElementsAre(0.5));
  EXPECT_THAT(readings_of("5,"), ElementsAre(5.0));
}

TEST(TypedNumber, HasTwoReadingsWhereThreeDigitsFollowItsOnlySeparator) {
  EXPECT_THAT(readings_of("1,500"), ElementsAre(1.5, 1500.0));
  EXPECT_THAT(readings_of("1.500"), ElementsAre(1.5, 1500.0));
  EXPECT_THAT(readings_of("-12,345"), ElementsAre(-12.345, -12345.0));
  EXPECT_THAT(readings_of("100.000"), ElementsAre(100.0, 100000.0));
}

TEST(TypedNumber, HasNoReadingIfItIsNone) {
  for (const char* const typed : {"", "-", ".", ",", "1-2", "--1", "1,50,000", "1,5,3", "1.5,3.2",
                                  "1,500,00", "12,34.5", "1234,567,890", "1,,500", "e", "1e3"}) {
    EXPECT_THAT(readings_of(typed), IsEmpty()) << typed;
  }
}

TEST(TypedNumber, CanBeTypedWithOneReading) {
  EXPECT_EQ(unambiguous(1.5), "1.5");
  EXPECT_EQ(unambiguous(1.125, ','), "1,1250");
  for (const double number : {0.0, 31.0, 1.125, -12.345, 0.125, 1234.567}) {
    EXPECT_THAT(readings_of(unambiguous(number)), ElementsAre(number));
    EXPECT_THAT(readings_of(unambiguous(number, ',')), ElementsAre(number));
  }
}

}  // namespace
}  // namespace foveola::study
