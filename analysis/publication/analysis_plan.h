// The comparisons that the protocol planned before there were data; any other is exploratory.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "study/protocol/protocol.h"

namespace foveola::analysis {

/// The table [analysis] of a protocol's text, which was valid when the study began; an empty text
/// has an empty plan. Throws Error, with its place, for a text that is no TOML or has no valid
/// plan.
study::AnalysisPlan plan_of(const std::string& protocol_text);

bool is_primary(const study::AnalysisPlan& plan, const std::string& measure,
                const std::string& method, const std::string& reference);

/// The number of planned comparisons of measures that the analysis does not compare. No study that
/// plans them can be begun any more, but there are older records of some.
std::size_t planned_without_tables(const study::AnalysisPlan& plan);

/// The planned margin of the measure's equivalence test; empty where the plan has none.
std::optional<double> equivalence_margin(const study::AnalysisPlan& plan,
                                         const std::string& measure);

}  // namespace foveola::analysis
