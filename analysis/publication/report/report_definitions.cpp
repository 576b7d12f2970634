#include <fmt/format.h>

#include "analysis/dataset/gaze_by_trial.h"
#include "analysis/dataset/wording.h"
#include "analysis/publication/report/report_parts.h"
#include "analysis/publication/report/report_sections.h"
#include "analysis/tables/html.h"

namespace foveola::analysis {

std::string definitions_section(const ReportContent& content) {
  std::string html = "<dl class=\"definitions\">\n";
  const auto define = [&](std::string_view term, const std::string& meaning) {
    html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", term, escape_html(meaning));
  };
  const std::string reference = baseline_label(content.tables);
  define("Time", "From the first presented frame to the participant’s mark, in seconds.");
  define("Sessions",
         "Only completed sessions count, and only of one kind: people’s if there are any, else "
         "pilots’, else simulated ones.");
  define("Mean and standard deviation",
         "Of times: arithmetic, over participants; n − 1 in the denominator.");
  define("Per cent of " + escape_html(reference),
         fmt::format("100 × a participant’s time divided by the same participant’s {} time in the "
                     "same scene; a participant without both is not in n.",
                     reference));
  define("Of " + escape_html(reference) + "’s mean time",
         fmt::format("100 × the mean of a method’s times divided by the mean of {}’s times in the "
                     "same scene, and their standard deviation divided by the same: of all "
                     "measured times, including those of participants without both.",
                     reference));
  define("Right-censored",
         "The participant had not marked by the time-out, which is a lower bound of "
         "the time. It is in no mean, which makes that method’s mean too small; the count stands "
         "beside it.");
  define("Geometric mean over scenes",
         "exp of the mean logarithm, first over a participant’s scenes, then over participants. A "
         "scene counts for a participant only if every method’s time was measured in it, so that "
         "the methods are compared over the same scenes.");
  define("95 % interval",
         "exp(m ± t·s/√n), with m and s the mean and standard deviation of the participants’ "
         "logarithms and t Student’s with n − 1 degrees of freedom: the participant is the unit.");
  define("Speed-up",
         fmt::format("{}’s time over the method’s, as a factor ×: the inverse of the method’s time "
                     "in per cent of {}’s.",
                     reference, reference));
  define(
      "Primary analysis",
      "The analysis that the protocol chooses for a comparison, with its estimate, interval and P. "
      "Times: with random scenes, a mixed model of log times in which participants and "
      "scenes are crossed and each has its own difference between the methods, by restricted "
      "maximum likelihood with Satterthwaite’s degrees of freedom, for participants and scenes "
      "like these; with fixed scenes, a paired t test over participants, in these scenes. With "
      "right-censored times, a Tobit model of log times with terms for participants and scenes; "
      "with random scenes, its standard error and degrees of freedom are the mixed model’s of each "
      "pair’s influence on the ratio; with fixed scenes, each has a ratio of its own, of which the "
      "mean is given, and errors are clustered by participant, t with one degree of freedom fewer "
      "than participants. Ratings: a cumulative link mixed model with the same random effects, "
      "with P by the likelihood ratio and the interval by the profile likelihood, whose signed "
      "root is held against t with the degrees of freedom of a balanced linear model of the "
      "latent variable, and scaled by the ratio of that model’s standard error to Wald’s; or "
      "signed ranks. "
      "Without censoring and gaps the mixed model is of closed form; all else is fitted by R.");
  define("Pairs",
         "The trials of both methods in one scene by one participant. Each comparison uses "
         "every pair that was measured; complete cases are the scenes in which all "
         "methods were measured.");
  define(
      "Tests over participants",
      "A participant’s value is the mean log ratio, or the mean difference of ratings, over the "
      "scenes with a pair; ratios, t tests, d_z (mean over standard deviation of the values) and "
      "Wilcoxon tests are of these, the omnibus tests of complete cases. Wilcoxon’s test leaves "
      "out differences of zero and is exact, with ties, up to 200 participants, above which it is "
      "the normal approximation with corrections for ties and continuity. r, rank: the "
      "matched-pairs rank-biserial correlation, (W+ − W−)/(W+ + W−).");
  define("Pseudo-median",
         "Hodges and Lehmann’s estimate: the median of the means of all pairs of participants’ "
         "values, each with itself too, of log ratios or of rating differences. Its interval "
         "inverts the signed-rank test, exact without ties up to 200 participants; with fewer than "
         "six participants there is no 95 % confidence interval.");
  define(
      "ε",
      "How far the data are from sphericity, the analysis of variance’s assumption that "
      "differences between all pairs of methods have equal variances: 1 if they do. The table has "
      "Greenhouse and Geisser’s, with both degrees of freedom times it; omnibus.csv has Huynh "
      "and Feldt’s, too, which is less strict.");
  define(
      "BCa",
      "Bias-corrected and accelerated bootstrap over participants, 9999 resamples (fewer above "
      "2000 participants), a fixed seed, from 8 participants on. Of 8 it covers about 88 %, of 16 "
      "about 92 %, where the t interval covers 95 %.");
  define(
      "The figures of data quality",
      "From the frame log of the attempts that count, per session: the share of frames that "
      "missed their refresh; of frames whose tracker’s newest gaze was not valid, or older than a "
      "blink lasts (600 ms); the mean age of the gaze used plus the mean time from polling to the "
      "display; and how long after the frame on the display the latest mark came. Limits that no "
      "source gives are Foveola’s own and say so.");
  define(
      "How sessions went",
      "A session was interrupted if its program was killed, lost its display or power, or was left "
      "before the session’s end; attempts that this ended are lost, and are retimed. Trials "
      "retimed for another reason (asked for, or after a pause in mid-trial) are named "
      "separately. Notes are the program’s and the experimenter’s, but for those of devices, "
      "clock, "
      "amended protocol, another program and the window’s size. A program is named by its "
      "version, compiler, kind of build and ray tracer: where several ran the sessions, their "
      "times are to be compared with care.");
  define(
      "Gaze on the object",
      fmt::format(
          "The gaze that a frame used lies within the chosen object’s angular radius and {:g}° "
          "for the tracker’s accuracy; the frame stands for the time until the next one. If valid "
          "but "
          "elsewhere, it is “elsewhere”; if not valid, or older than a blink lasts, there is none. "
          "Out of view: the object’s direction is not in the field of view of the frame that "
          "was on the display at the mark.",
          study::gaze_margin_deg));
  define("P",
         "Of the hypothesis of no correlation, two-sided: t = r·√((n − 2)/(1 − r²)), n − 2 degrees "
         "of freedom. "
         "Spearman’s is of the same form, but exact, over all orders of the ranks, for up to nine "
         "participants. Intervals are Fisher’s z, for ρ with the variance (1 + ρ²/2)/(n − 3) of "
         "Bonett and Wright.");
  return html_section("Definitions", html + "</dl>\n");
}

}  // namespace foveola::analysis
