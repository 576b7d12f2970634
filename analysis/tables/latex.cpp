#include "analysis/tables/latex.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>

#include <fmt/format.h>

#include "renderer/base/text/utf8.h"

namespace foveola::analysis {
namespace {

/// Parses the whole text as a number; empty if it is not one, or is too large.
template <typename Number>
std::optional<Number> number_in_full(std::string_view text) {
  Number number{};
  const char* end = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data(), end, number);
  return failure == std::errc() && stop == end ? std::optional(number) : std::nullopt;
}

/// Returns a number with an exponent, as 3.3e-05, or "< 1e-300", as a power of ten; empty for
/// another text.
std::optional<std::string> power_of_ten(std::string_view text) {
  const std::size_t e = text.find('e');
  if (e == std::string_view::npos) {
    return std::nullopt;
  }
  const std::string_view factor = text.substr(0, e);
  std::string_view exponent = text.substr(e + 1);
  exponent.remove_prefix(exponent.starts_with('+') ? 1 : 0);
  const std::optional<int> power = number_in_full<int>(exponent);
  if (!power || (factor != "< 1" && !number_in_full<double>(factor))) {
    return std::nullopt;
  }
  return factor == "< 1" ? fmt::format("$< 10^{{{}}}$", *power)
                         : fmt::format("${} \\times 10^{{{}}}$", factor, *power);
}

struct Symbol {
  std::string_view text;
  std::string_view latex;
};

/// Texts that LaTeX would treat as commands or set differently, and symbols and Greek letters with
/// commands of their own. Capitals that look like Latin ones are set as these.
constexpr Symbol symbols[] = {{"\\", "\\textbackslash{}"},
                              {"&", "\\&"},
                              {"%", "\\%"},
                              {"$", "\\$"},
                              {"#", "\\#"},
                              {"_", "\\_"},
                              {"{", "\\{"},
                              {"}", "\\}"},
                              {"~", "\\~{}"},
                              {"^", "\\^{}"},
                              {"<", "\\textless{}"},
                              {">", "\\textgreater{}"},
                              {"|", "\\textbar{}"},
                              {"--", "-{}-{}"},  // would be a dash
                              {"–", "--"},
                              {"—", "---"},
                              {"’", "'"},
                              {"‘", "`"},
                              {"“", "``"},
                              {"”", "''"},
                              {"„", ",,"},
                              {"‚", ","},
                              {"…", "\\dots{}"},
                              {"±", "$\\pm$"},
                              {"−", "$-$"},
                              {"×", "$\\times$"},
                              {"·", "$\\cdot$"},
                              {"²", "$^2$"},
                              {"°", "$^\\circ$"},
                              {"√", "$\\surd$"},
                              {"∞", "$\\infty$"},
                              {"≤", "$\\leq$"},
                              {"≥", "$\\geq$"},
                              {"≠", "$\\neq$"},
                              {"≈", "$\\approx$"},
                              {"→", "$\\rightarrow$"},
                              {"α", "$\\alpha$"},
                              {"β", "$\\beta$"},
                              {"γ", "$\\gamma$"},
                              {"δ", "$\\delta$"},
                              {"ε", "$\\epsilon$"},
                              {"ζ", "$\\zeta$"},
                              {"η", "$\\eta$"},
                              {"θ", "$\\theta$"},
                              {"ι", "$\\iota$"},
                              {"κ", "$\\kappa$"},
                              {"λ", "$\\lambda$"},
                              {"μ", "$\\mu$"},
                              {"ν", "$\\nu$"},
                              {"ξ", "$\\xi$"},
                              {"ο", "o"},
                              {"π", "$\\pi$"},
                              {"ρ", "$\\rho$"},
                              {"σ", "$\\sigma$"},
                              {"ς", "$\\varsigma$"},
                              {"τ", "$\\tau$"},
                              {"υ", "$\\upsilon$"},
                              {"φ", "$\\phi$"},
                              {"χ", "$\\chi$"},
                              {"ψ", "$\\psi$"},
                              {"ω", "$\\omega$"},
                              {"Α", "A"},
                              {"Β", "B"},
                              {"Γ", "$\\Gamma$"},
                              {"Δ", "$\\Delta$"},
                              {"Ε", "E"},
                              {"Ζ", "Z"},
                              {"Η", "H"},
                              {"Θ", "$\\Theta$"},
                              {"Ι", "I"},
                              {"Κ", "K"},
                              {"Λ", "$\\Lambda$"},
                              {"Μ", "M"},
                              {"Ν", "N"},
                              {"Ξ", "$\\Xi$"},
                              {"Ο", "O"},
                              {"Π", "$\\Pi$"},
                              {"Ρ", "P"},
                              {"Σ", "$\\Sigma$"},
                              {"Τ", "T"},
                              {"Υ", "$\\Upsilon$"},
                              {"Φ", "$\\Phi$"},
                              {"Χ", "X"},
                              {"Ψ", "$\\Psi$"},
                              {"Ω", "$\\Omega$"}};

/// Returns the symbol at the beginning of a text; null if there is none.
const Symbol* symbol_before(std::string_view rest) {
  const Symbol* found = std::ranges::find_if(
      symbols, [&](const Symbol& symbol) { return rest.starts_with(symbol.text); });
  return found == std::end(symbols) ? nullptr : found;
}

/// Returns whether a negative number begins there.
bool is_minus(std::string_view text, std::size_t at) {
  const bool is_first =
      at == 0 || std::string_view(" [(").find(text[at - 1]) != std::string_view::npos;
  return is_first && text[at] == '-' && at + 1 < text.size() &&
         std::isdigit(static_cast<unsigned char>(text[at + 1])) != 0;
}

/// A straight quotation mark opens after characters that do not end words. Unchanged, it is a
/// command in several languages' packages.
const char* straight_quote(std::string_view text, std::size_t at) {
  const bool opens =
      at == 0 || std::string_view(" [({/-").find(text[at - 1]) != std::string_view::npos;
  return opens ? "``" : "''";
}

/// Returns whether the place is in a word that does not fit into a narrow column. LaTeX can
/// hyphenate words of a language, but not names.
bool is_in_long_word(std::string_view text, std::size_t at) {
  constexpr std::size_t longest_in_one_line = 20;
  const std::size_t space = text.rfind(' ', at);
  const std::size_t begin = space == std::string_view::npos ? 0 : space + 1;
  const std::size_t end = std::min(text.find(' ', at), text.size());
  return end - begin > longest_in_one_line;
}

}  // namespace

