// An analysis of one's own: how many participants were sooner with each method than with the
// baseline, by the geometric mean of their ratios over scenes, and the exact sign test of that
// (Dixon and Mood 1946). Reads a study's file, and prints a line for each mark and method.
//   sign_test STUDY.sqlite
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "analysis/dataset/dataset.h"

using namespace foveola;

namespace {

/// The two-sided P-value of so many heads in so many tosses of a fair coin.
double sign_test(int heads, int tosses) {
  double tail = 0.0;
  for (int k = 0; k <= std::min(heads, tosses - heads); ++k) {
    tail += std::exp(std::lgamma(tosses + 1) - std::lgamma(k + 1) - std::lgamma(tosses - k + 1) -
                     tosses * std::log(2.0));
  }
  return std::min(1.0, 2.0 * tail);
}

/// The sum over scenes of the logarithm of a participant's time over the baseline's, of scenes in
/// which every method has a time; 0 if there are none.
double log_ratio(const analysis::Dataset& study, std::size_t participant, std::size_t method,
                 std::size_t mark) {
  double sum = 0.0;
  for (std::size_t scene = 0; scene < study.scenes.size(); ++scene) {
    if (study.is_complete(participant, scene, mark)) {
      sum += std::log(study.value(participant, scene, method, mark).number /
                      study.value(participant, scene, analysis::baseline, mark).number);
    }
  }
  return sum;
}

void print_tests(const char* file) {
  const analysis::Dataset study = analysis::select_for_analysis(study::read_study(file));
  std::printf("participants: %zu, %s\n", study.participants.size(), study.kind.c_str());
  for (const std::size_t mark : study.times()) {
    for (std::size_t method = 1; method < study.methods.size(); ++method) {
      int sooner = 0;
      int later = 0;
      for (std::size_t participant = 0; participant < study.participants.size(); ++participant) {
        const double ratio = log_ratio(study, participant, method, mark);
        sooner += ratio < 0.0 ? 1 : 0;
        later += ratio > 0.0 ? 1 : 0;
      }
      std::printf("%s, %s against %s: %d sooner, %d later, P = %.3g\n",
                  study.measures[mark].id().c_str(), study.methods[method].c_str(),
                  study.methods[analysis::baseline].c_str(), sooner, later,
                  sign_test(sooner, sooner + later));
    }
  }
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) {
    throw std::invalid_argument("give the file of a study");
  }
  print_tests(argv[1]);
} catch (const std::exception& error) {
  std::fprintf(stderr, "sign_test: error: %s\n", error.what());
  return 1;
}
