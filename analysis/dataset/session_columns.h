// What rows of trials, answers and scores say of their session.
#pragma once

#include <optional>
#include <string>

#include "analysis/dataset/dataset.h"
#include "analysis/tables/table.h"
#include "study/record/study_records.h"

namespace foveola::analysis {

/// The column that says whose data a row has; it needs nothing of a row.
Column kind_column();

/// The column that ends every table of an analysis: what verifying the study's file found.
Column record_column();

// Descriptions of columns.
inline constexpr const char* code_meaning = "Code of the participant";
inline constexpr const char* state_meaning =
    "The session's recorded state: completed, excluded, withdrawn, refused by the protocol's gate, "
    "or, of a session that has not ended, the state that it was left in";
inline constexpr const char* reason_meaning =
    "Why the session is not analysed, with the reason that was recorded; empty for one that is";
inline constexpr const char* session_status_meaning =
    "analysed; or why the session is not: excluded, withdrawn (with --withdrawn only), "
    "interrupted, refused, or of another kind (other kind)";

/// "analysed", or why the session is not.
std::string status_of(const study::SessionRow& session, bool is_analysed);

/// Finds why a session is not analysed; empty for one that is.
inline auto reason_in(const Dataset& set) {
  return [&set](const study::SessionRow& session) {
    const std::string reason = reason_not_analysed(session, set.kind);
    return reason.empty() ? std::nullopt : std::optional(reason);
  };
}

}  // namespace foveola::analysis
