// An eye tracker of one's own: lines on standard input, with azimuth and elevation of the gaze in
// degrees of the head's axes, or a word while it is lost. FV follows it until the lines end.
//   some_device | spoken_gaze SCENE IMAGE.png
#include <array>
#include <cstdio>
#include <iostream>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "renderer/base/angles.h"
#include "renderer/image/image_file.h"
#include "renderer/preview/preview.h"
#include "renderer/progressive/loaded_scene.h"
#include "scenes/find_scene.h"

using namespace foveola;

namespace {

class SpokenGaze final : public EyeTracker {
 public:
  explicit SpokenGaze(const Clock& clock) : reader_([this, &clock] { read(clock); }) {}

  void poll(Nanoseconds /*now*/, std::vector<GazeSample>& arrived) override {
    const std::lock_guard lock(mutex_);
    arrived.insert(arrived.end(), waiting_.begin(), waiting_.end());
    waiting_.clear();
  }
  std::string status() const override {
    const std::lock_guard lock(mutex_);
    return has_ended_ && waiting_.empty() ? "standard input has ended" : "";
  }

 private:
  void read(const Clock& clock) {
    for (std::string line; std::getline(std::cin, line);) {
      GazeSample sample{.time = clock.now()};
      std::array<double, 2> gaze_deg{};
      sample.valid = bool(std::istringstream(line) >> gaze_deg[0] >> gaze_deg[1]);
      sample.direction = direction_from({radians(gaze_deg[0]), radians(gaze_deg[1])});
      const std::lock_guard lock(mutex_);
      waiting_.push_back(sample);
    }
    const std::lock_guard lock(mutex_);
    has_ended_ = true;
  }

  mutable std::mutex mutex_;
  std::vector<GazeSample> waiting_;
  bool has_ended_ = false;
  std::jthread reader_;  // the last member: it begins when the others are there
};

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 3) {
    throw std::invalid_argument("give a scene and the name of an image");
  }
  const Workers workers;
  const LoadedScene loaded(scenes::find_scene(argv[1]), workers);
  const SteadyClock clock;
  SpokenGaze eye(clock);
  SimulatedHeadTracker head([&](Nanoseconds) { return loaded.camera.heading; });
  Preview preview(loaded.tracer, {.render = loaded.rendered_with({})}, eye, head, workers);
  preview.restart("fv", 1);
  std::array<int, 2> frames{};  // with the gaze lost, and tracked
  do {
    ++frames[preview.render_frame(clock.now(), 20'000).gaze_valid ? 1 : 0];
  } while (eye.status().empty());
  write_film_image(argv[2], preview.film().resolve(), 0.0);
  std::printf("%s: the gaze was tracked in %d frames and lost in %d\n", argv[2], frames[1],
              frames[0]);
} catch (const std::exception& error) {
  std::fprintf(stderr, "spoken_gaze: error: %s\n", error.what());
  return 1;
}
