// The population of simulated participants: the parameters of people. Their values, with units and
// sources, are in data/participants/*.toml, read by read_people().
#pragma once

namespace foveola::study {

/// The eye's movements.
struct GazeHabits {
  double shortest_fixation_s = 0.0;
  double longest_fixation_s = 0.0;
  /// Time from a target's appearance until the eye moves to it.
  double saccade_latency_s = 0.0;
  /// A saccade of A degrees takes saccade_s + saccade_s_per_deg A.
  double saccade_s = 0.0;
  double saccade_s_per_deg = 0.0;
  /// After a saccade has landed, nothing is judged for this long while looking around.
  double suppression_s = 0.0;
  /// Fixations on the chosen object stay within this part of its angular radius.
  double examined_part = 0.0;
  /// While looking around: the head's range to both sides of the object, and above and below the
  /// horizon, and the standard deviation of the eye in the head.
  double head_azimuth_deg = 0.0;
  double head_elevation_deg = 0.0;
  /// A turn of the head by A degrees takes head_turn_s + head_turn_s_per_deg A.
  double head_turn_s = 0.0;
  double head_turn_s_per_deg = 0.0;
  double eye_in_head_deg = 0.0;
  double fixations_per_head_turn = 0.0;  ///< Rounded to a whole number.
};

/// Visual thresholds, and the cells and patches on which images are judged.
struct Vision {
  /// A just noticeable difference, in units of CIELAB.
  double jnd_lab = 0.0;
  /// Thresholds rise with the frequency f (cycles per degree) and the eccentricity e as
  /// exp(decay_deg f (e + half_resolution_deg) / half_resolution_deg) (Geisler and Perry 1998).
  double decay_deg = 0.0;
  double half_resolution_deg = 0.0;
  /// At the gaze, chromatic thresholds rise this many times faster with the frequency.
  double chromatic_decay_factor = 0.0;
  /// Red-green thresholds rise by this many more powers of 10 per degree.
  double red_green_decades_per_deg = 0.0;
  /// The number of line pairs across an object at which it is recognised.
  double recognition_line_pairs = 0.0;
  /// An outline is judged within this factor of the object's radius.
  double surround_factor = 0.0;
  /// A material and the whole view are judged on several scales at once: in cells of these widths,
  /// and of twice, four times ... the widths, scale_count in all.
  double material_cell_deg = 0.0;
  double view_cell_deg = 0.0;
  double scale_count = 1.0;  ///< Rounded to a whole number.
  /// Exponent of the pooling over scales: the root of the sum of these powers.
  double pooling_exponent = 0.0;
  /// Cells are grouped in patches of these sizes, each judged at one eccentricity.
  double object_patch_deg = 0.0;
  double view_patch_deg = 0.0;
  /// While looking around, artifacts are judged within this angle of the gaze.
  double looked_at_deg = 0.0;
  /// Not a parameter of people, but of a scaled study, whose film and machine are scaled down by
  /// this factor squared: a whole number, the width in cells over which noise is averaged. That
  /// many cells hold as many samples as one does at full size, and the same fraction of pixels is
  /// unsampled.
  double coarseness = 1.0;
};

/// Parameters of decisions from evidence, and their spread between people.
struct DecisionHabits {
  /// Signal-to-noise ratio at which an outline is detected.
  double outline_signal_to_noise = 0.0;
  /// Visible difference, in just noticeable ones, at which a material looks finished.
  double material_jnd = 0.0;
  /// Time constant of the leaky mean of the logarithm of the evidence; the minimum time of a
  /// decision.
  double integration_s = 0.0;
  /// Upper bound of the evidence (natural logarithm of its ratio to the criterion).
  double evidence_limit = 0.0;
  /// Standard deviation of the noise of each glance's logarithm of evidence.
  double glance_noise = 0.0;
  /// Standard deviation between people of the natural logarithm of each criterion.
  double criterion_spread = 0.0;
  /// Standard deviation between people of the change of that logarithm from trial to trial.
  double drift_per_trial = 0.0;
  /// After waiting for t seconds since an attempt began, people accept a signal-to-noise ratio 1 +
  /// impatience_per_s t times lower, or a visible difference as many times larger.
  double impatience_per_s = 0.0;
  /// The reaction time: a normal part and an exponential one; people's means differ by a factor
  /// whose natural logarithm has the standard deviation reaction_spread.
  double reaction_mean_s = 0.0;
  double reaction_deviation_s = 0.0;
  double reaction_tail_s = 0.0;
  double reaction_spread = 0.0;
  /// Fraction of marks that are late by inattention (lapses), and their mean delay.
  double lapse_part = 0.0;
  double lapse_s = 0.0;
  /// Fraction of premature marks, the factor by which their evidence is short of the criterion, and
  /// the fraction of these that are noticed, so that the trial is retimed.
  double early_part = 0.0;
  double early_factor = 0.0;
  double early_noticed_part = 0.0;
};

/// Ratings of artifacts.
struct RatingHabits {
  /// The visible difference in JND at which a five-point scale's second point begins, and the
  /// factor from each point's threshold to the next.
  double second_point_jnd = 0.0;
  double step_factor = 0.0;
  /// Exponent of the pooling over glances: the root of the mean of these powers of the difference.
  double pooling_exponent = 1.0;
  /// Standard deviations of the natural logarithm of the noticed difference: between people, and
  /// from rating to rating.
  double bias_spread = 0.0;
  double noise_spread = 0.0;
};

/// Parameters of people's answers about themselves.
struct Background {
  double age_mean_years = 0.0;
  double age_deviation_years = 0.0;
  double first_gender_part = 0.0;  ///< Fraction that chooses the first option, not the second.
  /// Mean and deviation of answers on scales and other numbers, as fractions of their range.
  double scale_mean_part = 0.0;
  double scale_deviation_part = 0.0;
};

struct Population {
  GazeHabits gaze;
  DecisionHabits decision;
  RatingHabits rating;
  Background background;
  Vision vision;
};

}  // namespace foveola::study
