#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "analysis/commands/commands.h"
#include "analysis/dataset/wording.h"
#include "analysis/publication/exports/output_folder.h"
#include "analysis/publication/report/report_style.h"
#include "analysis/replication/bench_ratios.h"
#include "analysis/replication/claims.h"
#include "analysis/tables/html.h"
#include "analysis/tables/printed_table.h"
#include "renderer/base/clock.h"
#include "renderer/base/error.h"
#include "renderer/base/files/digest.h"
#include "renderer/base/files/files.h"
#include "renderer/base/text/print.h"
#include "renderer/base/text/similar_word.h"
#include "renderer/base/work/programs.h"
#include "renderer/base/work/work_scope.h"
#include "renderer/commands/bench_facts.h"

namespace fs = std::filesystem;

namespace foveola::analysis {
namespace {

using ResultJson = nlohmann::ordered_json;

struct ReplicateArguments {
  fs::path folder;
  fs::path claims;
  std::vector<std::string> only;
  std::vector<fs::path> from;
  bool quick = false;
  bool write = false;
  bool json = false;
};

struct StageResults {
  fs::path folder;
  const Claims& claims;
  std::stop_token stop;
  std::map<std::string, ResultJson> made{};  ///< by stage; without "result" if it failed

  /// Takes earlier results from this folder or another one. Throws Error for results of another
  /// version or of other claims.
  void take_kept(const fs::path& from) {
    for (const ClaimStage& stage : claims.stages) {
      const fs::path file = from / "stages" / (stage.id + ".json");
      if (made.contains(stage.id) || !fs::exists(file)) {
        continue;
      }
      ResultJson kept = ResultJson::parse(read_file(file), nullptr, false);
      if (!kept.is_object() || !kept.contains("result") ||
          kept["version"] != program_facts()["version"] ||
          kept["claims_sha256"] != ResultJson(claims.sha256)) {
        throw Error(file.string(), "is damaged, or was made by another version or for other claims",
                    "delete it, or name another folder");
      }
      keep(stage, kept);
    }
  }

  /// Makes the stages' missing results, until it is stopped.
  void make(std::vector<const ClaimStage*> stages) {
    std::erase_if(stages, [&](const ClaimStage* stage) { return made.contains(stage->id); });
    double minutes = 0.0;
    for (const ClaimStage* stage : stages) {
      minutes += stage->minutes;
    }
    Progress progress("Reproducing claims");
    double minutes_done = 0.0;
    for (const ClaimStage* stage : stages) {
      make(*stage, [&](double so_far) {
        progress.update((minutes_done + std::min(so_far, stage->minutes)) / minutes, stage->id);
      });
      minutes_done += stage->minutes;
    }
  }

  void keep(const ClaimStage& stage, const ResultJson& result) {
    made[stage.id] = result;
    fs::create_directories(folder / "stages");
    write_file(folder / "stages" / (stage.id + ".json"), result.dump(1) + "\n");
  }

  void make(const ClaimStage& stage, const std::function<void(double minutes)>& report) {
    const SteadyClock clock;
    const Nanoseconds start = clock.now();
    const auto minutes = [&] { return seconds(clock.now() - start) / 60.0; };
    const fs::path own_folder = fs::absolute(folder / "stages" / stage.id);
    fs::create_directories(own_folder);
    ProgramEnd end;
    for (auto run = stage.run.begin();
         run != stage.run.end() && end.status == 0 && !stop.stop_requested(); ++run) {
      auto running = std::async(std::launch::async, run_to_end, command(*run, own_folder));
      while (running.wait_for(std::chrono::milliseconds(200)) != std::future_status::ready) {
        report(minutes());
      }
      end = running.get();
    }
    if (stop.stop_requested()) {
      return;
    }
    const bool is_in_file = !stage.result.empty() && end.status == 0;
    const ResultJson result = ResultJson::parse(
        is_in_file ? read_file(own_folder / stage.result) : end.output, nullptr, false);
    const std::size_t error = std::min(end.errors.rfind("error: "), end.errors.size());
    const std::string complaint = end.errors.substr(error, end.errors.find('\n', error) - error);
    ResultJson facts = {{"stage", stage.id},
                        {"commands", fmt::format("{}", fmt::join(stage.run, "; "))},
                        {"complaint", complaint},
                        {"minutes_claimed", stage.minutes},
                        {"minutes", minutes()}};
    facts.update(bench_facts());
    facts["program_sha256"] = sha256_of_file(own_program());
    facts["claims_sha256"] = claims.sha256;
    if (result.is_discarded()) {
      made[stage.id] = facts;
      return;
    }
    facts["result"] = result;
    keep(stage, facts);
  }

