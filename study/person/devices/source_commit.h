// Names the commit that the program was built from.
#pragma once

namespace foveola::study {

/// Returns the commit as 12 digits; empty if built outside of a repository.
const char* source_commit();

}  // namespace foveola::study
