// Whether a study is gone on with by the protocol that it was begun with.
#pragma once

#include <filesystem>
#include <optional>

#include "study/protocol/protocol.h"
#include "study/record/setup/amendment_note.h"

namespace SQLite {
class Database;
}

namespace foveola::study {

/// What to do with another text of a study's protocol.
enum class OtherProtocol { refuse, take_as_amendment };

/// Throws Error, about the study at `path`, if it was begun with another protocol, other files of
/// its methods, or other profiles or ready questionnaires: all by their hashes. An amendment, which
/// is returned if there is one, may have other words and time-outs, but not another design.
std::optional<Amendment> require_same_protocol(SQLite::Database& database,
                                               const std::filesystem::path& path,
                                               const Protocol& protocol,
                                               OtherProtocol other = OtherProtocol::refuse);

}  // namespace foveola::study