  /// Returns a command of this program; {dir} at the beginning of a word is the stage's folder.
  Command command(const std::string& run, const fs::path& own_folder) const {
    Command command{.words = {own_program().string()}, .stop = stop};
    std::istringstream words(run);
    for (std::string word; words >> word;) {
      command.words.push_back(word.starts_with("{dir}") ? own_folder.string() + word.substr(5)
                                                        : word);
    }
    return command;
  }
};

/// The reproduced values beside the claims.
struct Replication {
  /// Tables by their titles, each a list of rows.
  ResultJson page = {{"Claims", ResultJson::array()}, {"Stages", ResultJson::array()}};
  std::vector<NewValues> made;                  ///< of the claims whose numbers were all reproduced
  std::map<std::string, std::size_t> verdicts;  ///< number of numbers per verdict

  /// result: null if the stage was not run.
  void add_stage(const ClaimStage& stage, ResultJson result) {
    std::vector<BenchFigure> figures;
    const bool is_made = result.contains("result");
    const bool has_failed = !result.is_null() && !is_made;
    std::string reason = stage.needs;
    if (is_made) {
      const auto is_text = [](std::string_view, const ResultJson& json) {
        return json.is_string();
      };
      collect_figures(result["result"], "", is_text, figures);
      result["result"] = sha256(result["result"].dump());
    } else if (has_failed) {
      result["result"] = "";
      reason += fmt::format(" ({})", result["complaint"].get<std::string>());
    }
    for (const Claim& claim : stage.claims) {
      NewValues values{&claim};
      const auto& [absolute, relative, errors] = claim.tolerance;
      for (const ClaimedNumber& number : claim.numbers) {
        const JudgedNumber judged =
            is_made
                ? judge(number, claim.tolerance, figures)
                : JudgedNumber{.remark = reason, .is_outside = has_failed && stage.needs.empty()};
        if (judged.value) {
          values.values.push_back(*judged.value);
        }
        const char* verdict = judged.is_outside ? "outside" : is_made ? "within" : "not made here";
        ++verdicts[verdict];
        page["Claims"].push_back(
            {{"claim", claim.id},
             {"document", claim.document},
             {"text", fmt::format("{}", fmt::join(claim.words, "…"))},
             {"claimed", number.shown},
             {"made", judged.value ? shown_like(number.shown, *judged.value) : ""},
             {"verdict", verdict},
             {"tolerance", fmt::format("{:g} + {:g} % + {:g} standard errors", absolute,
                                       100.0 * relative, errors)},
             {"remark", judged.remark}});
      }
      if (values.values.size() == claim.numbers.size()) {
        made.push_back(std::move(values));
      }
    }
    if (!result.is_null()) {
      page["Stages"].push_back(std::move(result));
    }
  }
};

std::string page_html(const ResultJson& page) {
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<title>Claims made again</title>\n<style>{}</style>\n</head>\n<body>\n<main>\n",
      report_style());
  for (const auto& [title, rows] : page.items()) {
    PrintedTable table{.title = title + ".", .is_numeric = false};
    for (const ResultJson& row : rows) {
      table.columns.clear();
      table.rows.emplace_back();
      for (const auto& [key, value] : row.items()) {
        table.columns.push_back(key);
        table.rows.back().push_back(value.is_string() ? value.get<std::string>() : value.dump());
      }
    }
    html += html_section(title, html_of(table, ""));
  }
  return html + "</main>\n</body>\n</html>\n";
}

std::vector<const ClaimStage*> chosen_stages(const ReplicateArguments& arguments,
                                             const Claims& claims) {
  std::set<std::string> wanted(arguments.only.begin(), arguments.only.end());
  std::vector<std::string> known;
  std::vector<const ClaimStage*> chosen;
  for (const ClaimStage& stage : claims.stages) {
    known.push_back(stage.id);
    std::size_t named = wanted.erase(stage.id);
    for (const Claim& claim : stage.claims) {
      known.push_back(claim.id);
      named += wanted.erase(claim.id);
    }
    if (!stage.run.empty() && (stage.is_quick || !arguments.quick) &&
        (named > 0 || arguments.only.empty())) {
      chosen.push_back(&stage);
    }
  }
  if (!wanted.empty()) {
    throw Error("--only", fmt::format("'{}' is not the id of a stage or claim", *wanted.begin()),
                did_you_mean(*wanted.begin(), known, "see " + claims.file.string()));
  }
  return chosen;
}

void run(const ReplicateArguments& arguments, const std::stop_token& stop) {
  const Claims claims = read_claims(arguments.claims);
  const std::vector<const ClaimStage*> stages = chosen_stages(arguments, claims);
  check_output_folder(arguments.folder);
  make_output_folder(arguments.folder);
  StageResults results{arguments.folder, claims, stop};
  results.take_kept(arguments.folder);
  for (const fs::path& folder : arguments.from) {
    results.take_kept(folder);
  }
  if (arguments.from.empty()) {
    results.make(stages);
  }
  Replication replication;
  for (const ClaimStage& stage : claims.stages) {
    replication.add_stage(stage, results.made[stage.id]);
  }
  const std::vector<std::string> faults = faults_of_documents(claims);
  for (const std::string& fault : faults) {
    replication.page["Documents"].push_back({{"fault", fault}});
    print_text(stderr, "{}\n", fault);
  }
  const fs::path page = arguments.folder / "replication.html";
  write_file(page, page_html(replication.page));
  if (arguments.json) {
    print_text("{}\n", replication.page.dump(2));
  } else {
    for (const auto& [verdict, count] : replication.verdicts) {
      print_text("{:<14}{:>6} numbers\n", verdict, count);
    }
    print_text("Page: {}\n", page.string());
  }
  if (arguments.write) {
    write_values(claims, replication.made);
  }
  const std::size_t outside = replication.verdicts["outside"];
  if (stop.stop_requested()) {
    print_text(stderr, "Stopped. To continue, repeat the command.\n");
  } else if (outside + faults.size() > 0) {
    throw Error(
        page.string(),
        fmt::format("lists {} outside the tolerance and {} of documents",
                    count_with_noun(outside, "number"), count_with_noun(faults.size(), "fault")),
        "read this page");
  }
}

}  // namespace

