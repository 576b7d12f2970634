#include "analysis/publication/figure_drawing.h"

#include <memory>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <qpdf/qpdf-c.h>

#include "analysis/dataset/wording.h"
#include "renderer/base/error.h"
#include "renderer/base/work/programs.h"

// By its interface in C: the headers of that in C++ do not compile with Clang in C++20.
namespace foveola::analysis {
namespace {

struct Cleanup {
  void operator()(qpdf_data document) const { qpdf_cleanup(&document); }
};
using Document = std::unique_ptr<_qpdf_data, Cleanup>;

// Throws Error for what went wrong since it was asked last.
void check(const Document& document) {
  if (qpdf_has_error(document.get()) == QPDF_TRUE) {
    const char* why = qpdf_get_error_full_text(document.get(), qpdf_get_error(document.get()));
    throw Error("gnuplot", std::string("gave no PDF: ") + why,
                "check that gnuplot 5.4 or newer is installed");
  }
}

Document read(const std::string& pdf) {
  Document document(qpdf_init());
  qpdf_silence_errors(document.get());
  qpdf_set_suppress_warnings(document.get(), QPDF_TRUE);
  qpdf_read_memory(document.get(), "PDF", pdf.data(), pdf.size(), nullptr);
  check(document);
  return document;
}

void forget_date(const Document& document) {
  const qpdf_oh trailer = qpdf_get_trailer(document.get());
  qpdf_oh_remove_key(document.get(), trailer, "/ID");  // which may follow from the date
  const qpdf_oh information = qpdf_oh_get_key(document.get(), trailer, "/Info");
  if (qpdf_oh_is_dictionary(document.get(), information) == QPDF_TRUE) {
    qpdf_oh_remove_key(document.get(), information, "/CreationDate");
  }
  check(document);
}

std::string written(const Document& document) {
  qpdf_init_write_memory(document.get());
  qpdf_set_deterministic_ID(document.get(), QPDF_TRUE);
  qpdf_write(document.get());
  check(document);
  const unsigned char* bytes = qpdf_get_buffer(document.get());
  return {bytes, bytes + qpdf_get_buffer_length(document.get())};
}

ProgramEnd end_of_gnuplot(const std::string& script) {
  const std::string without_user_settings = "-d";
  try {
    // By its name, gnuplot reads it in large pieces; what it takes as its input, byte by byte.
    return run_to_end({.words = {"gnuplot", without_user_settings, "/dev/stdin"}, .input = script});
  } catch (const std::system_error&) {
    throw Error("gnuplot", "cannot be started, and it draws the figures",
                "install it: apt-get install gnuplot-nox");
  }
}

constexpr double interval_width = 2.5;

int filled_point(std::size_t method) { return hollow_point(method) + 1; }

/// Writes whose data a figure shows into its corner, so that the file says so wherever it goes.
std::string data_mark(const StudyTables& tables) {
  const std::string notice = data_notice(tables);
  return notice.empty() ? ""
                        : fmt::format(
                              "set label {} at screen 0.012, screen 1 offset 0,-0.7 left "
                              "front textcolor rgb '{}'\n",
                              gnuplot_quoted(notice), palette::ink.rgb);
}

std::string svg_terminal(int width, int height) {
  return fmt::format(
      "set terminal svg size {},{} dynamic noenhanced font 'sans-serif,14' background 'white'\n",
      width, height);
}

std::string png_terminal(int width, int height) {
  return fmt::format(
      "set terminal pngcairo size {},{} noenhanced font 'sans-serif,10.5' fontscale 2 "
      "linewidth 2 pointscale 2 background rgb 'white'\n",
      2 * width, 2 * height);
}

std::string pdf_terminal(int width, int height) {
  constexpr double units_per_inch = 96.0;
  return fmt::format(
      "set terminal pdfcairo size {:.4f}in,{:.4f}in noenhanced font 'sans-serif,10.5' "
      "fontscale 1 linewidth 1 pointscale 1.2 background rgb 'white'\n",
      width / units_per_inch, height / units_per_inch);
}

/// `drawn` is an SVG, a PNG and a PDF, one after the other: most of what gnuplot takes is its
/// start, so that it starts once for all three. In an SVG's texts, "<" is escaped.
Figure split(const std::string& name, const std::string& script, const std::string& drawn) {
  constexpr std::string_view svg_end = "</svg>";
  constexpr std::string_view png_begin = "\x89PNG";
  constexpr std::string_view png_end = "IEND\xae\x42\x60\x82";  // The last chunk and its checksum.
  const std::size_t png = drawn.find(png_begin, drawn.find(svg_end));
  const std::size_t pdf = drawn.find(png_end, png) + png_end.size();
  return {name, drawn.substr(0, png), drawn.substr(png, pdf - png), dateless_pdf(drawn.substr(pdf)),
          script};
}

}  // namespace

std::string figure_preamble(const StudyTables& tables) {
  return fmt::format(
             "set encoding utf8\n"
             "set border 1 linecolor rgb '{}'\n"
             "set tics out nomirror textcolor rgb '{}'\n"
             "set xlabel textcolor rgb '{}'\n"
             "set key textcolor rgb '{}'\n"
             "set ytics scale 0\n",
             palette::ink.rgb, palette::ink.rgb, palette::ink.rgb, palette::ink.rgb) +
         data_mark(tables);
}

std::string row_names(const std::vector<std::string>& methods) {
  std::string tics;
  for (std::size_t row = 0; row < methods.size(); ++row) {
    tics += fmt::format("{}{} {}", row > 0 ? ", " : "",
                        gnuplot_tick_label(method_label(methods[row])), row);
  }
  return fmt::format("set ytics ({})\nset yrange [{}:-0.6]\n", tics,
                     static_cast<double>(methods.size()) - 0.4);
}

std::vector<std::string> ids_of(const StudyTables& tables, const std::vector<std::size_t>& marks) {
  std::vector<std::string> ids;
  for (const std::size_t mark : marks) {
    ids.push_back(tables.set.measures[mark].id());
  }
  return ids;
}

// Discs, squares, triangles and so on.
int hollow_point(std::size_t method) {
  constexpr std::array types = {6, 4, 8, 10, 12, 14};
  return types[method % types.size()];
}

const FigureColor& method_color(std::size_t method) {
  return palette::methods[method % palette::methods.size()];
}

std::string estimate_line(const Estimate& estimate, double y) {
  const Interval interval = estimate.interval.value_or(Interval{estimate.value, estimate.value});
  return fmt::format("{} {} {} {}\n", estimate.value, interval.low, interval.high, y);
}

std::string estimates_layer(const std::string& block, std::size_t method) {
  return fmt::format(
      "{} using 1:4:2:3 with xerrorbars pointtype {} pointsize 1 linewidth {} linecolor rgb '{}' "
      "notitle",
      block, filled_point(method), interval_width, method_color(method).rgb);
}

std::string hollow_estimates_layer(const std::string& block, std::size_t method) {
  const std::string inside =
      fmt::format("{} using 1:4 with points pointtype {} pointsize 0.8 linecolor rgb '{}' notitle",
                  block, filled_point(method), palette::paper.rgb);
  const std::string edge = fmt::format(
      "{} using 1:4 with points pointtype {} pointsize 1 linewidth 1.5 linecolor rgb '{}' notitle",
      block, hollow_point(method), method_color(method).rgb);
  return fmt::format("{}, \\\n{}, \\\n{}", estimates_layer(block, method), inside, edge);
}

std::string method_key(const StudyTables& tables, std::size_t method) {
  return fmt::format(
      "keyentry with linespoints pointtype {} pointsize 1 linewidth {} linecolor rgb '{}' title {}",
      filled_point(method), interval_width, method_color(method).rgb,
      gnuplot_quoted(method_label(tables.set.methods[method])));
}

Figure drawn_figure(const std::string& name, int width, int height, const std::string& script) {
  return split(
      name, script,
      run_gnuplot(fmt::format("{0}{3}reset\n{1}{3}reset\n{2}{3}", svg_terminal(width, height),
                              png_terminal(width, height), pdf_terminal(width, height), script)));
}

std::string run_gnuplot(const std::string& script) {
  const ProgramEnd end = end_of_gnuplot(script);
  if (end.status != 0) {
    throw Error("gnuplot", "stopped with an error: " + end.errors,
                "check that gnuplot 5.4 or newer is installed");
  }
  return end.output;
}

bool has_font() {
  try {
    // Of fontconfig, which gnuplot asks for fonts through Pango.
    return !run_to_end({.words = {"fc-match", "--format=%{file}", "sans-serif"}}).output.empty();
  } catch (const std::system_error&) {
    return true;  // Nobody knows.
  }
}

std::string gnuplot_quoted(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'') {
      quoted += "''";
    } else {
      quoted += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
    }
  }
  return quoted + "'";
}

