#include "analysis/tables/printed_table.h"

#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

PrintedTable hall_times() {
  PrintedTable table;
  table.id = "times";
  table.title = "Times <s>.";
  table.note = "Means & deviations.";
  table.groups = {{"", 1}, {"both", 2}};
  table.columns = {"scene", "od", "fv"};
  table.rows = {{"<hall>", "1.5 ± 0.5", "–"}};
  return table;
}

TEST(PrintedTableHtml, NamesItsRowsAndColumns) {
  const std::string html = html_of(hall_times(), "");
  EXPECT_THAT(html, HasSubstr("<caption><strong>Times &lt;s&gt;.</strong> Means &amp; deviations."
                              "</caption>"));
  EXPECT_THAT(html, HasSubstr("<th scope=\"colgroup\" colspan=\"2\">both</th>"));
  EXPECT_THAT(html, HasSubstr("<th scope=\"col\">fv</th>"));
  EXPECT_THAT(html, HasSubstr("<th scope=\"row\">&lt;hall&gt;</th><td>1.5 ± 0.5</td><td>–</td>"));
}

TEST(PrintedTableHtml, IsNothingWithoutRows) {
  PrintedTable table = hall_times();
  table.rows.clear();
  EXPECT_THAT(html_of(table, ""), IsEmpty());
}

TEST(PrintedTableLatex, IsATableOfThePackageBooktabs) {
  const std::string latex = latex_of(hall_times(), "");
  EXPECT_TRUE(
      latex.starts_with("% Needs \\usepackage{array,booktabs,graphicx}.\n\\begin{table}\n"));
  EXPECT_THAT(latex, HasSubstr("\\caption{Times \\textless{}s\\textgreater{}. Means \\& "
                               "deviations.}\n\\label{tab:times}\n"));
  EXPECT_THAT(latex, HasSubstr("\\begin{tabular}{lrr}\n"));
  EXPECT_THAT(latex, HasSubstr("\\multicolumn{1}{c}{} & \\multicolumn{2}{c}{both} \\\\\n"));
  EXPECT_THAT(latex, HasSubstr("\\textless{}hall\\textgreater{} & 1.5 $\\pm$ 0.5 & -- \\\\\n"));
}

TEST(PrintedTableLatex, LongTextsAreBrokenIntoLinesWhereTheyCanBe) {
  PrintedTable table = hall_times();
  table.rows[0][2] = "signed ranks (the other model needs R)";
  EXPECT_THAT(latex_of(table, ""),
              HasSubstr("\\begin{tabular}{lr>{\\raggedright\\arraybackslash}p{14em}}\n"));
  table.rows[0][2] = "ANameOfManyLettersWithoutAnyPlaceToBreakIt";
  EXPECT_THAT(latex_of(table, ""), HasSubstr("\\begin{tabular}{lrr}\n"));
}

TEST(PrintedTableLatex, ARowsNameIsNoArgumentOfTheRowBefore) {
  PrintedTable table = hall_times();
  for (const char* name : {"[2ex]", "*"}) {
    table.rows[0][0] = name;
    EXPECT_THAT(latex_of(table, ""), HasSubstr(std::string("\n{}") + name + " & "));
  }
}

TEST(PrintedTableText, HasATitleAlignedRowsAndANote) {
  PrintedTable table = hall_times();
  table.rows.push_back({"aula", "10.0", "2.0"});
  const std::string text = plain_text_of(table, "Pilot data");
  EXPECT_TRUE(text.starts_with("Times <s> (Pilot data)\n")) << text;
  EXPECT_THAT(text, HasSubstr("  scene "));
  EXPECT_THAT(text, HasSubstr("  Means & deviations.\n"));
  EXPECT_THAT(text, Not(HasSubstr(" \n")));
}

TEST(PrintedTableText, CannotSteerTheTerminal) {
  PrintedTable table = hall_times();
  table.title = "a\x1b[31m.";
  table.note = "1 (a\x1b[31m) to 5 (b\nc).";
  table.rows[0][0] = "au\x1b[31mla\x7f";
  const std::string text = plain_text_of(table, "");
  EXPECT_THAT(text, Not(HasSubstr("\x1b")));
  EXPECT_THAT(text, AllOf(HasSubstr("1 (a?[31m) to 5 (b c)."), HasSubstr("au?[31mla?")));
}

}  // namespace
}  // namespace foveola::analysis
