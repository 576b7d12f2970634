// Parses numbers as people type them: with a decimal comma or point, and separated thousands.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace foveola::study {

/// Returns every number that `typed`, of ASCII characters, may mean. Empty if it is not a number;
/// two if its only separator may precede decimals or thousands: 1.5 and 1500 for "1,500".
std::vector<double> readings_of(std::string_view typed);

/// Returns the number in a spelling with one reading: 1.125 as "1.1250".
std::string unambiguous(double number, char decimal_mark = '.');

}  // namespace foveola::study
