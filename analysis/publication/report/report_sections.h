// The sections of the report, one after the other; report.h puts them on a page.
#pragma once

#include <string>

#include "analysis/publication/report/report.h"

namespace foveola::analysis {

// Each function returns the HTML of a section, with every text from the study escaped.

/// The warning that the study's file failed its verification, for the top of the report; empty if
/// it passed.
std::string record_flags(const ReportContent& content);

/// The data-quality limits that were missed, for the top of the report; empty if none.
std::string data_quality_flags(const ReportContent& content);

/// The times in each scene, in both readings of their percentages, with their figure.
std::string scenes_section(const ReportContent& content);

/// The times over all scenes, with their figures.
std::string methods_section(const ReportContent& content);

/// Every rating in numbers; empty if there is none.
std::string ratings_section(const ReportContent& content);

/// The primary analyses of planned and exploratory comparisons; empty for a single method.
std::string comparisons_section(const ReportContent& content);

/// The answers to questionnaires and their scores; empty if nothing was asked.
std::string answers_section(const ReportContent& content);

/// The correlation of background with speed-up, and its P-value.
std::string background_section(const ReportContent& content);

/// Checks, latency (Fig. 7), attempts, and the floor of reaction times.
std::string data_quality_section(const ReportContent& content);

/// How the study's file was verified, and the findings, or that there was no file.
std::string record_section(const ReportContent& content);

/// The excluded sessions and values, with the reasons.
std::string exclusions_section(const ReportContent& content);

/// The sessions that followed an amended protocol, and which of its keys had changed.
std::string amended_section(const ReportContent& content);

/// All other tests of the same comparisons; empty for a single method.
std::string sensitivity_section(const ReportContent& content);

/// The definitions of all numbers.
std::string definitions_section(const ReportContent& content);

}  // namespace foveola::analysis
