#include "analysis/tables/table_formats.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/tables/table.h"
#include "renderer/base/error.h"
#include "renderer/base/text/csv.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

using enum ColumnType;

/// A row with a field of every kind, one with hostile texts, and one without values.
Table every_kind() {
  return {"kinds",
          "kind of field",
          {{"name", text, "", "A text"},
           {"count", whole, "", "A whole number"},
           {"mean_s", number, "s", "A number"},
           {"is_true", truth, "", "Whether it is so"}},
          {{"plain", std::int64_t{-3}, 0.1, true},
           {"a \"b\",\tc\nd", std::int64_t{9007199254740993}, 1e-300, false},
           {{}, {}, {}, {}}}};
}

TEST(TableFormats, ANameOfTwoColumnsIsRefusedInEveryFormat) {
  Table table = every_kind();
  table.columns[1].name = "mean_s";
  const auto refused = ThrowsMessage<Error>(HasSubstr("column 'mean_s': two columns"));
  EXPECT_THAT([&] { (void)csv_of(table); }, refused);
  EXPECT_THAT([&] { (void)tsv_heading(table.columns); }, refused);
  EXPECT_THAT([&] { (void)json_of(table); }, refused);
}

TEST(TableFormats, CsvReadsBackAsItWasWritten) {
  const std::string csv = csv_of(every_kind());
  EXPECT_TRUE(csv.starts_with("name,count,mean_s,is_true\r\nplain,-3,0.1,TRUE\r\n")) << csv;
  const std::vector<CsvRow> rows = parse_csv(csv, "kinds");
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_THAT(rows[2], ElementsAre("a \"b\",\tc\nd", "9007199254740993", "1e-300", "FALSE"));
  EXPECT_THAT(rows[3], ElementsAre("", "", "", ""));
}

TEST(TableFormats, NumbersAreTheShortestThatReadBackAsTheSameValue) {
  for (const double value : {0.1, 1.0 / 3.0, 1e300, 1e-300, -2.5, 38.0}) {
    EXPECT_EQ(std::stod(text_of(field(value))), value);
  }
  EXPECT_EQ(text_of(field(2.0)), "2");
  EXPECT_EQ(text_of(field(0.5)), "0.5");
  EXPECT_EQ(text_of(Field()), "");
  EXPECT_EQ(text_of(field(std::optional<double>())), "");
}

TEST(TableFormats, TsvHasNoQuotesAndSaysWhatIsNotAvailable) {
  const Table table = every_kind();
  std::string tsv = tsv_heading(table.columns);
  for (const Row& row : table.rows) {
    tsv += tsv_row(row);
  }
  EXPECT_EQ(tsv,
            "name\tcount\tmean_s\tis_true\nplain\t-3\t0.1\ttrue\n"
            "a \"b\", c d\t9007199254740993\t1e-300\tfalse\nn/a\tn/a\tn/a\tn/a\n");
}

TEST(TableFormats, JsonHasTheTypesOfTheFields) {
  const nlohmann::ordered_json rows = json_of(every_kind());
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].dump(), "{\"name\":\"plain\",\"count\":-3,\"mean_s\":0.1,\"is_true\":true}");
  EXPECT_EQ(rows[1]["count"], 9007199254740993);
  EXPECT_EQ(rows[1]["name"], "a \"b\",\tc\nd");
  for (const char* column : {"name", "count", "mean_s", "is_true"}) {
    EXPECT_TRUE(rows[2][column].is_null()) << column;
  }
}

TEST(TableFormats, HeadingsAndRowsAloneAreThoseOfTheWhole) {
  const Table table = every_kind();
  std::string csv = csv_heading(table.columns);
  for (const Row& row : table.rows) {
    csv += csv_row(row);
  }
  EXPECT_EQ(csv, csv_of(table));
}

