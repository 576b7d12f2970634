#include "study/person/person_tracker.h"

#include <span>

namespace foveola::study {

void PersonTracker::poll(Nanoseconds now, std::vector<GazeSample>& arrived) {
  const std::size_t known = arrived.size();
  source_->poll(now, arrived);
  if (arrived.size() > known || !last_arrival_) {
    last_arrival_ = now;
  }
  is_lost_ = !source_->trouble().empty() || now - *last_arrival_ > longest_silence;
  if (correction_) {
    foveola::correct(std::span(arrived).subspan(known), *correction_);
  }
}

}  // namespace foveola::study
