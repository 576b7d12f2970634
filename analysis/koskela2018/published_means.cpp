#include "analysis/koskela2018/published_means.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "renderer/base/csv.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace foveola::analysis {
namespace {

double number(const std::string& field, const std::string& where) {
  double value = 0.0;
  const char* end = field.data() + field.size();
  const auto [stop, failure] = std::from_chars(field.data(), end, value);
  if (failure != std::errc() || stop != end) {
    throw Error(where, fmt::format("\"{}\" is not a number", field), "restore the file");
  }
  return value;
}

}  // namespace

std::vector<PublishedMean> read_published_means(const std::filesystem::path& path) {
  const std::vector<CsvRow> rows = parse_csv(read_file(path), path.string());
  const CsvRow columns = {"method", "low_percent_of_od", "high_percent_of_od"};
  if (rows.empty() || rows.front() != columns) {
    throw Error(path.string() + ":1", "does not have the columns of published means",
                "restore the file");
  }
  std::vector<PublishedMean> means;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const std::string where = fmt::format("{}:{}", path.string(), i + 1);
    if (rows[i].size() != columns.size()) {
      throw Error(where, fmt::format("has {} fields instead of 3", rows[i].size()),
                  "restore the file");
    }
    means.push_back({rows[i][0], {number(rows[i][1], where), number(rows[i][2], where)}});
  }
  return means;
}

std::optional<Interval> published_mean_of(const std::vector<PublishedMean>& means,
                                          const std::string& baseline, const std::string& method) {
  const auto found = std::find_if(means.begin(), means.end(),
                                  [&](const PublishedMean& mean) { return mean.method == method; });
  return baseline == "od" && found != means.end() ? std::optional(found->percent_of_od)
                                                  : std::nullopt;
}

}  // namespace foveola::analysis
