#include "analysis/publication/exports/bids_eye_tracking.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analysis/publication/data_quality/gaze_sources.h"
#include "analysis/publication/exports/bids.h"
#include "renderer/base/angles.h"
#include "renderer/base/clock.h"
#include "renderer/gaze/eye_movements.h"

namespace foveola::analysis {
namespace {

using SidecarJson = nlohmann::ordered_json;

std::string sidecar(const SidecarJson& json) {
  return json.dump(2, ' ', false, SidecarJson::error_handler_t::replace) + "\n";
}

/// Returns the sampling frequency in hertz over the whole recording; empty if its duration is zero.
std::optional<double> sampling_frequency(const std::vector<GazeSample>& samples) {
  const Nanoseconds lasting = samples.back().time - samples.front().time;
  if (lasting <= Nanoseconds(0)) {
    return std::nullopt;
  }
  return static_cast<double>(samples.size() - 1) / seconds(lasting);
}

std::string samples_tsv(const std::vector<GazeSample>& samples) {
  fmt::memory_buffer text;
  for (const GazeSample& sample : samples) {
    if (sample.valid) {
      const Vec3& to = sample.direction;
      fmt::format_to(std::back_inserter(text), "{}\t{:.5f}\t{:.5f}\n", sample.time.count(),
                     degrees(std::atan2(to.x, -to.z)),
                     degrees(std::asin(std::clamp(to.y, -1.0F, 1.0F))));
    } else {
      fmt::format_to(std::back_inserter(text), "{}\tn/a\tn/a\n", sample.time.count());
    }
  }
  return fmt::to_string(text);
}

SidecarJson column(const char* description, const char* units) {
  return {{"Description", description}, {"Units", units}};
}

SidecarJson timestamp_column() {
  SidecarJson json = column("Time of the sample, by the session's monotonic clock", "ns");
  json["Origin"] = "the clock of the computer that ran the session";
  return json;
}

std::string samples_json(const study::AttemptGaze& attempt, const std::string& tracker,
                         double frequency_hz, const std::optional<double>& accuracy_deg) {
  const Nanoseconds start =
      attempt.samples.front().time - attempt.first_frame.value_or(attempt.samples.front().time);
  SidecarJson json = {{"PhysioType", is_pointer(tracker) ? "generic" : "eyetrack"},
                      {"SamplingFrequency", frequency_hz},
                      {"StartTime", seconds(start)},
                      {"Columns", {"timestamp", "x_coordinate", "y_coordinate"}}};
  if (!is_pointer(tracker)) {
    json["RecordedEye"] = "cyclopean";
    json["SampleCoordinateSystem"] = "eye-in-head";
    if (accuracy_deg) {
      json["AverageCalibrationError"] = *accuracy_deg;
    }
  }
  json["timestamp"] = timestamp_column();
  json["x_coordinate"] = column("Azimuth of the gaze, rightwards from straight ahead", "deg");
  json["y_coordinate"] = column("Elevation of the gaze, upwards from straight ahead", "deg");
  // Keys without a name in BIDS.
  if (!tracker.empty()) {
    json["GazeSource"] = tracker_in_words(tracker);
  }
  json["StartTimeReference"] = "the first presented frame of the trial";
  json["Trial"] = {{"Position", attempt.trial},  {"Kind", attempt.trial_kind},
                   {"Scene", attempt.scene},     {"Method", attempt.method},
                   {"Attempt", attempt.attempt}, {"Outcome", attempt.outcome}};
  return sidecar(json);
}

struct EyeEvent {
  Nanoseconds onset{0};
  Nanoseconds duration{0};
  std::string type;
  std::string message;
};

const char* movement_name(GazeMark mark) {
  switch (mark) {
    case GazeMark::fixation:
      return "fixation";
    case GazeMark::saccade:
      return "saccade";
    case GazeMark::blink:
      return "blink";
    case GazeMark::none:
      break;
  }
  return "";
}

void add_movements(const std::vector<GazeSample>& samples, std::vector<EyeEvent>& events) {
  for (const MarkedMovement& movement : marked_movements(samples)) {
    if (movement.mark != GazeMark::none) {
      events.push_back(
          {movement.samples.front().time, movement.duration, movement_name(movement.mark), ""});
    }
  }
}

std::vector<EyeEvent> events_of(const study::AttemptGaze& attempt, const std::string& tracker) {
  std::vector<EyeEvent> events;
  if (attempt.first_frame) {
    events.push_back({*attempt.first_frame, Nanoseconds(0), "first_frame", ""});
  }
  for (const study::MarkedMoment& mark : attempt.marks) {
    events.push_back({mark.time, Nanoseconds(0), mark.censored ? "timed_out" : "mark", mark.mark});
  }
  if (!is_pointer(tracker)) {
    add_movements(attempt.samples, events);
  }
  std::ranges::stable_sort(events,
                           [](const EyeEvent& a, const EyeEvent& b) { return a.onset < b.onset; });
  return events;
}

std::string events_tsv(const std::vector<EyeEvent>& events) {
  std::string text;
  for (const EyeEvent& event : events) {
    text += fmt::format("{}\t{:.6f}\t{}\t{}\n", event.onset.count(), seconds(event.duration),
                        event.type, event.message.empty() ? "n/a" : event.message);
  }
  return text;
}

std::string events_json() {
  SidecarJson json = {
      {"Columns", {"onset", "duration", "trial_type", "message"}},
      {"Description", "The trial's first frame and marks, and the eye's movements during it"},
      {"OnsetSource", "timestamp"}};
  json["onset"] = timestamp_column();
  json["onset"]["Description"] = "Onset of the event, in the units of timestamp";
  json["duration"] = column("Duration of the event; 0 for instants", "s");
  json["trial_type"] = {{"Description", "Kind of event"},
                        {"Levels",
                         {{"first_frame", "the trial's first frame was presented"},
                          {"mark", "the participant marked what message names"},
                          {"timed_out", "the wait for the mark that message names ended"},
                          {"fixation", "an eye movement slower than a velocity threshold"},
                          {"saccade", "an eye movement faster than the same threshold"},
                          {"blink", "no valid gaze"}}}};
  json["message"] = {{"Description", "Id of the mark"}};
  return sidecar(json);
}

}  // namespace

EyeTrackingExport::EyeTrackingExport(const Dataset& set,
                                     const std::vector<study::GazeRunRow>& validations,
                                     const std::vector<study::AttemptGazeRow>& gaze) {
  for (const study::AttemptGazeRow& row : gaze) {
    trackers_[{row.participant, row.trial, row.attempt}] = row.tracker;
  }
  const std::vector<std::string> labels = bids_labels(set);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    subjects_[set.participants[i]].label = labels[i];
  }
  for (const study::GazeRunRow& run : validations) {
    const auto subject = subjects_.find(run.participant);
    if (subject != subjects_.end() && run.accuracy_deg) {
      subject->second.accuracy_deg = run.accuracy_deg;
    }
  }
}

