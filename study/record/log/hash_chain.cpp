#include "study/record/log/hash_chain.h"

#include <array>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include "renderer/base/files/digest.h"
#include "study/record/schema.h"

namespace foveola::study {
namespace {

/// Every row as a JSON array, in the order that schema.sql gives; ?1 is the session.
constexpr std::array facts = {
    "SELECT json_array(protocol_name, protocol_title, protocol_text, protocol_sha256) FROM study",
    "SELECT json_array(position, name) FROM study_scene ORDER BY position",
    "SELECT json_array(position, name) FROM study_method ORDER BY position",
    "SELECT json_array(method, file_name, file_sha256) FROM study_method_file"
    " ORDER BY method, file_name",
    "SELECT json_array(device, name, toml, toml_sha256) FROM study_profile ORDER BY device, name",
    "SELECT json_array(position, mark) FROM study_mark ORDER BY position",
    "SELECT json_array(position, rating, question) FROM study_rating ORDER BY position",
    "SELECT json_array(uuid, {}, kind, seed, design_row, started_utc, program_version,"
    "  compiler, build_type, processor, cores, operating_system, devices, migrated_from{})"
    " FROM session WHERE id = ?1",
    "SELECT json_array(scene, file_name, file_sha256, shown_as) FROM session_scene"
    " WHERE session = ?1 ORDER BY scene",
    "SELECT json_array(trial, kind, scene, method, scene_position, method_position)"
    " FROM planned_trial WHERE session = ?1 ORDER BY trial",
    "SELECT json_array(step, kind, questionnaire, times, trial, chooses_object)"
    " FROM planned_step WHERE session = ?1 ORDER BY step"};

}  // namespace

std::string hash_before_events(PreparedStatements& statements, std::int64_t session) {
  const bool is_older = schema_version_of(statements.database()) < 5;
  const char* const code =
      is_older ? "participant" : "substr(participant, iif(site = '', 1, length(site) + 2))";
  const char* const since_5 = is_older ? "" : ", study_created_utc";
  std::string lines;
  for (const char* sql : facts) {
    PreparedStatement rows(statements, fmt::format(fmt::runtime(sql), code, since_5));
    if (rows->getBindParameterCount() > 0) {
      rows->bind(1, session);
    }
    while (rows->executeStep()) {
      lines += fmt::format("{}{}", lines.empty() ? "" : "\n", rows->getColumn(0).getString());
    }
  }
  return sha256(lines);
}

LogLine log_line(SQLite::Statement& row, int schema) {
  LogLine line{.sequence = row.getColumn("sequence").getInt64(),
               .time_ns = row.getColumn("time_ns").getInt64(),
               .utc = row.getColumn("utc").getString(),
               .type = row.getColumn("type").getString(),
               .payload = row.getColumn("payload").getString()};
  if (schema >= 5) {
    if (const SQLite::Column trial = row.getColumn("trial"); !trial.isNull()) {
      line.trial = trial.getInt64();
      line.attempt = row.getColumn("attempt").getInt64();
    }
    line.measured = row.getColumn("measured").getString();
  }
  return line;
}

std::string hash_of(const std::string& previous, const LogLine& line, int schema) {
  std::string lines = fmt::format("{}\n{}\n{}\n{}\n{}\n{}", previous, line.sequence, line.time_ns,
                                  line.utc, line.type, line.payload);
  if (schema >= 5) {
    const auto text = [](const std::optional<std::int64_t>& number) {
      return number ? std::to_string(*number) : "";
    };
    lines += fmt::format("\n{}\n{}\n{}", text(line.trial), text(line.attempt), line.measured);
  }
  return sha256(lines);
}

}  // namespace foveola::study
