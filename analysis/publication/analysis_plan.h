// What the protocol planned to compare before there were data; anything else is exploratory.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "study/protocol/protocol.h"

namespace foveola::analysis {

/// The table [analysis] of a protocol's text, which was valid when the study began; an empty text
/// has an empty plan. Throws Error, with its place, for what is no TOML or no plan.
study::AnalysisPlan plan_of(const std::string& protocol_text);

bool is_primary(const study::AnalysisPlan& plan, const std::string& measure,
                const std::string& method, const std::string& reference);

/// How many of the planned comparisons are of measures that nothing here compares. A study that
/// plans them is not begun any more, but there are records of some.
std::size_t planned_without_tables(const study::AnalysisPlan& plan);

/// Empty where the plan says nothing.
std::optional<double> equivalence_margin(const study::AnalysisPlan& plan,
                                         const std::string& measure);

}  // namespace foveola::analysis
