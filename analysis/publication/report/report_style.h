// The report's style sheet: light and dark, screen and print.
#pragma once

#include <string_view>

namespace foveola::analysis {

std::string_view report_style();

}  // namespace foveola::analysis
