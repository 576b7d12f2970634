#include "study/record/recorded_gaze.h"

#include <stdexcept>

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "study/record/chunk.h"
#include "study/record/database.h"
#include "study/record/gaze_encoding.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

std::vector<GazeSample> samples_of(SQLite::Statement& chunks, const fs::path& path) {
  std::vector<GazeSample> samples;
  while (chunks.executeStep()) {
    try {
      const std::vector<GazeSample> more = decode_gaze(
          chunk_bytes(chunks, chunks.getColumn("sample_count").getInt64() * bytes_per_gaze_sample));
      samples.insert(samples.end(), more.begin(), more.end());
    } catch (const std::invalid_argument&) {
      throw Error(path.string(), "its gaze samples are not those that were written",
                  "restore it from a copy");
    }
  }
  return samples;
}

}  // namespace

std::vector<GazeSample> read_gaze(const fs::path& path, const std::string& participant,
                                  std::size_t trial) {
  std::vector<GazeSample> samples;
  with_clear_errors(path, [&] {
    SQLite::Database database = open_study_to_read(path);
    SQLite::Statement chunks(
        database,
        "SELECT data, data_sha256, sample_count FROM gaze_chunk AS chunk"
        " JOIN session ON session.id = chunk.session"
        " WHERE participant = ? AND trial = ? AND attempt = (SELECT max(attempt) FROM attempt"
        "  WHERE attempt.session = chunk.session AND attempt.trial = chunk.trial)"
        " ORDER BY first_sample");
    SQLite::bind(chunks, participant, static_cast<std::int64_t>(trial));
    samples = samples_of(chunks, path);
  });
  if (samples.empty()) {
    throw Error(path.string(),
                fmt::format("has no gaze of participant {} in trial {}", participant, trial),
                "foveola study status says whose sessions there are; the first trial is 0");
  }
  return samples;
}

}  // namespace foveola::study
