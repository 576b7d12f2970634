#include "analysis/publication/report/report_style.h"

namespace foveola::analysis {

std::string_view report_style() {
  return R"css(
:root {
  color-scheme: light dark;
  --paper: #fdfdfc;
  --text: #1f2328;
  --quiet: #59636e;
  --rule: #d4d8dd;
  --accent: #0b6aa8;
  --notice: #fdf3dc;
  --notice-rule: #b07d12;
  --flag: #c2261c;
  --figure-ink: #1f2328;
  --figure-paper: #ffffff;
  --figure-grid: #e1e4e8;
  --figure-participant: #b4bec8;
  --figure-method-1: #0b6aa8;
  --figure-method-2: #b8500c;
  --figure-method-3: #2f7d32;
  --figure-method-4: #7b3fa0;
  --figure-method-5: #8a6d00;
  --figure-method-6: #a8245e;
  --figure-rating-1: #e6edf4;
  --figure-rating-2: #b9cfe3;
  --figure-rating-3: #7fa8cc;
  --figure-rating-4: #3c76aa;
  --figure-rating-5: #12426f;
  --figure-on-low-rating: #14222f;
  --figure-on-high-rating: #fdfeff;
}
@media screen and (prefers-color-scheme: dark) {
  :root {
    --paper: #14171a;
    --text: #e4e7ea;
    --quiet: #9da7b1;
    --rule: #343a41;
    --accent: #6cb6e8;
    --notice: #2e2611;
    --notice-rule: #d9a633;
    --flag: #ff8a80;
    --figure-ink: #d5dade;
    --figure-paper: #14171a;
    --figure-grid: #2c3238;
    --figure-participant: #505b66;
    --figure-method-1: #5fb4ea;
    --figure-method-2: #f09a5c;
    --figure-method-3: #7ccf80;
    --figure-method-4: #c79be6;
    --figure-method-5: #d9bd4b;
    --figure-method-6: #f08cb8;
    --figure-rating-1: #24303b;
    --figure-rating-2: #31495e;
    --figure-rating-3: #456d91;
    --figure-rating-4: #7eb3dd;
    --figure-rating-5: #d3e9fa;
    --figure-on-low-rating: #eef3f7;
    --figure-on-high-rating: #0d1a26;
  }
}
* { box-sizing: border-box; }
body {
  margin: 0 auto;
  padding: 3rem 1.5rem 4rem;
  max-width: 60rem;
  background: var(--paper);
  color: var(--text);
  font: 1rem/1.55 Charter, "Bitstream Charter", "Source Serif 4", Cambria, Georgia, serif;
}
h1, h2, h3, table, figcaption, .facts, .notice, .flags, .eyebrow, svg text {
  font-family: system-ui, "Segoe UI", Roboto, "Helvetica Neue", "Noto Sans", "DejaVu Sans", sans-serif;
}
.eyebrow { margin: 0; color: var(--quiet); font-size: 0.85rem; letter-spacing: 0.02em; }
h1 { margin: 0.2rem 0 1.2rem; font-size: 1.9rem; line-height: 1.2; font-weight: 650; }
h2 {
  margin: 3.2rem 0 0.8rem;
  padding-top: 0.9rem;
  border-top: 1px solid var(--rule);
  font-size: 1.25rem;
  font-weight: 650;
}
p, ul, ol, dl { margin: 0 0 1rem; max-width: 42rem; }
a { color: var(--accent); }
code { font-size: 0.88em; overflow-wrap: anywhere; }
.facts { display: grid; grid-template-columns: max-content 1fr; gap: 0.25rem 1.2rem; max-width: none; font-size: 0.9rem; }
.facts dt { color: var(--quiet); }
.facts dd { margin: 0; overflow-wrap: anywhere; }
.notice {
  max-width: none;
  margin: 0 0 1.6rem;
  padding: 0.75rem 1rem;
  border-left: 4px solid var(--notice-rule);
  background: var(--notice);
  font-size: 0.95rem;
}
.flags { margin: 0 0 1.6rem; padding: 0.75rem 1rem; border-left: 4px solid var(--flag); font-size: 0.95rem; }
.flags p, .flags ul { margin: 0; }
blockquote { margin: 0 0 1rem; padding-left: 1rem; border-left: 2px solid var(--rule); max-width: 42rem; }
.tag {
  display: inline-block;
  margin-right: 0.45em;
  padding: 0 0.4em;
  border: 1px solid var(--notice-rule);
  border-radius: 0.2em;
  font-size: 0.85em;
}
.findings { padding-left: 1.2rem; }
.findings li { margin-bottom: 0.35rem; }
.scroll { overflow-x: auto; margin: 1.4rem 0 1.8rem; }
table { border-collapse: collapse; width: 100%; font-size: 0.88rem; line-height: 1.4; }
caption, figcaption { text-align: left; color: var(--quiet); font-size: 0.88rem; line-height: 1.45; }
caption { max-width: min(56rem, 100vw - 3rem); padding-bottom: 0.6rem; }
caption strong, figcaption strong { color: var(--text); }
thead { border-top: 1.5px solid var(--text); border-bottom: 1px solid var(--text); }
tbody { border-bottom: 1.5px solid var(--text); }
th, td { padding: 0.32rem 0.7rem; text-align: left; vertical-align: baseline; }
th:first-child, td:first-child { padding-left: 0; }
th:last-child, td:last-child { padding-right: 0; }
th { font-weight: 600; }
tbody th { font-weight: 400; overflow-wrap: break-word; }
.numeric th:not(:first-child), .numeric td { text-align: right; }
.numeric td { font-variant-numeric: tabular-nums lining-nums; white-space: nowrap; }
.numeric th[scope="colgroup"] { text-align: center; }
thead th[scope="colgroup"] { background: linear-gradient(var(--rule), var(--rule)) bottom / calc(100% - 1.4rem) 1px no-repeat; }
figure { margin: 1.8rem 0 2.2rem; }
figure .scroll { margin: 0 0 0.5rem; }
figure svg { display: block; width: 100%; min-width: 34rem; max-width: 44rem; height: auto; }
.definitions dt { font-weight: 600; }
.definitions dd { margin: 0 0 0.7rem; }
footer { margin-top: 3rem; padding-top: 0.9rem; border-top: 1px solid var(--rule); color: var(--quiet); font-size: 0.88rem; }
.page-mark { display: none; }
@media screen and (max-width: 40rem) {
  body { padding: 1.5rem 1rem 3rem; }
  h1 { font-size: 1.5rem; }
  caption { max-width: calc(100vw - 2rem); }
  .facts { display: block; }
  .facts dd { margin-bottom: 0.5rem; }
}
@media print {
  @page { margin: 15mm; }
  :root { --paper: white; }
  * { print-color-adjust: exact; }
  /* A table's heading is printed on every page and, unlike a fixed element, over nothing. */
  body { display: table; width: 100%; max-width: none; padding: 0; font-size: 10pt; }
  .page-mark { display: table-header-group; break-inside: avoid; text-align: right; font-weight: 600; }
  h2 { margin-top: 2rem; }
  h2, .definitions dt, p:has(+ figure), p:has(+ .scroll), p:has(+ blockquote) { break-after: avoid; }
  figure, table, tr, .notice, .flags, blockquote, dd { break-inside: avoid; }
  p, li { orphans: 3; widows: 3; }
  .scroll { overflow: visible; }
  figure svg { min-width: 0; }
}
)css";
}

}  // namespace foveola::analysis
