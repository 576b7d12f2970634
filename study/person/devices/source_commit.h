// Names the commit that the program was built from.
#pragma once

namespace foveola::study {

/// Returns the first 12 hexadecimal digits of the commit's hash; empty if built outside a
/// repository. Uncommitted changes are not visible in it.
const char* source_commit();

}  // namespace foveola::study
