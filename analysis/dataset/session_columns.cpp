#include "analysis/dataset/session_columns.h"

namespace foveola::analysis {

Column kind_column() {
  return {"participant_kind", ColumnType::text, "",
          "Kind of participant: human, pilot or simulated"};
}

Column record_column() {
  return {"record", ColumnType::text, "",
          "Verification of the study's file: verified, changed (analysed with --unverified), or "
          "none (analysed without a file)"};
}

std::string status_of(const study::SessionRow& session, bool is_analysed) {
  if (is_analysed) {
    return "analysed";
  }
  return session.state == "completed" ? "other kind" : end_of(session);
}

}  // namespace foveola::analysis
