// Effects that are put into a simulated study on purpose, so that it is known what an analysis has
// to find.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace foveola::study {

/// Participants with an injected effect do not look at pictures: their times are drawn (see
/// drawn_times.h), the same for all methods but for what is injected.
struct InjectedEffect {
  struct Outlier {
    int participant = 1;  ///< the first is 1
    double slower = 1.0;  ///< this factor is in all of that participant's times
  };
  std::map<std::string, double> faster;  ///< a method's times are divided by this
  double order_factor = 1.0;             ///< times grow by it with every trial before
  std::optional<Outlier> outlier;
  double dropout_part = 0.0;       ///< how many participants withdraw, at any trial but the first
  double tracker_loss_part = 0.0;  ///< how much of its data the eye tracker loses
};

/// Of "none" or any of "faster:METHOD:FACTOR", "order:FACTOR", "outlier:PARTICIPANT:FACTOR",
/// "dropout:PART" and "tracker-loss:PART" with commas between them; factors are positive, parts in
/// [0, 1], only "faster" may be there more than once, for different methods. METHOD may have colons
/// in it. Throws UsageError.
InjectedEffect parse_injected_effect(const std::string& text);

/// What parse_injected_effect() takes, for the command line's help.
inline constexpr const char* injected_effect_help =
    "participants with a known effect, whose times, of any marks, and ratings are drawn and not "
    "seen: none, or "
    "any of faster:METHOD:FACTOR, order:FACTOR (with every trial), outlier:PARTICIPANT:FACTOR "
    "(slower), dropout:PART (of participants), tracker-loss:PART (of samples), with commas between";

/// Throws UsageError if one of the effects is of a method that is none of `methods`.
void require_methods(const InjectedEffect& effect, const std::vector<std::string>& methods);

}  // namespace foveola::study
