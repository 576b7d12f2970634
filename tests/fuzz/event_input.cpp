#include "tests/fuzz/event_input.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "study/record/log/event_json.h"

namespace foveola::test {

bool read_event_input(std::string_view input) {
  const std::size_t end = std::min(input.find('\n'), input.size());
  const std::string type(input.substr(0, end));
  const std::string payload(input.substr(std::min(end + 1, input.size())));
  std::string written;
  try {
    written = study::payload_of(study::event_from(type, payload));
  } catch (const std::invalid_argument&) {
    return false;
  }
  std::string again;
  try {
    again = study::payload_of(study::event_from(type, written));
  } catch (const std::invalid_argument& refusal) {
    throw std::logic_error(std::string("what is written cannot be read: ") + refusal.what());
  }
  if (again != written) {
    throw std::logic_error("what is written is another event");
  }
  return true;
}

}  // namespace foveola::test