std::vector<TextFile> EyeTrackingExport::export_attempt(const study::AttemptGaze& attempt) {
  const auto found = subjects_.find(attempt.participant);
  if (found == subjects_.end()) {
    return {};
  }
  const std::optional<double> frequency_hz = sampling_frequency(attempt.samples);
  if (!frequency_hz) {
    ++too_short_;
    return {};
  }
  Subject& subject = found->second;
  const auto known = trackers_.find({attempt.participant, attempt.trial, attempt.attempt});
  const std::string tracker = known == trackers_.end() ? "" : known->second;
  const std::string stem =
      fmt::format("bids/sub-{0}/beh/sub-{0}_task-preview_run-{1:02}_recording-{2}_physio",
                  subject.label, ++subject.runs, is_pointer(tracker) ? "mouse" : "eye1");
  std::vector<TextFile> files = {
      {stem + ".tsv.gz", gzip(samples_tsv(attempt.samples))},
      {stem + ".json", samples_json(attempt, tracker, *frequency_hz, subject.accuracy_deg)}};
  if (const std::vector<EyeEvent> events = events_of(attempt, tracker); !events.empty()) {
    has_events_ = true;
    files.push_back({stem + "events.tsv.gz", gzip(events_tsv(events))});
    files.push_back({stem + "events.json", events_json()});
  }
  return files;
}

std::optional<TextFile> EyeTrackingExport::bidsignore_file() const {
  if (!has_events_) {
    return std::nullopt;
  }
  return TextFile{"bids/.bidsignore",
                  "# These files are part of BIDS since 1.11, which validators that came before it "
                  "do not know, as\n"
                  "# the npm package bids-validator (1.x): they would refuse the names. Delete "
                  "this file before you\n"
                  "# run a validator that knows BIDS 1.11, so that it reads them, too.\n"
                  "*_physioevents.tsv.gz\n*_physioevents.json\n"};
}

}  // namespace foveola::analysis
