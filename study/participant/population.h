// Who the simulated participants are: the parameters of people, with where they come from.
#pragma once

namespace foveola::study {

/// The eye's movements.
struct GazeHabits {
  /// Fixations while viewing scenes (Henderson 2003).
  double shortest_fixation_s = 0.20;
  double longest_fixation_s = 0.35;
  /// From a target's appearance until the eye moves to it (180 to 200 ms are usual).
  double saccade_latency_s = 0.2;
  /// A saccade of A degrees takes 2.2 A + 21 ms (Carpenter 1988).
  double saccade_s = 0.021;
  double saccade_s_per_deg = 0.0022;
  /// Fixations on the chosen object stay within this part of its angular radius.
  double examined_part = 0.7;
  /// While looking around: the head's range to both sides of the object and up and down (assumed),
  /// the time of a turn, and the standard deviation of the eye in the head (few shifts leave +-20
  /// degrees, Stahl 1999).
  double head_azimuth_deg = 40.0;
  double head_elevation_deg = 15.0;
  double head_turn_s = 0.5;
  double eye_in_head_deg = 10.0;
  int fixations_per_head_turn = 3;
};

/// How pixels are judged, and how people differ in it.
struct ObserverModel {
  /// A just noticeable difference: 2.3 units of CIELAB (Mahy et al. 1994), whose lightness follows
  /// 100 times the sRGB value to within a few units.
  double jnd_srgb = 0.023;
  /// The linear cortical magnification falls as 1 / (e + e2) with the eccentricity e (Dougherty et
  /// al. 2003).
  double half_magnification_deg = 3.67;

  /// An outline is judged on patches of this size, over the object and as much of its surroundings
  /// as this factor of its radius takes in (both assumed).
  double outline_patch_deg = 4.0;
  double outline_surround = 1.5;
  /// What stands out of noise is five times as strong as the noise (Rose 1948).
  double outline_signal_to_noise = 5.0;

  /// A material is judged on the finest details that contrast sensitivity favours: half a period at
  /// 2 cycles per degree (Robson 1966); larger pixels limit it.
  double material_patch_deg = 0.25;
  /// How many just noticeable differences still pass for "as it will look" (assumed).
  double material_criterion_jnd = 1.5;

  /// What is seen must hold this long before the decision is made (assumed: about one fixation).
  double integration_s = 0.2;
  /// Standard deviation between people of the natural logarithm of a criterion (assumed).
  double criterion_spread = 0.25;

  /// Simple reaction time: a normal part and an exponential one (Luce 1986).
  double reaction_mean_s = 0.250;
  double reaction_deviation_s = 0.030;
  double reaction_tail_s = 0.070;

  /// The just noticeable differences at which a scale's second point begins (2 of 1 to 5), and the
  /// factor to that of each next one: one doubling after another (assumed).
  double rating_2_jnd = 1.0;
  double rating_step = 2.0;
};

struct Population {
  GazeHabits gaze;
  ObserverModel observer;
};

}  // namespace foveola::study
