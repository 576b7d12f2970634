// Claims: figures in documents, the commands that reproduce them, and their tolerances.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/replication/bench_ratios.h"
#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

/// A number, with its 95 % confidence interval if it has one.
struct ClaimValue {
  double value = 0.0;
  std::optional<Interval> interval{};
};

struct ClaimedNumber {
  std::string shown;  ///< as in the document: "734 700", "51 [34, 75]"
  ClaimValue claimed;
  std::string figure;  ///< its expression in the stage's figures; empty if no command reproduces it
};

/// Maximum deviation from the claimed number: the sum of these.
struct Tolerance {
  double absolute = 0.0;
  double relative = 0.0;         ///< to the claimed number
  double standard_errors = 0.0;  ///< of the difference, by the intervals of both
};

/// A text of a document, and its numbers.
struct Claim {
  std::string id;
  std::string place;  ///< "data/claims.toml:12:1"
  std::string document;
  std::vector<std::string> words;  ///< before, between and after the numbers
  std::vector<ClaimedNumber> numbers;
  Tolerance tolerance;
  int line = 0;  ///< line of the text's beginning in the file of claims
};

/// Commands, and the claims about their figures.
struct ClaimStage {
  std::string id;
  std::vector<std::string>
      run;               ///< the program's commands; empty if no command reproduces the numbers
  std::string result;    ///< JSON file in the stage's folder; empty: the last command's output
  std::string needs;     ///< required equipment that few machines have, or the source of numbers
                         ///< without a command
  double minutes = 0.0;  ///< duration on two cores
  bool is_quick = false;
  std::vector<Claim> claims;
};

struct Claims {
  std::filesystem::path file;  ///< relative to the folder from which documents are named
  std::string sha256;          ///< of the file without the claimed numbers
  std::vector<ClaimStage> stages;
};

/// Throws Error with the place of the fault, such as a claim without a tolerance.
Claims read_claims(const std::filesystem::path& file);

/// Returns a line per claim whose text, with its numbers, is not exactly once in its document.
std::vector<std::string> faults_of_documents(const Claims& claims);

/// Formats `value` like `shown`: decimals, blanks between thousands, an interval.
std::string shown_like(const std::string& shown, const ClaimValue& value);

/// Returns whether `made` deviates from the claimed number by at most the tolerance, plus half a
/// unit of the last shown digit. Without an interval, `made` has a standard error of 0.
bool is_within(const Tolerance& tolerance, const ClaimedNumber& number, const ClaimValue& made);

struct JudgedNumber {
  std::optional<ClaimValue> value{};  ///< empty if the results lack the claim's figure
  std::string remark;  ///< the value with more digits, or the reason why there is none
  bool is_outside = false;
};

/// Evaluates the number's figure, from left to right: places of `figures` (patterns in which * is
/// any text; after "min " or "max " the minimum or maximum match) and numbers, joined by " * " and
/// " / ". Its interval is evaluated from the limits of theirs.
JudgedNumber judge(const ClaimedNumber& number, const Tolerance& tolerance,
                   const std::vector<BenchFigure>& figures);

/// New values of a claim's numbers, in their order.
struct NewValues {
  const Claim* claim = nullptr;
  std::vector<ClaimValue> values{};
};

/// Writes the values into the documents and into the file of claims. Throws Error for a claim that
/// is not in its document.
void write_values(const Claims& claims, const std::vector<NewValues>& made);

}  // namespace foveola::analysis
