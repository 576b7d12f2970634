# Makes of the comment above #pragma once, which says why a header exists, Doxygen's comment of the
# file; each line stays where it is.
0,/^#pragma once/{
1s|^// *|/*! @brief |
s|^// *||
s|^#pragma once|@file */|
}
