// Who the simulated participants are: the parameters of people. Their numbers, with units and
// sources, are in data/participants/*.toml; read_people() reads them.
#pragma once

namespace foveola::study {

/// The eye's movements.
struct GazeHabits {
  double shortest_fixation_s = 0.0;
  double longest_fixation_s = 0.0;
  /// From a target's appearance until the eye moves to it.
  double saccade_latency_s = 0.0;
  /// A saccade of A degrees takes saccade_s + saccade_s_per_deg A.
  double saccade_s = 0.0;
  double saccade_s_per_deg = 0.0;
  /// Fixations on the chosen object stay within this part of its angular radius.
  double examined_part = 0.0;
  /// While looking around: the head's range to both sides of the object and up and down, the time
  /// of a turn, and the standard deviation of the eye in the head.
  double head_azimuth_deg = 0.0;
  double head_elevation_deg = 0.0;
  double head_turn_s = 0.0;
  double eye_in_head_deg = 0.0;
  double fixations_per_head_turn = 0.0;  ///< rounded
};

/// What eyes tell apart.
struct Vision {
  /// A just noticeable difference, in units of CIELAB.
  double jnd_lab = 0.0;
  /// Thresholds rise with the frequency f (cycles per degree) and the eccentricity e as
  /// exp(decay_deg f (e + half_resolution_deg) / half_resolution_deg) (Geisler and Perry 1998).
  double decay_deg = 0.0;
  double half_resolution_deg = 0.0;
  /// At the gaze, those of chromatic differences rise so many times faster with the frequency.
  double chromatic_decay_factor = 0.0;
  /// Those of red-green differences rise by so many powers of 10 more in each degree.
  double red_green_decades_per_deg = 0.0;
  /// How many across an object let it be recognised.
  double recognition_line_pairs = 0.0;
  /// An outline is judged over the object and as much of its surroundings as this factor of its
  /// radius takes in.
  double surround_factor = 0.0;
  /// A material and the whole view are looked at on several scales at once: in cells of these
  /// widths and, scale_count in all, in cells twice, four times ... as wide.
  double material_cell_deg = 0.0;
  double view_cell_deg = 0.0;
  double scale_count = 1.0;  ///< rounded
  /// What is noticed on all scales together is the root of the sum of these powers.
  double pooling_exponent = 0.0;
  /// Cells are grouped in patches of these sizes, which have one eccentricity.
  double object_patch_deg = 0.0;
  double view_patch_deg = 0.0;
  /// Of no person, but of a study whose film and machine are scaled down by this factor squared: a
  /// whole number, how many cells' width the noise is averaged over. So many cells hold as many
  /// samples as one does at full size, and as large a part of them has none.
  double coarseness = 1.0;
};

/// How decisions are made of what is seen, and how people differ in it.
struct DecisionHabits {
  /// How many times stronger than noise stands out of it.
  double outline_signal_to_noise = 0.0;
  /// How many just noticeable differences still pass for "as it will look".
  double material_jnd = 0.0;
  /// The time constant over which the logarithm of the evidence is averaged; nothing is decided
  /// sooner.
  double integration_s = 0.0;
  /// Evidence is no stronger than this (natural logarithm of its ratio to the criterion).
  double evidence_limit = 0.0;
  /// Standard deviation of the noise of each glance's logarithm of evidence.
  double glance_noise = 0.0;
  /// Standard deviation between people of the natural logarithm of each criterion.
  double criterion_spread = 0.0;
  /// Standard deviation between people of the change of that logarithm from trial to trial.
  double drift_per_trial = 0.0;
  /// The reaction time: a normal part and an exponential one; people's means differ by a factor
  /// whose natural logarithm has the standard deviation reaction_spread.
  double reaction_mean_s = 0.0;
  double reaction_deviation_s = 0.0;
  double reaction_tail_s = 0.0;
  double reaction_spread = 0.0;
  /// How many marks are made late for want of attention, and by how much in the mean.
  double lapse_part = 0.0;
  double lapse_s = 0.0;
  /// How many marks are made early, when the evidence is by a factor short of the criterion, and
  /// how many of these are noticed, so that the trial is timed again.
  double early_part = 0.0;
  double early_factor = 0.0;
  double early_noticed_part = 0.0;
};

/// Ratings of artifacts.
struct RatingHabits {
  /// The just noticeable differences at which a five-point scale's second point begins, and the
  /// factor to that of each next one.
  double second_point_jnd = 0.0;
  double step_factor = 0.0;
  /// Standard deviations of the natural logarithm of what is noticed: between people, and from
  /// rating to rating.
  double bias_spread = 0.0;
  double noise_spread = 0.0;
};

/// What people say of themselves.
struct Background {
  double age_mean_years = 0.0;
  double age_deviation_years = 0.0;
  double first_gender_part = 0.0;  ///< that chooses the first option, not the second
  /// Of answers on scales and other numbers, as parts of their range.
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
