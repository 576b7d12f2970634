// Session facts in rows of trials, answers and scores.
#pragma once

#include <optional>
#include <string>

#include "analysis/dataset/dataset.h"
#include "analysis/tables/table.h"
#include "study/record/read/study_records.h"

namespace foveola::analysis {

/// Returns the column with the kind of the data; it does not depend on the row.
Column kind_column();

/// Returns the last column of every table of an analysis: the result of verifying the study's file.
Column record_column();

// Descriptions of columns.
inline constexpr const char* code_meaning = "Code of the participant";
inline constexpr const char* mark_meaning =
    "Id of the mark in the protocol: the judgement at which the participant pressed the key";
inline constexpr const char* step_meaning =
    "Index of the step in the session's plan, from 0; tells repeated questionnaires apart";
inline constexpr const char* state_meaning =
    "The session's recorded state: completed, excluded, withdrawn, refused by the protocol's gate, "
    "or, if it has not ended, its last state";
inline constexpr const char* reason_meaning =
    "Why the session is not analysed, and the experimenter's reason if one was recorded; empty if "
    "it is analysed";
inline constexpr const char* session_status_meaning =
    "analysed, or the reason why it is not: excluded, withdrawn (with --withdrawn only), "
    "interrupted, refused, or of another kind (other kind)";

/// Returns "analysed", or why the session is not.
std::string status_of(const study::SessionRow& session, bool is_analysed);

/// Returns a function that gives the reason why a session is not analysed; empty if it is.
inline auto reason_in(const Dataset& set) {
  return [&set](const study::SessionRow& session) {
    const std::string reason = reason_not_analysed(session, set.kind);
    return reason.empty() ? std::nullopt : std::optional(reason);
  };
}

}  // namespace foveola::analysis
