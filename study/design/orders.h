// Latin and Williams squares: orders that are balanced by construction.
#pragma once

#include <vector>

#include "study/protocol/protocol.h"

namespace foveola::study {

/// A permutation of 0 ... n-1.
using Permutation = std::vector<int>;

/// Rows with each of n items once, in which each item is equally often at each position.
using Square = std::vector<Permutation>;

/// Returns the cyclic Latin square of n rows: the first counts up, each next one begins one later.
/// n > 0.
Square cyclic_square(int n);

/// Returns a square in which each item also precedes each other one equally often (Williams 1949,
/// "Experimental designs balanced for the estimation of residual effects of treatments"). It has n
/// rows for an even n. For an odd n it has 2n, and the second half mirrors the first. Either half
/// is a Latin square. n > 0.
Square williams_square(int n);

/// Returns the number of rows of `order` for n items; 0 for random orders, which have no rows.
int row_count(Order order, int n);

/// Returns permutation `row` of `order`, modulo their number. Not for random orders. row >= 0.
Permutation row_of(Order order, int n, int row);

/// Returns the order of n methods in scene `scene` for a participant's row. Scenes begin at
/// different rows, and rename the methods cyclically, so that the imbalance of an incomplete set of
/// rows differs between scenes. After any number of rows, each method's counts at the positions of
/// a scene differ by at most one; with three methods, so do its counts over all scenes. Five scenes
/// and three methods of a Williams square begin at rows 0, 0, 0, 3, 3 and rename by 0, 1, 2, 0, 1.
/// Not for random orders. scene, row >= 0.
Permutation crossed_row_of(Order order, int n, int scene, int row);

}  // namespace foveola::study
