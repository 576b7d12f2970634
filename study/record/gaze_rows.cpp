#include "study/record/gaze_rows.h"

#include <optional>
#include <string>

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <nlohmann/json.hpp>

#include "renderer/base/angles.h"
#include "study/record/gaze_json.h"

namespace foveola::study {
namespace {

/// Binds from `index` on; nothing is bound, which is NULL, if there are none.
void bind_figures(SQLite::Statement& row, int index, const std::optional<GazeFigures>& figures) {
  if (figures) {
    row.bind(index, figures->accuracy_deg);
    row.bind(index + 1, figures->precision_rms_deg);
    row.bind(index + 2, figures->precision_sd_deg);
  }
}

void insert_run(SQLite::Database& database, std::int64_t session, std::int64_t sequence,
                const GazeRun& run) {
  SQLite::Statement row(
      database,
      "INSERT INTO gaze_run (session, sequence, data_loss, passed, accuracy_deg, precision_rms_deg,"
      "  precision_sd_deg, correction, run)"
      " VALUES (?1, ?, ?, ?, ?, ?, ?, ?,"
      "  (SELECT coalesce(max(run), 0) + 1 FROM gaze_run WHERE session = ?1))");
  SQLite::bind(row, session, sequence, run.quality.data_loss, run.passed ? 1 : 0);
  bind_figures(row, 5, run.quality.figures);
  if (run.correction) {
    row.bind(8, study::json_of(*run.correction).dump());
  }
  row.exec();
}

void insert_target(SQLite::Database& database, std::int64_t session, std::size_t number,
                   const TargetQuality& target) {
  SQLite::Statement row(
      database,
      "INSERT INTO gaze_target (session, target, azimuth_deg, elevation_deg, data_loss, samples,"
      "  mean_gaze_azimuth_deg, mean_gaze_elevation_deg, accuracy_deg, precision_rms_deg,"
      "  precision_sd_deg, run)"
      " VALUES (?1, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?,"
      "  (SELECT max(run) FROM gaze_run WHERE session = ?1))");
  const AzimuthElevation place = azimuth_elevation(target.direction);
  SQLite::bind(row, session, static_cast<std::int64_t>(number), degrees(place.azimuth_rad),
               degrees(place.elevation_rad), target.data_loss,
               static_cast<std::int64_t>(target.seen ? target.seen->samples : 0));
  if (target.seen) {
    const AzimuthElevation gaze = azimuth_elevation(target.seen->mean_gaze);
    row.bind(7, degrees(gaze.azimuth_rad));
    row.bind(8, degrees(gaze.elevation_rad));
    bind_figures(row, 9, target.seen->figures);
  }
  row.exec();
}

}  // namespace

void insert_gaze_runs(SQLite::Database& database, std::int64_t session, std::int64_t sequence,
                      const std::vector<GazeRun>& runs) {
  for (const GazeRun& run : runs) {
    insert_run(database, session, sequence, run);
    for (std::size_t i = 0; i < run.quality.targets.size(); ++i) {
      insert_target(database, session, i, run.quality.targets[i]);
    }
  }
}

}  // namespace foveola::study
