// Formats names, estimates and facts of a study, the same in the report, the figures and the
// terminal.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/dataset/dataset.h"
#include "analysis/dataset/study_tables.h"
#include "analysis/tables/number_text.h"

namespace foveola::analysis {

/// Returns "OD", "VP" and "FV" as in print; any other method by its id.
std::string method_label(const std::string& method);

/// Returns "omnidirectional preview" and so on; empty for a method that is not in the paper
/// (section 4.1).
std::string_view method_meaning(const std::string& method);

/// Returns "12.3 ± 4.5", or "12.3" for a single value, or an en dash.
std::string mean_and_deviation(const Description& description, int decimals);

/// Returns "12.3 [10.1, 14.9]", without the interval if there is none, or an en dash.
std::string with_interval(const std::optional<Estimate>& estimate, int decimals);

/// Joins two sentences by a space; the second may be empty.
std::string join_sentences(const std::string& sentence, const std::string& more);

/// Returns "1 scene", "2 scenes": the plural has an s.
std::string count_with_noun(std::size_t count, std::string_view singular);

/// Joins the ids by ", ".
std::string comma_list(const std::vector<std::string>& names);

/// Returns a sentence on right-censored times: that they are left out, their number by mark and
/// method, and that this favours the method with the censored times. Empty if there are none.
std::string censored_times_in_words(const Dataset& set);

/// Returns "1 participant", "16 simulated participants" and the like.
std::string participants_in_words(const StudyTables& tables);

/// Returns "Simulated data", "From a changed record" and the like, for every caption; empty for
/// people's data from an unchanged record.
std::string data_notice(const StudyTables& tables);

/// Returns data_notice as a sentence for the top of a report.
std::string data_warning(const StudyTables& tables);

/// Returns, for each rating, the labels by which sessions of `participants` deviate from the
/// study's protocol. Throws Error if an amended protocol in `records` is malformed.
std::vector<AmendedLabels> amended_labels(const study::StudyRecords& records,
                                          const std::vector<std::string>& participants);

/// Returns the scale in words, with the labels of amended sessions: "1 (none) to 5 (all over). In 2
/// analysed sessions, by an amended protocol, the points were …". measure: index of a rating.
std::string scale_with_amendments(const Dataset& set, std::size_t measure);

/// Returns the sentence on other labels alone, after a space; usually empty.
std::string amendments_of_scale(const Dataset& set, std::size_t measure);

}  // namespace foveola::analysis
