#include "analysis/python/study_frames.h"

#include <numeric>
#include <optional>
#include <type_traits>
#include <variant>
#include <vector>

#include <pybind11/stl.h>

#include "analysis/dataset/answer_data.h"
#include "analysis/dataset/dataset.h"
#include "analysis/dataset/trial_data.h"
#include "analysis/publication/analyze_study.h"
#include "analysis/tables/table.h"
#include "study/record/read/data_quality_records.h"
#include "study/record/read/study_records.h"

namespace py = pybind11;

namespace foveola::analysis {
namespace {

struct StudyData {
  study::Verification record;
  study::StudyRecords records;
  std::optional<study::StudyRecords> with_withdrawn;  ///< if requested
  study::DataQualityRecords quality;
  Dataset set;
};

StudyData read(const std::filesystem::path& file, const StudyChoices& choices) {
  const py::gil_scoped_release unlocked;
  StudyData data;
  data.record = verified_study(file, choices.unverified);
  data.records = study::read_study(file);
  if (choices.withdrawn) {
    data.with_withdrawn = study::read_study(file, study::WithdrawnSessions::with_data);
  }
  data.quality = study::read_data_quality(file);
  data.set = select_for_analysis(data.records);
  data.set.record = data.record.faults.empty() ? "verified" : "changed";
  return data;
}

/// Returns pandas's types with missing values.
const char* dtype_of(ColumnType type) {
  switch (type) {
    case ColumnType::whole:
      return "Int64";
    case ColumnType::number:
      return "float64";
    case ColumnType::truth:
      return "boolean";
    case ColumnType::text:
      break;
  }
  return "string";
}

py::object python_of(const Field& field) {
  return std::visit(
      [](const auto& value) -> py::object {
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::monostate>) {
          return py::none();
        } else {
          return py::cast(value);
        }
      },
      field);
}

template <typename Item>
py::object frame_of(const ColumnsOf<Item>& columns_of_items, const std::vector<Item>& items,
                    const Dataset& set) {
  const std::vector<Column> columns = columns_in(columns_of_items);
  require_distinct_names(columns);
  std::vector<py::list> values(columns.size());
  for (const Item& item : items) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      values[i].append(python_of(columns_of_items[i].value(item)));
    }
  }
  const py::module_ pandas = py::module_::import("pandas");
  py::dict series;
  py::dict units;
  py::dict meanings;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const py::str name(columns[i].name);
    series[name] = pandas.attr("Series")(values[i], py::arg("dtype") = dtype_of(columns[i].type));
    units[name] = columns[i].unit;
    meanings[name] = columns[i].description;
  }
  py::object frame = pandas.attr("DataFrame")(series);
  frame.attr("attrs") =
      py::dict(py::arg("participant_kind") = set.kind, py::arg("record") = set.record,
               py::arg("units") = units, py::arg("meanings") = meanings);
  return frame;
}

std::vector<std::size_t> numbers_below(std::size_t count) {
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
}

}  // namespace

py::dict study_frames(const std::filesystem::path& file, const StudyChoices& choices) {
  const StudyData data = read(file, choices);
  const study::StudyRecords& exported = data.with_withdrawn ? *data.with_withdrawn : data.records;
  std::vector<std::size_t> last_timings;
  std::vector<std::size_t> other_timings;
  for (std::size_t i = 0; i < exported.trials.size(); ++i) {
    (exported.trials[i].counts ? last_timings : other_timings).push_back(i);
  }
  const auto trials = trial_columns(exported, data.set, data.quality.gaze);
  py::dict frames;
  frames["trials"] = frame_of(trials, last_timings, data.set);
  frames["trials_timed_again"] = frame_of(trials, other_timings, data.set);
  frames["answers"] = frame_of(answer_columns(exported, data.set), exported.answers, data.set);
  frames["participants"] = frame_of(participant_columns(data.records, data.set),
                                    numbers_below(data.set.participants.size()), data.set);
  return frames;
}

}  // namespace foveola::analysis
