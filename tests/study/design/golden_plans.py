#!/usr/bin/env python3
"""Writes tests/data/golden_plans.csv: what plan_test.cpp holds make_plan against.

    python3 tests/study/design/golden_plans.py > tests/data/golden_plans.csv

It shares nothing with the program. The generator is written after O'Neill 2014 (PCG-XSH-RR 64/32,
pcg32_srandom and pcg32_boundedrand of the reference implementation), the shuffle after Durstenfeld
1964, the squares are written out from Williams 1949, and the crossing of scenes and methods is the
table of starts and renamings that the design is meant to have.
"""

SCENES = "abcde"
METHODS = "xyz"

# By hand: 0 1 4 2 3, each row one more than the one above, then all of it mirrored.
WILLIAMS_5 = [
    [0, 1, 4, 2, 3], [1, 2, 0, 3, 4], [2, 3, 1, 4, 0], [3, 4, 2, 0, 1], [4, 0, 3, 1, 2],
    [3, 2, 4, 1, 0], [4, 3, 0, 2, 1], [0, 4, 1, 3, 2], [1, 0, 2, 4, 3], [2, 1, 3, 0, 4],
]
WILLIAMS_3 = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0], [0, 2, 1], [1, 0, 2]]
LATIN_5 = [[0, 1, 2, 3, 4], [1, 2, 3, 4, 0], [2, 3, 4, 0, 1], [3, 4, 0, 1, 2], [4, 0, 1, 2, 3]]
LATIN_3 = [[0, 1, 2], [1, 2, 0], [2, 0, 1]]

SQUARES = {
    ("latin", 5): LATIN_5, ("latin", 3): LATIN_3,
    ("williams", 5): WILLIAMS_5, ("williams", 3): WILLIAMS_3,
}
STARTS = {"williams": [0, 0, 0, 3, 3], "latin": [0, 0, 0, 0, 0]}
RENAMINGS = [0, 1, 2, 0, 1]


class Pcg32:
    def __init__(self, seed, sequence):
        self.state = 0
        self.inc = (sequence << 1 | 1) % 2**64
        self.random()
        self.state = (self.state + seed) % 2**64
        self.random()

    def random(self):
        old = self.state
        self.state = (old * 6364136223846793005 + self.inc) % 2**64
        word = ((old >> 18 ^ old) >> 27) % 2**32
        turn = old >> 59
        return (word >> turn | word << (32 - turn)) % 2**32

    def bounded(self, bound):
        threshold = (2**32 - bound) % bound
        while True:
            number = self.random()
            if number >= threshold:
                return number % bound


def shuffled(count, generator):
    things = list(range(count))
    for last in range(count - 1, 0, -1):
        other = generator.bounded(last + 1)
        things[last], things[other] = things[other], things[last]
    return things


def scene_order(order, row, generator):
    if order == "random":
        return shuffled(5, generator)
    if order == "fixed":
        return [0, 1, 2, 3, 4]
    square = SQUARES[order, 5]
    return square[row % len(square)]


def method_order(order, scene, row, generator):
    if order == "random":
        return shuffled(3, generator)
    if order == "fixed":
        return [0, 1, 2]
    square = SQUARES[order, 3]
    methods = square[(row + STARTS[order][scene]) % len(square)]
    return [(method + RENAMINGS[scene]) % 3 for method in methods]


def plan(scenes, methods, catches, seed, row):
    generator = Pcg32(seed, row)
    trials = []
    for scene in scene_order(scenes, row, generator):
        for method in method_order(methods, scene, row, generator):
            trials.append(SCENES[scene] + METHODS[method])
    if catches:
        for place in sorted(shuffled(len(trials), generator)[:catches], reverse=True):
            trials.insert(place + 1, trials[place] + "!")
    return " ".join(trials)


print("scene_order,method_order,catch_trials,seed,row,plan")
ORDERS = ["random", "latin", "williams", "fixed"]
for scenes in ORDERS:
    for methods in ORDERS:
        for catches, seed, row in [(0, 1, 0), (0, 1, 7), (2, 20181209, 11), (3, 2**64 - 1, 40)]:
            text = plan(scenes, methods, catches, seed, row)
            print(f"{scenes},{methods},{catches},{seed},{row},{text}")
