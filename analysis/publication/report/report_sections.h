// The sections of the report, in their order; report.h puts them on a page.
#pragma once

#include <string>

#include "analysis/publication/report/report.h"

namespace foveola::analysis {

// Each function returns the HTML of a section, with every text from the study escaped.

/// The warning that the study's file failed its verification, for the report's top; empty if it
/// passed.
std::string record_flags(const ReportContent& content);

/// The data-quality limits that were missed, for the report's top; empty if none.
std::string data_quality_flags(const ReportContent& content);

/// Times in each scene, in both readings of their percentages, with their figure.
std::string scenes_section(const ReportContent& content);

/// Times over all scenes, with their figures.
std::string methods_section(const ReportContent& content);

/// Every numeric rating; empty if there is none.
std::string ratings_section(const ReportContent& content);

/// Primary analyses of planned and exploratory comparisons; empty for a single method.
std::string comparisons_section(const ReportContent& content);

/// Answers to questionnaires and their scores; empty if nothing was asked.
std::string answers_section(const ReportContent& content);

/// Correlation of background with speed-up, and its P-value.
std::string background_section(const ReportContent& content);

/// Checks, latency (Fig. 7), attempts, and the floor of reaction times.
std::string data_quality_section(const ReportContent& content);

/// Verification of the study's file and its findings, or that there was no file.
std::string record_section(const ReportContent& content);

/// Excluded sessions and values, with the reasons.
std::string exclusions_section(const ReportContent& content);

/// Sessions that followed an amended protocol, and its changed keys.
std::string amended_section(const ReportContent& content);

/// All other tests of the same comparisons; empty for a single method.
std::string sensitivity_section(const ReportContent& content);

/// The definitions of all numbers.
std::string definitions_section(const ReportContent& content);

}  // namespace foveola::analysis
