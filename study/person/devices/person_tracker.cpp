#include "study/person/devices/person_tracker.h"

#include <span>
#include <utility>

namespace foveola::study {

void PersonTracker::poll(Nanoseconds now, std::vector<GazeSample>& arrived) {
  if (std::exchange(repeats_newest_, false) && newest_valid_) {
    arrived.push_back(*newest_valid_);
  }
  const std::size_t known = arrived.size();
  source_->poll(now, arrived);
  if (arrived.size() > known || !last_arrival_) {
    last_arrival_ = now;
  }
  is_lost_ = !source_->status().empty() || now - *last_arrival_ > longest_silence;
  const std::span<GazeSample> fresh = std::span(arrived).subspan(known);
  if (correction_) {
    foveola::correct(fresh, *correction_);
  }
  for (const GazeSample& sample : fresh) {
    if (sample.valid) {
      newest_valid_ = sample;
    }
  }
}

}  // namespace foveola::study
