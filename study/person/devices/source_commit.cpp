#include "study/person/devices/source_commit.h"

namespace foveola::study {

const char* source_commit() { return FOVEOLA_COMMIT; }

}  // namespace foveola::study
