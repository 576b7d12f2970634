#include <algorithm>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/publication/report_parts.h"
#include "analysis/publication/report_sections.h"
#include "analysis/tables/html.h"

namespace foveola::analysis {
namespace {

constexpr std::size_t most_faults_listed = 100;

std::string in_words(const study::RecordFault& fault) {
  return fault.participant.empty() ? fault.what
                                   : fmt::format("{}: {}", fault.participant, fault.what);
}

std::string fault_list(const std::vector<study::RecordFault>& faults) {
  std::string items = "<ul>\n";
  for (std::size_t i = 0; i < std::min(most_faults_listed, faults.size()); ++i) {
    items += fmt::format("<li>{}</li>\n", escape_html(in_words(faults[i])));
  }
  if (faults.size() > most_faults_listed) {
    items += fmt::format("<li>and {} more, which <code>foveola study verify</code> lists</li>\n",
                         faults.size() - most_faults_listed);
  }
  return items + "</ul>\n";
}

std::string finding(const study::Verification& record) {
  return record.faults.empty() ? "<p>It is unchanged since it was written.</p>\n"
                               : "<p>It was changed or damaged since it was written, and was "
                                 "analysed all the same, as was asked for with "
                                 "<code>--unverified</code>:</p>\n" +
                                     fault_list(record.faults);
}

std::string gaps(const study::Verification& record) {
  return record.gaps.empty()
             ? "<p>Nothing is missing in it.</p>\n"
             : "<p>What is missing in it, which is no damage:</p>\n" + fault_list(record.gaps);
}

std::string warnings_of(const study::Verification& record) {
  return record.warnings.empty()
             ? ""
             : "<p>What is no damage, and is to be known before its dates or times are "
               "compared:</p>\n" +
                   fault_list(record.warnings);
}

}  // namespace

std::string record_flags(const std::optional<study::Verification>& record) {
  if (!record || record->faults.empty()) {
    return "";
  }
  return fmt::format(
      "<div class=\"flags\" role=\"note\"><p>⚑ The study’s file is not what was written ({}): any "
      "number here may be wrong.</p></div>\n",
      counted(record->faults.size(), "fault"));
}

std::string record_section(const std::optional<study::Verification>& record) {
  if (!record) {
    return html_section("The record",
                        "<p>These data do not come from a study’s file: there is no record to "
                        "verify.</p>\n");
  }
  return html_section(
      "The record",
      fmt::format("<p>The study’s file was verified before it was read, as <code>foveola study "
                  "verify</code> does: by SQLite’s own checks, the hash chains over {} of {}, the "
                  "checksums of {} of frames and gaze, and whether every table follows from the "
                  "events.</p>\n",
                  counted(record->events, "event"), counted(record->sessions, "session"),
                  counted(record->chunks, "chunk")) +
          finding(*record) + gaps(*record) + warnings_of(*record));
}

}  // namespace foveola::analysis
