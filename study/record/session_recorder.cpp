#include "study/record/session_recorder.h"

namespace foveola::study {

std::future<void> already_recorded() {
  std::promise<void> recorded;
  recorded.set_value();
  return recorded.get_future();
}

}  // namespace foveola::study
