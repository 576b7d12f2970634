#include "analysis/tables/row_text.h"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

Table tested_methods() {
  return {
      "tests",
      "method",
      {{"method", ColumnType::text, "", ""},
       {"n", ColumnType::whole, "", ""},
       {"ratio", ColumnType::number, "", ""},
       {"p", ColumnType::number, "", ""},
       {"exact", ColumnType::truth, "", ""}},
      {{"fv", std::int64_t{8}, 0.25, 0.0312, true}, {"vp", std::int64_t{2}, -0.001, {}, false}}};
}

std::string filled(std::string_view pattern, std::size_t row = 0) {
  const Table table = tested_methods();
  return fill(pattern, table, table.rows.at(row)).value_or("nothing");
}

TEST(RowText, NumbersHaveTheirFormats) {
  EXPECT_EQ(filled("{method} of {n}: {ratio}."), "fv of 8: 0.25.");
  EXPECT_EQ(filled("{ratio:.1} {ratio:+.2} {n:.1} {ratio:g} {p:p}"), "0.2 +0.25 8.0 0.25 0.031");
  EXPECT_EQ(filled("{ratio:100*.1} {ratio:1/.2}"), "25.0 4.00");
  EXPECT_EQ(filled("{ratio:100*exp.1}"), fmt::format("{:.1f}", 100.0 * std::exp(0.25)));
  EXPECT_EQ(filled("{ratio:.2} {ratio:+.2}", 1), "0.00 0.00");
}

TEST(RowText, TruthValuesChooseAWord) {
  EXPECT_EQ(filled("{exact:yes/no}{exact:/ (about)}"), "yes");
  EXPECT_EQ(filled("{exact:yes/no}{exact:/ (about)}", 1), "no (about)");
}

TEST(RowText, WhatLacksAValueIsLeftOut) {
  EXPECT_EQ(filled("P {p:p}", 1), "nothing");
  EXPECT_EQ(filled("{n}| of P {p:p}|, {method}", 1), "2, vp");
  EXPECT_EQ(filled("{method=fv}first"), "first");
  EXPECT_EQ(filled("{method=fv}first", 1), "nothing");
  EXPECT_EQ(filled(""), "");
}

TEST(RowText, AnUnknownColumnIsAMistake) { EXPECT_THROW((void)filled("{r}"), std::out_of_range); }

TEST(RowText, RowsAreSelectedAndPrintedByTheFirstPatternThatHolds) {
  const PrintedTable all = print_rows(
      {.id = "all"}, tested_methods(), "",
      {{"method", "{method}"}, {"P", "{p:p}", "{exact=FALSE}none"}, {"P alone", "{p:p}"}});
  EXPECT_EQ(all.id, "all");
  EXPECT_THAT(all.columns, ElementsAre("method", "P", "P alone"));
  EXPECT_THAT(all.rows,
              ElementsAre(ElementsAre("fv", "0.031", "0.031"), ElementsAre("vp", "none", "–")));
  EXPECT_THAT(print_rows({}, tested_methods(), "{p}", {{"n", "{n}"}}).rows,
              ElementsAre(ElementsAre("8")));
}

}  // namespace
}  // namespace foveola::analysis
