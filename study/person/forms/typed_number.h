// Numbers as people type them: with a decimal comma or point, and with commas or points between
// thousands.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace foveola::study {

/// Every number that `typed`, of ASCII characters, may mean: none if it is not a number, two where
/// its only separator may stand before decimals or thousands. Of "1,500" these are 1.5 and 1500.
std::vector<double> readings_of(std::string_view typed);

/// The number as it has to be typed to have one reading: 1.125 as "1.1250".
std::string unambiguous(double number, char decimal_mark = '.');

}  // namespace foveola::study
