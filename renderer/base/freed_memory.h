// What becomes of memory that the program frees.
#pragma once

namespace foveola {

/// From now on freed memory stays with the program, to be used again, where the C library can be
/// told so: for programs that load large files again and again, to which fresh pages cost more than
/// reading does. To be called before there are other threads.
void keep_freed_memory();

}  // namespace foveola