std::string latex_text(std::string_view text) {
  if (std::optional<std::string> power = power_of_ten(text)) {
    return *std::move(power);
  }
  const std::string plain = printable(text);
  std::string latex;
  for (std::size_t i = 0; i < plain.size();) {
    const Symbol* symbol = symbol_before(std::string_view(plain).substr(i));
    if (symbol != nullptr) {
      latex += symbol->latex;
    } else if (is_minus(plain, i)) {
      latex += "$-$";
    } else if (plain[i] == '"') {
      latex += straight_quote(plain, i);
    } else {
      latex += plain[i];
    }
    if ((plain[i] == '_' || plain[i] == '/') && is_in_long_word(plain, i)) {
      latex += "\\allowbreak{}";
    }
    i += symbol != nullptr ? symbol->text.size() : 1;
  }
  return latex;
}

std::string latex_needs(std::string_view table) {
  // In UTF-8, U+0180 and above begin with a byte from 0xC6 on, and continuation bytes are below
  // 0xC0.
  const auto highest = static_cast<unsigned char>(
      *std::ranges::max_element(table, [](unsigned char a, unsigned char b) { return a < b; }));
  std::string needs = "% Needs \\usepackage{array,booktabs,graphicx}.\n";
  if (highest >= 0xC6) {
    needs +=
        "% Has characters that pdfLaTeX may not know: take LuaLaTeX and a font that has them.\n";
  } else if (highest >= 0x80) {
    needs += "% Needs \\usepackage[T1]{fontenc} if set by pdfLaTeX, for its letters.\n";
  }
  return needs;
}

}  // namespace foveola::analysis
