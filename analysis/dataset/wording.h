// How names, estimates and facts of a study are written, the same in the report, the figures and
// the terminal.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/dataset/dataset.h"
#include "analysis/dataset/study_tables.h"
#include "analysis/tables/number_text.h"

namespace foveola::analysis {

/// "OD", "VP" and "FV" as in print; any other method by its id.
std::string method_label(const std::string& method);

/// "omnidirectional preview" and so on; empty for a method that the paper does not have
/// (section 4.1).
std::string_view method_meaning(const std::string& method);

/// "12.3 ± 4.5", or "12.3" for a single value, or an en dash.
std::string mean_and_deviation(const Description& description, int decimals);

/// "12.3 [10.1, 14.9]", without the interval if there is none, or an en dash.
std::string with_interval(const std::optional<Estimate>& estimate, int decimals);

/// Two sentences with a space between them; the second may be empty.
std::string joined(const std::string& sentence, const std::string& more);

/// "1 scene", "2 scenes".
std::string counted(std::size_t count, std::string_view singular);

/// The ids, separated by ", ".
std::string listed(const std::vector<std::string>& names);

/// That right-censored times are left out, how many of each mark and method, and whom that favours;
/// empty if there are none.
std::string censored_times_in_words(const Dataset& set);

/// "1 participant", "16 simulated participants" and the like.
std::string participants_in_words(const StudyTables& tables);

/// "Simulated data", "From a changed record" and the like, which every caption must say; empty for
/// people's data from a record that is what was written.
std::string data_notice(const StudyTables& tables);

/// data_notice as a sentence of its own for the top of a report.
std::string data_warning(const StudyTables& tables);

/// Of each rating of `records`, the labels that differ from the study's in sessions of
/// `participants`. Throws Error with its place for a text that is no protocol.
std::vector<AmendedLabels> amended_labels(const study::StudyRecords& records,
                                          const std::vector<std::string>& participants);

/// The scale in words, with the labels that amended sessions had: "1 (none) to 5 (all over). In 2
/// analysed sessions, by an amended protocol, the points were …".
std::string scale_with_amendments(const Dataset& set, std::size_t measure);

/// The sentence on other labels alone, with a space before it; usually empty.
std::string amendments_of_scale(const Dataset& set, std::size_t measure);

}  // namespace foveola::analysis
