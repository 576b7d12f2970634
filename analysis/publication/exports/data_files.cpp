#include "analysis/publication/exports/data_files.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>
#include <zlib.h>

#include "analysis/dataset/wording.h"

namespace foveola::analysis {
namespace {

/// Psych-DS allows only letters and digits in the values of file names. Lengths are limited by file
/// systems.
std::string file_word(const std::string& name) {
  std::string word;
  std::copy_if(name.begin(), name.end(), std::back_inserter(word),
               [](unsigned char c) { return c < 0x80 && std::isalnum(c) != 0; });
  constexpr std::size_t max_length = 64;
  return word.empty() ? "study" : word.substr(0, max_length);
}

/// Returns every column of the data files once: Psych-DS requires descriptions of all columns.
std::vector<Column> all_columns(std::vector<Column> trials,
                                const std::vector<Column>& participants) {
  std::set<std::string> described;
  for (const Column& column : trials) {
    described.insert(column.name);
  }
  for (const Column& column : participants) {
    if (described.insert(column.name).second) {
      trials.push_back(column);
    }
  }
  return trials;
}

std::string dataset_description(const StudyTables& tables, std::vector<Column> trials,
                                const std::vector<Column>& participants) {
  nlohmann::ordered_json variables = nlohmann::ordered_json::array();
  for (const Column& column : all_columns(trials, participants)) {
    nlohmann::ordered_json entry = {
        {"@type", "PropertyValue"}, {"name", column.name}, {"description", column.description}};
    if (!column.unit.empty()) {
      entry["unitText"] = column.unit;
    }
    variables.push_back(std::move(entry));
  }
  const std::string warning = data_warning(tables);
  const nlohmann::ordered_json json = {
      {"@context", "https://schema.org/"},
      {"@type", "Dataset"},
      {"name", tables.protocol_title.empty() ? tables.protocol_name : tables.protocol_title},
      {"description",
       (warning.empty() ? "" : warning + " ") +
           "Times and ratings of progressive previews, one row per trial and one per participant; "
           "protocol " +
           tables.protocol_name + ", SHA-256 " + tables.protocol_sha256},
      {"variableMeasured", variables}};
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace

PsychDs psych_ds(const StudyTables& tables, const std::vector<Column>& trials,
                 const std::vector<Column>& participants) {
  const std::string data = "psych-ds/data/study-" + file_word(tables.protocol_name);
  return {{"psych-ds/dataset_description.json", dataset_description(tables, trials, participants)},
          data + "_type-trials_data.csv",
          data + "_type-participants_data.csv"};
}

std::string gzip(std::string_view text) {
  constexpr int largest_window_with_gzip_header = 15 + 16;
  constexpr int default_memory = 8;
  z_stream stream{};
  if (::deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, largest_window_with_gzip_header,
                     default_memory, Z_DEFAULT_STRATEGY) != Z_OK) {
    throw std::runtime_error("zlib could not start");
  }
  const uLong max_bytes = ::deflateBound(&stream, static_cast<uLong>(text.size()));
  if (max_bytes > std::numeric_limits<uInt>::max()) {
    ::deflateEnd(&stream);
    throw std::length_error("texts of almost 4 GiB or more cannot be compressed");
  }
  std::string bytes(max_bytes, '\0');
  // zlib's interface lacks const here, but zlib does not write there.
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  const int result = ::deflate(&stream, Z_FINISH);
  bytes.resize(stream.total_out);
  ::deflateEnd(&stream);
  if (result != Z_STREAM_END) {
    throw std::runtime_error("zlib could not compress");
  }
  return bytes;
}

}  // namespace foveola::analysis
