// Effects injected into simulated studies, to test whether analyses find them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace foveola::study {

/// Participants with an injected effect do not look at images. Their times and ratings are drawn
/// (see drawn_trial.h), from one distribution for all methods except for the injected effects.
struct InjectedEffect {
  /// A number per method, by the id of a mark or a rating.
  using ByMethod = std::map<std::string, double>;

  struct Outlier {
    int participant = 1;  ///< Number of the participant; the first is 1.
    double slower = 1.0;  ///< Factor on all of that participant's times.
  };
  ByMethod faster;  ///< A method's times are divided by its number.
  /// A method's times of one mark are divided by its number as well.
  std::map<std::string, ByMethod> faster_marks;
  /// A method's answers to a rating are higher by its number of points.
  std::map<std::string, ByMethod> shifted_ratings;
  double order_factor = 1.0;  ///< Factor on times per trial.
  std::optional<Outlier> outlier;
  double dropout_part = 0.0;  ///< Fraction of participants who withdraw, after the first trial.
  double tracker_loss_part = 0.0;  ///< Fraction of its samples that the eye tracker loses.
};

/// Parses "none" or a comma-separated list of "faster:METHOD:FACTOR",
/// "faster-mark:MARK:METHOD:FACTOR", "shift-rating:RATING:METHOD:POINTS", "order:FACTOR",
/// "outlier:PARTICIPANT:FACTOR", "dropout:FRACTION" and "tracker-loss:FRACTION". Factors are
/// positive, fractions in [0, 1], points may be negative. The first three may be repeated, each for
/// different methods, marks or ratings. METHOD may contain colons. Throws UsageError.
InjectedEffect parse_injected_effect(const std::string& text);

/// Help of the option that takes an injected effect.
inline constexpr const char* injected_effect_help =
    "Draw times and ratings from a model with known effects, instead of judging images: none "
    "(judge images), or, separated by commas, faster:METHOD:FACTOR (divides the method's times of "
    "all marks), faster-mark:MARK:METHOD:FACTOR (divides those of one mark), "
    "shift-rating:RATING:METHOD:POINTS (adds to the method's answers to a rating, as "
    "shift-rating:comfort:fv:-10), order:FACTOR (multiplies times with every trial), "
    "outlier:PARTICIPANT:FACTOR (multiplies one participant's times), dropout:FRACTION (of "
    "participants), tracker-loss:FRACTION (of samples); order:1 draws without any effect";

}  // namespace foveola::study
