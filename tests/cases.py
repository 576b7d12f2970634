#!/usr/bin/env -S python3 -B
"""Sums up the GoogleTest cases that CTest has run in a build, from the files that tests/add_suites.cmake
has them write: how many passed, failed and were skipped, and why.

cases.py BUILD
  --slowest N   prints the slowest N cases as lines of CSV instead: case,SUITE.CASE,SECONDS
"""

import argparse
import collections
import csv
import pathlib
import sys
import xml.etree.ElementTree


def cases_in(build):
    """(name, seconds, outcome, reason) of each case; a process that died has left none."""
    for file in sorted(build.glob("tests/**/cases/*.xml")):
        for case in xml.etree.ElementTree.parse(file).iter("testcase"):
            if case.get("status") != "run":
                continue
            skipped = case.find("skipped")
            if case.find("failure") is not None:
                outcome, reason = "failed", ""
            elif skipped is not None:
                # The first line has the source's place.
                outcome, reason = "skipped", " ".join(skipped.get("message").split("\n")[1:]).strip()
            else:
                outcome, reason = "passed", ""
            yield (f"{case.get('classname')}.{case.get('name')}", float(case.get("time")), outcome,
                   reason)


def main():
    parser = argparse.ArgumentParser(usage=__doc__, add_help=False)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--slowest", type=int)
    given = parser.parse_args()
    cases = list(cases_in(given.build))
    if given.slowest is not None:
        rows = sorted(cases, key=lambda case: -case[1])[:given.slowest]
        csv.writer(sys.stdout, lineterminator="\n").writerows(
            ("case", name, f"{seconds:.2f}") for name, seconds, _, _ in rows)
        return
    skipped = collections.defaultdict(list)
    for name, _, outcome, reason in cases:
        if outcome == "skipped":
            skipped[reason].append(name)
    for reason, names in sorted(skipped.items()):
        print(f"skipped: {', '.join(names)}: {reason}")
    outcomes = collections.Counter(outcome for _, _, outcome, _ in cases)
    print(f"{outcomes['passed']} passed, {outcomes['failed']} failed, {outcomes['skipped']} skipped")


if __name__ == "__main__":
    main()
