// The figures of `bench statistics` in words and as JSON, and whether they are as required.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/monte_carlo/coverage.h"

namespace foveola::analysis {

/// A line on standard output; its name takes `width` letters.
void print_figure(const CoverageFigure& figure, std::size_t width);

/// All figures as lines on standard output, below one that says what the studies are.
void print_table(const CoverageSettings& settings, const std::vector<CoverageFigure>& figures);

/// One object on standard output: what is in `about`, then the figures.
void print_json(const nlohmann::ordered_json& about, const std::vector<CoverageFigure>& figures);

/// Throws Error for the first figure that lies outside its required range.
void require_all(const std::vector<CoverageFigure>& figures);

}  // namespace foveola::analysis