void add_replicate(CLI::App& app, const std::stop_token& stop) {
  const auto arguments = std::make_shared<ReplicateArguments>();
  CLI::App* command =
      app.add_subcommand("replicate", "Reproduce the figures of the documents, and compare them");
  command
      ->add_option("DIR", arguments->folder,
                   "The folder for results and a page of them; made if its parent exists. Existing "
                   "results are kept")
      ->required();
  command->add_flag("--quick", arguments->quick,
                    "Only stages that take a quarter of an hour in all");
  command->add_option("--only", arguments->only,
                      "Only the stages with these ids, or with claims of these ids");
  command->add_option(
      "--from", arguments->from,
      "Run nothing; use the results in these folders, such as those of other machines");
  command->add_flag("--write", arguments->write,
                    "Write the reproduced values into the documents and the file of claims");
  command->add_option("--claims", arguments->claims,
                      "The file of claims (default: the clone's data/claims.toml)");
  command->add_flag("--json", arguments->json, "Print the page's tables as JSON");
  command->footer("Example: foveola replicate made-again --quick");
  command->callback([arguments, stop] {
    if (arguments->claims.empty()) {
      arguments->claims = resource_folder() / "data" / "claims.toml";
    }
    run(*arguments, stop);
  });
}

}  // namespace foveola::analysis
