#include "analysis/gnuplot/gnuplot.h"

#include <memory>
#include <system_error>

#include <fmt/format.h>
#include <qpdf/qpdf-c.h>

#include "renderer/base/error.h"
#include "renderer/base/work/programs.h"

// By its C interface: its C++ headers do not compile with Clang in C++20.
namespace foveola::analysis {
namespace {

struct Cleanup {
  void operator()(qpdf_data document) const { qpdf_cleanup(&document); }
};
using Document = std::unique_ptr<_qpdf_data, Cleanup>;

// Throws Error for faults since the last call.
void check(const Document& document) {
  if (qpdf_has_error(document.get()) == QPDF_TRUE) {
    const char* why = qpdf_get_error_full_text(document.get(), qpdf_get_error(document.get()));
    throw Error("gnuplot", std::string("wrote no valid PDF: ") + why,
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
  qpdf_oh_remove_key(document.get(), trailer, "/ID");  // which may depend on the date
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
    // By this name, gnuplot reads it in large pieces; standard input is read byte by byte.
    return run_to_end({.words = {"gnuplot", without_user_settings, "/dev/stdin"}, .input = script});
  } catch (const std::system_error& failure) {
    throw Error("gnuplot", "cannot be started to draw figures: " + failure.code().message(),
                "install it: apt-get install gnuplot-nox");
  }
}

std::string svg_terminal(int width, int height) {
  return fmt::format(
      "set terminal svg size {},{} dynamic noenhanced font 'sans-serif,14' background 'white'\n",
      width, height);
}

constexpr const char* gnuplot_remedy =
    "check that gnuplot 5.4 or newer is installed, with its cairo terminals";

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

/// `drawn` is an SVG, a PNG and a PDF in succession: gnuplot's start dominates its time, so that
/// one start draws all three. In an SVG's texts, "<" is escaped.
Figure split(const std::string& name, const std::string& script, const std::string& drawn) {
  constexpr std::string_view svg_end = "</svg>";
  constexpr std::string_view png_begin = "\x89PNG";
  constexpr std::string_view png_end = "IEND\xae\x42\x60\x82";  // The last chunk and its checksum.
  const std::size_t png = drawn.find(png_begin, drawn.find(svg_end));
  const std::size_t end = drawn.find(png_end, png);
  if (end == std::string::npos) {
    throw Error("gnuplot", "drew no SVG or no PNG", gnuplot_remedy);
  }
  const std::size_t pdf = end + png_end.size();
  return {name, drawn.substr(0, png), drawn.substr(png, pdf - png), dateless_pdf(drawn.substr(pdf)),
          script};
}

}  // namespace

Figure drawn_figure(const std::string& name, int width, int height, const std::string& script) {
  return split(
      name, script,
      run_gnuplot(fmt::format("{0}{3}reset\n{1}{3}reset\n{2}{3}", svg_terminal(width, height),
                              png_terminal(width, height), pdf_terminal(width, height), script)));
}

std::string run_gnuplot(const std::string& script) {
  const ProgramEnd end = end_of_gnuplot(script);
  if (end.status != 0) {
    throw Error("gnuplot", "failed: " + end.errors, gnuplot_remedy);
  }
  if (end.output.empty()) {
    throw Error("gnuplot", "drew nothing, and reported no fault", gnuplot_remedy);
  }
  return end.output;
}

bool has_font() {
  try {
    // fontconfig's, which gnuplot asks for fonts through Pango.
    return !run_to_end({.words = {"fc-match", "--format=%{file}", "sans-serif"}}).output.empty();
  } catch (const std::system_error&) {
    return true;  // It is unknown.
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

}  // namespace foveola::analysis
