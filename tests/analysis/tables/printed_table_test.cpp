#include "analysis/tables/printed_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace foveola::analysis {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

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

TEST(PrintedTableHtml, ATableOfTextIsNotAlignedAsNumbers) {
  PrintedTable table = hall_times();
  EXPECT_THAT(html_of(table, ""), HasSubstr("class=\"numeric\""));
  table.is_numeric = false;
  EXPECT_THAT(html_of(table, ""), Not(HasSubstr("class=\"numeric\"")));
}

TEST(PrintedTableHtml, SaysWhoseDataItShows) {
  EXPECT_THAT(html_of(hall_times(), "Simulated data"),
              HasSubstr("<caption><span class=\"tag\">Simulated data</span><strong>"));
}

TEST(PrintedTableHtml, IsNothingWithoutRows) {
  PrintedTable table = hall_times();
  table.rows.clear();
  EXPECT_THAT(html_of(table, ""), IsEmpty());
}

TEST(PrintedTableLatex, IsATableOfThePackageBooktabs) {
  const std::string latex = latex_of(hall_times(), "");
  EXPECT_THAT(latex, HasSubstr("\\usepackage{booktabs}"));
  EXPECT_THAT(latex, HasSubstr("\\caption{Times \\textless{}s\\textgreater{}. Means \\& "
                               "deviations.}\n\\label{tab:times}\n\\begin{tabular}{lrr}\n"));
  EXPECT_THAT(latex, HasSubstr("\\multicolumn{1}{c}{} & \\multicolumn{2}{c}{both} \\\\\n"));
  EXPECT_THAT(latex, HasSubstr("\\textless{}hall\\textgreater{} & 1.5 $\\pm$ 0.5 & -- \\\\\n"));
}

TEST(PrintedTableLatex, SaysWhoseDataItShows) {
  EXPECT_THAT(latex_of(hall_times(), "Simulated data"),
              HasSubstr("\\caption{\\textbf{Simulated data.} Times"));
  EXPECT_THAT(latex_of(hall_times(), ""), Not(HasSubstr("textbf")));
}

TEST(LatexText, NamesCannotBecomeCommands) {
  EXPECT_EQ(latex_text("a_b & 50 % of #1 {x} $y$ ~^\\input"),
            "a\\_b \\& 50 \\% of \\#1 \\{x\\} \\$y\\$ \\~{}\\^{}\\textbackslash{}input");
  EXPECT_EQ(latex_text("keine & 0 % <b>"), "keine \\& 0 \\% \\textless{}b\\textgreater{}");
  EXPECT_EQ(latex_text("über_all \"日本\""), "über\\_all ''日本''");
  EXPECT_EQ(latex_text("a\nb|c"), "a b\\textbar{}c");
}

TEST(LatexText, SymbolsOfStatisticsAreTypeset) {
  EXPECT_EQ(latex_text("1 ± 2, –"), "1 $\\pm$ 2, --");
  EXPECT_EQ(latex_text("η² χ² ρ ε 3 × 4 − 1°"),
            "$\\eta$$^2$ $\\chi$$^2$ $\\rho$ $\\epsilon$ 3 $\\times$ 4 $-$ 1$^\\circ$");
}

TEST(LatexText, SmallNumbersAreWrittenAsPowersOfTen) {
  EXPECT_EQ(latex_text("3.3e-05"), "$3.3 \\times 10^{-5}$");
  EXPECT_EQ(latex_text("< 1e-300"), "$< 10^{-300}$");
  EXPECT_EQ(latex_text("0.031"), "0.031");
  EXPECT_EQ(latex_text("e-5"), "e-5");
  EXPECT_EQ(latex_text("scene 1e"), "scene 1e");
  for (const char* name : {"1e-", "1e+e", "1ee", "1e99999999999", "-e-5", "<e5", "1 e5"}) {
    EXPECT_EQ(latex_text(name).find("times"), std::string::npos) << name;
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
  table.rows[0][0] = "au\x1b[31mla\x7f";
  EXPECT_THAT(plain_text_of(table, ""), HasSubstr("au?[31mla?"));
}

TEST(PrintedTableText, NeitherTitleNorNoteCanSteerTheTerminal) {
  PrintedTable table = hall_times();
  table.title = "a\x1b[31m.";
  table.note = "1 (a\x1b[31m) to 5 (b\nc).";
  const std::string text = plain_text_of(table, "");
  EXPECT_THAT(text, Not(HasSubstr("\x1b")));
  EXPECT_THAT(text, HasSubstr("1 (a?[31m) to 5 (b c)."));
}

}  // namespace
}  // namespace foveola::analysis
