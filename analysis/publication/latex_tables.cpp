#include "analysis/publication/latex_tables.h"

#include <fmt/format.h>

#include "analysis/publication/wording.h"

namespace foveola::analysis {
namespace {

/// A table whose cells are LaTeX already.
struct LatexTable {
  std::string label;
  std::string caption;
  std::vector<std::string> columns;  ///< The first is aligned left, the others right.
  std::vector<std::vector<std::string>> rows;
};

std::string latex_row(const std::vector<std::string>& cells) {
  return fmt::format("{} \\\\\n", fmt::join(cells, " & "));
}

std::string render_latex(const StudyTables& tables, const LatexTable& table) {
  const std::string notice = data_notice(tables);
  std::string text = fmt::format(
      "% Needs \\usepackage{{booktabs}}.\n\\begin{{table}}\n\\centering\n\\caption{{{}{}}}\n"
      "\\label{{tab:{}}}\n\\begin{{tabular}}{{l{}}}\n\\toprule\n{}\\midrule\n",
      notice.empty() ? "" : "\\textbf{" + escape_latex(notice) + ".} ", table.caption, table.label,
      std::string(table.columns.size() - 1, 'r'), latex_row(table.columns));
  for (const std::vector<std::string>& row : table.rows) {
    text += latex_row(row);
  }
  return text + "\\bottomrule\n\\end{tabular}\n\\end{table}\n";
}

std::string latex_interval(const std::optional<Estimate>& estimate, int decimals) {
  return escape_latex(with_interval(estimate, decimals));
}

std::string latex_method(const std::string& method) { return escape_latex(method_label(method)); }

LatexTable times_latex(const StudyTables& tables) {
  const std::string reference = latex_method(tables.set.methods.front());
  LatexTable table{
      "times",
      fmt::format("Times until the marks: {} in seconds, other methods in per cent of each "
                  "participant's own {} time; mean $\\pm$ standard deviation.",
                  reference, reference),
      {"Mark", "Scene"},
      {}};
  for (std::size_t method = 0; method < tables.set.methods.size(); ++method) {
    table.columns.push_back(latex_method(tables.set.methods[method]) +
                            (method == baseline ? ", s" : ", \\%"));
  }
  for (const Mark mark : marks) {
    for (std::size_t scene = 0; scene < tables.set.scenes.size(); ++scene) {
      std::vector<std::string> row = {std::string(name_of(mark)),
                                      escape_latex(tables.set.scenes[scene])};
      for (std::size_t method = 0; method < tables.set.methods.size(); ++method) {
        const SceneTimes& times = tables.scene_times_of(mark, scene, method);
        row.push_back(escape_latex(method == baseline
                                       ? mean_and_deviation(times.seconds, 2)
                                       : mean_and_deviation(times.percent_of_baseline, 1)));
      }
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

LatexTable means_latex(const StudyTables& tables) {
  LatexTable table{
      "geometric-means",
      "Geometric means over scenes with 95\\,\\% intervals over participants.",
      {"Method", "mark", "$n$", "seconds", "\\% of " + latex_method(tables.set.methods.front())},
      {}};
  for (const MethodTimes& row : tables.method_times) {
    table.rows.push_back({latex_method(row.method), std::string(name_of(row.mark)),
                          std::to_string(row.participant_seconds.size()),
                          latex_interval(row.seconds, 2),
                          latex_interval(row.percent_of_baseline, 1)});
  }
  return table;
}

LatexTable ratings_latex(const StudyTables& tables) {
  LatexTable table{"artifacts",
                   escape_latex(fmt::format("Artifacts in other areas: how many answers were {}.{}",
                                            points_in_brackets(tables.set.rating_scale),
                                            notes_on(tables.set.rating_scale))),
                   {"Method", "1", "2", "3", "4", "5", "mean $\\pm$ sd", "median"},
                   {}};
  for (const MethodRatings& ratings : tables.ratings) {
    std::vector<std::string> row = {latex_method(ratings.method)};
    for (const int count : ratings.counts) {
      row.push_back(std::to_string(count));
    }
    row.push_back(escape_latex(mean_and_deviation(ratings.rating, 2)));
    row.push_back(escape_latex(fixed(ratings.rating.median, 1)));
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// Typesets powers of ten: 3.3e-05 becomes $3.3 \times 10^{-5}$, and < 1e-300 $< 10^{-300}$.
std::string latex_p(const std::optional<double>& p) {
  if (!p) {
    return "--";
  }
  const std::string text = p_value(*p);
  const std::size_t e = text.find('e');
  if (e == std::string::npos) {
    return text;
  }
  const std::string power = fmt::format("10^{{{}}}", std::stoi(text.substr(e + 1)));
  const std::string factor = text.substr(0, e);
  return factor == "< 1" ? fmt::format("$< {}$", power)
                         : fmt::format("${} \\times {}$", factor, power);
}

LatexTable comparisons_latex(const Comparisons& comparisons) {
  LatexTable table{"comparisons",
                   "Ratios of times (geometric means over participants, 95\\,\\% interval), paired "
                   "$t$ tests on logarithms, Holm's adjusted $P$, effect size $d_z$ and Wilcoxon's "
                   "signed-rank $P$. Planned comparisons are marked with *.",
                   {"Methods", "measure", "$n$", "ratio, \\%", "$t$", "$P$", "$P$ (Holm)", "$d_z$",
                    "$P$ (Wilcoxon)"},
                   {}};
  for (const MethodComparison& row : comparisons.methods) {
    std::vector<std::string> cells = {
        fmt::format("{} / {}{}", latex_method(row.method), latex_method(row.reference),
                    row.primary ? "*" : ""),
        row.measure, std::to_string(row.n)};
    if (row.ratio) {
      const TTest& logs = row.ratio->logs;
      cells.push_back(fmt::format("{:.1f} [{:.1f}, {:.1f}]", 100.0 * row.ratio->ratio,
                                  100.0 * row.ratio->interval.low,
                                  100.0 * row.ratio->interval.high));
      cells.push_back(fmt::format("{:.2f}", logs.t));
      cells.push_back(latex_p(logs.p));
      cells.push_back(latex_p(row.p_holm));
      cells.push_back(fmt::format("{:.2f}", logs.d_z));
    } else {
      cells.insert(cells.end(), {"--", "--", "--", latex_p(row.p_holm), "--"});
    }
    cells.push_back(latex_p(row.ranks ? std::optional(row.ranks->p) : std::nullopt));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

}  // namespace

std::string escape_latex(std::string_view text) {
  std::string escaped;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (text.substr(i, 2) == "±") {
      escaped += "$\\pm$";
      ++i;
    } else if (text.substr(i, 3) == "–") {
      escaped += "--";
      i += 2;
    } else if (std::string_view("&%$#_{}").find(c) != std::string_view::npos) {
      escaped += '\\';
      escaped += c;
    } else if (c == '\\') {
      escaped += "\\textbackslash{}";
    } else if (c == '<' || c == '>' || c == '|') {
      escaped += c == '<' ? "\\textless{}" : c == '>' ? "\\textgreater{}" : "\\textbar{}";
    } else if (c == '"') {
      escaped += "''";  // a command of its own in several languages' packages
    } else if (c == '~' || c == '^') {
      escaped += fmt::format("\\{}{{}}", c);
    } else {
      escaped += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return escaped;
}

std::vector<TextFile> latex_tables(const StudyTables& tables, const Comparisons& comparisons) {
  std::vector<TextFile> files = {
      {"table2_times.tex", render_latex(tables, times_latex(tables))},
      {"figure5_geometric_means.tex", render_latex(tables, means_latex(tables))},
      {"figure6_artifact_ratings.tex", render_latex(tables, ratings_latex(tables))}};
  if (!comparisons.methods.empty()) {
    files.push_back({"comparisons.tex", render_latex(tables, comparisons_latex(comparisons))});
  }
  return files;
}

}  // namespace foveola::analysis
