// What to do with a damaged study.
#pragma once

namespace foveola::study {

/// A log or journal would change whatever file comes to lie beside it.
inline constexpr const char* damage_remedy =
    "put a copy in the study's place by foveola study restore, which moves its -wal and -journal "
    "aside with it: beside a copy they would change that";

}  // namespace foveola::study
