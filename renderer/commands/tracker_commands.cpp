#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "renderer/base/angles.h"
#include "renderer/base/clock.h"
#include "renderer/base/text/print.h"
#include "renderer/base/transformed.h"
#include "renderer/commands/commands.h"
#include "renderer/gaze/gaze_quality.h"
#include "renderer/gaze/gaze_source.h"
#include "renderer/gaze/hid/hid_device.h"
#include "renderer/gaze/profiles.h"

namespace foveola {
namespace {

using Json = nlohmann::ordered_json;

// --- list ---

std::vector<TrackerProfile> profiles() {
  return transformed(tracker_profile_names(),
                     [&](const std::string& name) { return read_tracker_profile(name); });
}

void print_list_json(const std::vector<HidDeviceInfo>& devices) {
  const Json attached(transformed(devices, [&](const HidDeviceInfo& device) {
    return Json{{"path", device.path},
                {"vendor_id", device.vendor_id},
                {"product_id", device.product_id},
                {"manufacturer", device.manufacturer},
                {"product", device.product},
                {"serial_number", device.serial_number}};
  }));
  const Json known(transformed(profiles(), [&](const TrackerProfile& profile) {
    return Json{{"name", profile.name},
                {"title", profile.title},
                {"source", name_of(profile.source)},
                {"rate_hz", profile.rate_hz}};
  }));
  const Json json = {{"attached", attached}, {"profiles", known}};
  // Devices may report invalid UTF-8.
  print_text("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
}

void print_list(const std::vector<HidDeviceInfo>& devices) {
  if (devices.empty()) {
    print_text("No HID eye tracker is attached.\n");
  }
  for (const HidDeviceInfo& device : devices) {
    print_text("{}  {:04x}:{:04x}  {} {} {}\n", device.path, device.vendor_id, device.product_id,
               device.manufacturer, device.product, device.serial_number);
  }
  print_text("Profiles, for tracker watch:\n");
  for (const TrackerProfile& profile : profiles()) {
    print_text("  {:<12} {:<10} {:>4.0f} Hz  {}\n", profile.name, name_of(profile.source),
               profile.rate_hz, profile.title);
  }
}

// --- watch ---

struct WatchArguments {
  std::string tracker = "hid";
  std::string display = "desktop";
  double seconds = 0.0;
  bool json = false;
};

/// "azimuth  12.30 elevation  -3.10", or the reason for missing gaze.
std::string describe(const std::optional<GazeSample>& sample, const std::string& status) {
  if (!status.empty()) {
    return status;
  }
  if (!sample) {
    return "no sample yet";
  }
  if (!sample->valid) {
    return "the eyes are not seen";
  }
  const AzimuthElevation gaze = azimuth_elevation(sample->direction);
  return fmt::format("azimuth {:6.2f}  elevation {:6.2f}", degrees(gaze.azimuth_rad),
                     degrees(gaze.elevation_rad));
}

std::string describe(const InterSampleIntervals& intervals) {
  return fmt::format("{:6.1f} Hz  jitter {:5.2f} ms  {} gaps  {} of {} valid",
                     intervals.rate_hz().value_or(0.0), intervals.jitter_ms().value_or(0.0),
                     intervals.gaps(), intervals.valid_samples(), intervals.samples());
}

/// On a terminal each line replaces the one before; elsewhere it follows.
class LiveLine {
 public:
  ~LiveLine() {
    if (is_terminal_) {
      print_text("\n");
    }
  }
  void show(const std::string& text) const {
    if (is_terminal_) {
      std::fputs("\r", stdout);
      print_text("{:<100}", text);
    } else {
      print_text("{}\n", text);
    }
    std::fflush(stdout);
  }

 private:
  bool is_terminal_ = ::isatty(STDOUT_FILENO) == 1;
};

Json json_of(const InterSampleIntervals& intervals, const std::string& tracker,
             const std::string& status) {
  Json json = {{"tracker", tracker},
               {"samples", intervals.samples()},
               {"valid_samples", intervals.valid_samples()},
               {"gaps", intervals.gaps()},
               {"rate_hz", nullptr},
               {"jitter_ms", nullptr},
               {"status", status}};
  if (intervals.rate_hz()) {
    json["rate_hz"] = *intervals.rate_hz();
    json["jitter_ms"] = *intervals.jitter_ms();
  }
  return json;
}

void watch(const WatchArguments& arguments, const std::stop_token& stop) {
  constexpr std::chrono::milliseconds poll_interval{1};
  constexpr Nanoseconds show_interval = std::chrono::milliseconds(250);
  const SteadyClock clock;
  const auto tracker = open_eye_tracker(read_tracker_profile(arguments.tracker),
                                        screen_of(read_display_profile(arguments.display)), clock);
  const std::optional<LiveLine> line =
      arguments.json ? std::nullopt : std::optional<LiveLine>(std::in_place);
  InterSampleIntervals intervals;
  std::vector<GazeSample> arrived;
  std::optional<GazeSample> newest;
  const Nanoseconds start = clock.now();
  Nanoseconds shown = start;
  const auto is_over = [&](Nanoseconds now) {
    return arguments.seconds > 0.0 && seconds(now - start) >= arguments.seconds;
  };
  for (Nanoseconds now = start; !stop.stop_requested() && !is_over(now); now = clock.now()) {
    arrived.clear();
    tracker->poll(now, arrived);
    for (const GazeSample& sample : arrived) {
      intervals.add(sample);
      newest = sample;
    }
    if (line && now - shown >= show_interval) {
      shown = now;
      const double age_ms = newest ? 1e3 * seconds(now - newest->time) : 0.0;
      line->show(fmt::format("{:<36} age {:5.1f} ms  {}", describe(newest, tracker->status()),
                             age_ms, describe(intervals)));
    }
    std::this_thread::sleep_for(poll_interval);
  }
  if (arguments.json) {
    print_text("{}\n", json_of(intervals, arguments.tracker, tracker->status())
                           .dump(2, ' ', false, Json::error_handler_t::replace));
  }
}

void add_list(CLI::App& tracker) {
  const auto as_json = std::make_shared<bool>(false);
  CLI::App* command = tracker.add_subcommand(
      "list", "List the eye trackers attached over USB (HID), and the profiles that can be used");
  command->add_flag("--json", *as_json, "Print it as JSON");
  command->footer("Example: foveola tracker list");
  command->callback([as_json] {
    const std::vector<HidDeviceInfo> devices = list_hid_eye_trackers();
    *as_json ? print_list_json(devices) : print_list(devices);
  });
}

void add_watch(CLI::App& tracker, const std::stop_token& stop) {
  const auto arguments = std::make_shared<WatchArguments>();
  CLI::App* command =
      tracker.add_subcommand("watch", "Show the gaze, and the regularity of its samples");
  command->add_option("TRACKER", arguments->tracker, "A profile's name or file (see tracker list)");
  command->add_option("--display", arguments->display,
                      "The display before the eyes: a profile's name or file");
  command
      ->add_option("--seconds", arguments->seconds, "End after this many seconds (0: with Ctrl-C)")
      ->check(CLI::Range(0.0, 86400.0));
  command->add_flag("--json", arguments->json, "Print only the summary at the end, as JSON");
  command->footer("Example: foveola tracker watch simulated --seconds 5");
  command->callback([arguments, stop] { watch(*arguments, stop); });
}

}  // namespace

void add_tracker_commands(CLI::App& app, const std::stop_token& stop) {
  CLI::App* tracker =
      app.add_subcommand("tracker", "List the eye trackers attached, and watch what one measures");
  tracker->require_subcommand(1);
  add_list(*tracker);
  add_watch(*tracker, stop);
}

}  // namespace foveola
