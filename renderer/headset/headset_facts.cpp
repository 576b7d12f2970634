#include "renderer/headset/headset_facts.h"

namespace foveola {

DisplayProfile told_by(const HeadsetFacts& facts, DisplayProfile profile) {
  profile.title = facts.headset + ", by " + facts.runtime;
  profile.width_px = facts.eye_px.front().x;
  profile.height_px = facts.eye_px.front().y;
  profile.refresh_rate_hz = facts.refresh_rate_hz;
  profile.horizontal_fov_deg = facts.both.horizontal_deg;
  profile.vertical_fov_deg = facts.both.vertical_deg;
  profile.lens = facts.both.lens;
  profile.seen = facts.both.seen;
  profile.scan_out = {.duration_s = seconds(facts.display_delay),
                      .provenance = Provenance::assumed};
  return profile;
}

}  // namespace foveola