// What begins a formula is OWASP's list (https://owasp.org/www-community/attacks/CSV_Injection).
TEST(TableFormats, ForPeopleNoTextIsAFormulaAndNumbersAreWhatTheyAre) {
  Table table{"typed", "text", {{"typed", text, "", ""}, {"value", number, "", ""}}, {}};
  const std::vector<std::pair<std::string, std::string>> typed = {
      {"=1+1", "'=1+1"}, {"+49 30", "'+49 30"},
      {"-5", "'-5"},     {"@SUM(A1)", "'@SUM(A1)"},
      {"\t=1", "'\t=1"}, {"\r=1", "'\r=1"},
      {"\n=1", "'\n=1"}, {"＝1", "'＝1"},
      {"＋1", "'＋1"},   {"－1", "'－1"},
      {"＠1", "'＠1"},   {"'tis", "''tis"},
      {"'=1", "''=1"},   {"", ""},
      {"a=1", "a=1"},    {"−1", "−1"}};
  for (const auto& [was, is] : typed) {
    table.rows.push_back({was, -5.5});
  }
  const std::vector<CsvRow> for_people = parse_csv(csv_of(table), "typed");
  table.texts = CsvTexts::as_typed;
  const std::vector<CsvRow> for_programs = parse_csv(csv_of(table), "typed");
  for (std::size_t i = 0; i < typed.size(); ++i) {
    EXPECT_THAT(for_people.at(i + 1), ElementsAre(typed[i].second, "-5.5"));
    EXPECT_THAT(for_programs.at(i + 1), ElementsAre(typed[i].first, "-5.5"));
  }
}

TEST(TableFormats, TheCodebookHasARowForEachColumn) {
  Table second = every_kind();
  second.texts = CsvTexts::as_typed;
  const Table codebook = codebook_of({every_kind(), second});
  ASSERT_EQ(codebook.rows.size(), 8U);
  const std::vector<CsvRow> rows = parse_csv(csv_of(codebook), "codebook");
  EXPECT_THAT(rows[0], ElementsAre("file", "variable", "type", "unit", "description", "guarded"));
  EXPECT_THAT(rows[2], ElementsAre("kinds", "count", "integer", "", "A whole number", "TRUE"));
  EXPECT_THAT(rows[3], ElementsAre("kinds", "mean_s", "number", "s", "A number", "TRUE"));
  EXPECT_THAT(rows[8], ElementsAre("kinds", "is_true", "boolean", "", "Whether it is so", "FALSE"));
}

TEST(TableFormats, MarkdownListsTheColumnsOfEachFile) {
  const std::string markdown = columns_in_markdown({every_kind()});
  EXPECT_THAT(markdown, HasSubstr("### kinds.csv\n\nA row for each kind of field.\n\n"
                                  "- `name` (string): A text.\n"));
  EXPECT_THAT(markdown, HasSubstr("- `mean_s` (number, s): A number.\n"));
}

TEST(Table, ItemsBecomeRowsInTheirOrder) {
  const ColumnsOf<int> columns = {
      {{"value", whole, "", "It"}, [](const int& item) { return field(item); }},
      {{"half", number, "", "Half of it"}, [](const int& item) { return field(item / 2.0); }}};
  const Table table = tabulate<int>("numbers", "number", columns, {3, 1});
  EXPECT_EQ(csv_of(table), "value,half\r\n3,1.5\r\n1,0.5\r\n");
  EXPECT_EQ(table.columns.at(1).description, "Half of it");
}

// By BIDS 1.11.1 (common principles), n/a is a missing value.
TEST(TableFormats, AnAnswerThatReadsLikeAMissingOneSurvivesBids) {
  EXPECT_EQ(tsv_row({std::string("n/a"), std::string("'n/a"), std::string("NA"), Field(),
                     std::string("it's n/a")}),
            "'n/a\t''n/a\tNA\tn/a\tit's n/a\n");
}

}  // namespace
}  // namespace foveola::analysis
