// Which source the program is of.
#pragma once

namespace foveola::study {

/// The commit that was checked out, as 12 digits; empty outside of the source's repository.
const char* source_commit();

}  // namespace foveola::study
