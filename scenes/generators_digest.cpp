#include "scenes/generators_digest.h"

namespace foveola::scenes {

const char* generators_digest() { return FOVEOLA_GENERATORS_DIGEST; }

}  // namespace foveola::scenes
