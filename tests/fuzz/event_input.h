// One input of the events' fuzzer: an event of a study's log, as a file that was built to do harm
// might have it.
#pragma once

#include <string_view>

namespace foveola::test {

/// Reads `input` as an event: its type, a line break, its payload. Returns false if that is refused
/// with std::invalid_argument, as events are that cannot be read. Throws std::logic_error if what
/// is written of the event is another event.
bool read_event_input(std::string_view input);

}  // namespace foveola::test
