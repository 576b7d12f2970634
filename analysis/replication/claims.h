// The claims: the figures that documents state, which command makes each, and how far what is made
// may lie from what is stated.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/replication/bench_ratios.h"
#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

/// A number, with its 95 % confidence interval where it has one.
struct ClaimValue {
  double value = 0.0;
  std::optional<Interval> interval{};
};

struct ClaimedNumber {
  std::string shown;  ///< as the document has it: "734 700", "51 [34, 75]"
  ClaimValue claimed;
  std::string figure;  ///< what makes it, of the stage's figures; empty if no command does
};

/// How far a number may lie from the claimed one: the sum of these.
struct Tolerance {
  double absolute = 0.0;
  double relative = 0.0;         ///< to the claimed number
  double standard_errors = 0.0;  ///< of the difference, by the intervals of both
};

/// A text of a document, and the numbers in it.
struct Claim {
  std::string id;
  std::string place;  ///< "data/claims.toml:12:1"
  std::string document;
  std::vector<std::string> words;  ///< before, between and behind the numbers
  std::vector<ClaimedNumber> numbers;
  Tolerance tolerance;
  int line = 0;  ///< in the file of claims, where the text begins
};

/// Commands, and the claims of their figures.
struct ClaimStage {
  std::string id;
  std::vector<std::string> run;  ///< the program's commands; none if no command makes the numbers
  std::string result;  ///< JSON file in the stage's folder; empty: what the last command prints
  std::string needs;   ///< what few machines have, or what makes the numbers in place of a command
  double minutes = 0.0;  ///< that it takes on two cores
  bool is_quick = false;
  std::vector<Claim> claims;
};

struct Claims {
  std::filesystem::path file;  ///< in a folder of that from which documents are named
  std::string sha256;          ///< of the file without the claimed numbers
  std::vector<ClaimStage> stages;
};

/// Throws Error with the place of what is wrong, such as a claim without a tolerance.
Claims read_claims(const std::filesystem::path& file);

/// A line for each claim whose text, with its numbers, does not stand in its document once.
std::vector<std::string> faults_of_documents(const Claims& claims);

/// `value` as `shown` is written: decimals, blanks between thousands, an interval.
std::string shown_like(const std::string& shown, const ClaimValue& value);

/// Whether `made` is as far from what is claimed as the tolerance, and half a unit of the last
/// digit that is shown, at most. Without an interval, `made` has a standard error of 0.
bool is_within(const Tolerance& tolerance, const ClaimedNumber& number, const ClaimValue& made);

/// What was made of a claimed number.
struct JudgedNumber {
  std::optional<ClaimValue> value{};  ///< none if the results do not have the claim's figure
  std::string remark;                 ///< the value with more digits, or why there is none
  bool is_outside = false;
};

/// Evaluates the number's figure: places of `figures` (patterns in which * is any text; after "min
/// " or "max " the least or greatest match) and numbers, between " * " and " / ", from left to
/// right. Its interval is evaluated from both ends of theirs.
JudgedNumber judge(const ClaimedNumber& number, const Tolerance& tolerance,
                   const std::vector<BenchFigure>& figures);

/// New values of a claim's numbers, in their order.
struct NewValues {
  const Claim* claim = nullptr;
  std::vector<ClaimValue> values{};
};

/// Writes the values into the documents and into the file of claims. Throws Error for a claim that
/// its document does not state.
void write_values(const Claims& claims, const std::vector<NewValues>& made);

}  // namespace foveola::analysis
