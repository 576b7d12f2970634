#include "renderer/base/text/csv.h"

#include "renderer/base/error.h"
#include "tests/matchers.h"

namespace foveola {
namespace {

TEST(Csv, QuotesAsRfc4180Asks) {
  EXPECT_EQ(format_csv({{"a", "b,c", "say \"hi\"", "two\nlines", ""}}),
            "a,\"b,c\",\"say \"\"hi\"\"\",\"two\nlines\",\r\n");
}

TEST(Csv, ReadsBackWhatItWrote) {
  const std::vector<CsvRow> rows = {
      {"x", "", "\"", ",", "\r\n"}, {"", "", "", "", ""}, {"é–ü", " padded ", "=1+1", "'", "\""}};
  EXPECT_EQ(parse_csv(format_csv(rows), "test"), rows);
}

TEST(Csv, AcceptsBareLineFeedsAndALastLineWithoutEnd) {
  EXPECT_THAT(parse_csv("a,b\n1,2", "test"), ElementsAre(CsvRow{"a", "b"}, CsvRow{"1", "2"}));
}

TEST(Csv, SaysWhereAFileIsMalformed) {
  EXPECT_THAT([] { (void)parse_csv("a\n\"open", "f.csv"); },
              ThrowsMessage<Error>(HasSubstr("f.csv:2: has an unclosed quote")));
  EXPECT_THAT([] { (void)parse_csv("\"a\"b\n", "f.csv"); },
              ThrowsMessage<Error>(HasSubstr("f.csv:1: has text after a closing quote")));
}

TEST(Csv, NumbersKeepEveryDigit) {
  EXPECT_EQ(std::stod(csv_number(0.1 + 0.2)), 0.1 + 0.2);
  EXPECT_EQ(csv_number(2.5), "2.5");
  EXPECT_EQ(csv_number(std::nullopt), "");
}

}  // namespace
}  // namespace foveola