std::string gnuplot_tick_label(std::string_view text) {
  std::string format;
  for (const char c : text) {
    format += c == '%' ? "%%" : std::string(1, c);
  }
  return gnuplot_quoted(format);
}

std::string dateless_pdf(const std::string& pdf) {
  const Document document = read(pdf);
  forget_date(document);
  return written(document);
}

std::string horizontal_rule(double y, const FigureColor& color) {
  return fmt::format(
      "set arrow from graph 0, first {0} to graph 1, first {0} nohead linewidth 1 linecolor rgb "
      "'{1}'\n",
      y, color.rgb);
}

std::string row_axis(const GroupedRows& rows) {
  std::vector<std::string> names;
  std::string headings;
  for (std::size_t group = 0; group < rows.headings.size(); ++group) {
    const double top = rows.group_height() * static_cast<double>(group);
    headings += fmt::format(
        "set label {} at graph 0, first {} offset 0.4,0 left front textcolor rgb '{}'\n",
        gnuplot_quoted(rows.headings[group]), top + 0.5 * rows.heading_height, palette::ink.rgb);
    if (group > 0) {
      headings += horizontal_rule(top, palette::ink);
    }
    for (std::size_t row = 0; row < rows.rows.size(); ++row) {
      names.push_back(fmt::format("{} {}", gnuplot_tick_label(rows.rows[row]), rows.y(group, row)));
    }
  }
  return fmt::format("set ytics ({})\nset yrange [{}:0]\n", fmt::join(names, ", "), rows.height()) +
         headings;
}

}  // namespace foveola::analysis
