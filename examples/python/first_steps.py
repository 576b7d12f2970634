#!/usr/bin/env python3
"""First steps with Foveola in Python: a scene rendered around the gaze, and a study's times.

  first_steps.py SCENE STUDY.sqlite
"""
import sys

import foveola


def print_samples(scene_name):
    """Prints how many samples OD and FV give to the 5 degrees around the gaze."""
    scene = foveola.load_scene(scene_name)
    gaze_deg = scene.head_deg
    for method in ("od", "fv"):
        image = foveola.render(scene, method, gaze_deg=gaze_deg, size=(720, 360),
                               samples=200_000, seed=1)
        # Two pixels a degree; azimuth 0 is in the middle, elevation 90 at the top.
        x = round(360 + 2 * gaze_deg[0])
        y = round(180 - 2 * gaze_deg[1])
        around_gaze = image.samples[y - 10:y + 10, x - 10:x + 10]
        print(f"{method}: {around_gaze.mean():.1f} samples a pixel around the gaze, "
              f"{image.samples.mean():.1f} everywhere")


def print_times(study_file):
    """Prints the median time of each mark with each method, of the analysed trials."""
    trials = foveola.read_study(study_file)["trials"]
    analysed = trials[trials["status"] == "analysed"]
    times = [name for name, unit in trials.attrs["units"].items()
             if unit == "s" and name.endswith("_s")]
    print(f"participants: {trials.attrs['participant_kind']}")
    print(analysed.groupby("method")[times].median().to_string())


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    print_samples(sys.argv[1])
    print_times(sys.argv[2])
