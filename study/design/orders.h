// Rows of orders that are balanced by construction.
#pragma once

#include <vector>

#include "study/protocol/protocol.h"

namespace foveola::study {

/// A permutation of 0 ... n-1.
using Permutation = std::vector<int>;

/// Each of n things once in each row; together, equally often at each position.
using Square = std::vector<Permutation>;

/// n rows: the first counts up, each further one begins one later. n > 0.
Square cyclic_square(int n);

/// Each thing also precedes each other one equally often (Williams 1949, "Experimental designs
/// balanced for the estimation of residual effects of treatments"). n rows for an even n; for an
/// odd one 2n, of which the second half is the first one's mirror image. Either half is a Latin
/// square. n > 0.
Square williams_square(int n);

/// How many rows `order` has for n things; 0 for random ones, of which there is no list.
int row_count(Order order, int n);

/// Permutation `row` of `order`, modulo their number. Not for random ones. row >= 0.
Permutation row_of(Order order, int n, int row);

/// The order of n methods in scene `scene` for a participant's row: scenes begin at other rows, and
/// call the methods otherwise, so that what one scene's rows still lack when participants run out
/// is not lacked by the next one too. Of the first so many rows, however many, each method stands
/// at each position in each scene equally often but for one; over all scenes together it does so
/// too if there are three methods. Five scenes and three methods of a Williams square begin at rows
/// 0, 0, 0, 3, 3 and rename by 0, 1, 2, 0, 1. Not for random orders. scene, row >= 0.
Permutation crossed_row_of(Order order, int n, int scene, int row);

}  // namespace foveola::study
