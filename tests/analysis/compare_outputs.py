#!/usr/bin/env python3
"""Compares the outputs of two analyses of one study, value by value, before and after a change.

compare_outputs.py BEFORE AFTER [--rename OLD=NEW]... [--ignore NAME]...

BEFORE and AFTER are folders of `foveola analyze STUDY -o FOLDER`. In every CSV, TSV and JSON file of
BEFORE each value is looked up in the file of the same name in AFTER: by its column and by the texts
of its row in the columns that both have (rows with the same texts by their order), or by its place in
the JSON. So a row in which a text has changed is one that is missing. --rename says that a file,
column or JSON key is called otherwise in AFTER, --ignore that it is not compared. What only AFTER has
is listed, and is no difference. Exits with 1 if anything differs.
"""

import argparse
import collections
import csv
import gzip
import json
import pathlib
import sys


def is_number(text):
    try:
        float(text)
    except ValueError:
        return False
    return True


def same(before, after):
    return before == after or (
        is_number(before) and is_number(after) and float(before) == float(after))


def text_of(path):
    data = path.read_bytes()
    return (gzip.decompress(data) if path.suffix == ".gz" else data).decode()


def read_table(path, renamed, ignored):
    """The rows as dictionaries by column."""
    delimiter = "\t" if ".tsv" in path.suffixes else ","
    rows = list(csv.reader(text_of(path).splitlines(keepends=True), delimiter=delimiter))
    columns = [renamed.get(column, column) for column in rows[0]] if rows else []
    if all(is_number(column) for column in columns):  # BIDS samples have no header.
        columns = [str(i) for i in range(len(columns))]
    else:
        del rows[0]
    truth = {"TRUE": "true", "FALSE": "false"}  # CSV was in lower case once, as TSV is.
    return [{c: truth.get(v, v) for c, v in zip(columns, row) if c not in ignored} for row in rows]


def rows_by_texts(rows, columns):
    """The rows by their texts in these columns and their number among those with the same."""
    named = {}
    seen = collections.Counter()
    for row in rows:
        texts = ", ".join(f"{c} {row[c]}" for c in columns
                          if c in row and row[c] and not is_number(row[c]))
        seen[texts] += 1
        named[f"row {seen[texts]} of ({texts})"] = row
    return named


def tables(before, after):
    columns = sorted({c for row in before for c in row} & {c for row in after for c in row})
    return rows_by_texts(before, columns), rows_by_texts(after, columns)


def values_of_json(value, renamed, ignored, place=""):
    """The values by their place, as /tables/comparisons/0/n."""
    if isinstance(value, dict):
        inner = [(renamed.get(key, key), part) for key, part in value.items()]
    elif isinstance(value, list):
        inner = [(str(i), part) for i, part in enumerate(value)]
    else:
        return {place: str(value)}
    values = {}
    for key, part in inner:
        if key not in ignored:
            values.update(values_of_json(part, renamed, ignored, f"{place}/{key}"))
    return values


def parts_of_files(before, after, renamed, ignored):
    """Of each file the values of its rows, or all of a JSON, by their names."""
    if before.suffix == ".json":
        return ({"": values_of_json(json.loads(text_of(before)), renamed, ignored)},
                {"": values_of_json(json.loads(text_of(after)), {}, ignored)})
    return tables(read_table(before, renamed, ignored), read_table(after, {}, ignored))


def compare_files(name, before, after):
    """Prints what differs; returns the numbers of values compared and of differences."""
    compared = differences = 0
    for part, values in before.items():
        if part not in after:
            print(f"{name}: {part}: is missing")
            differences += 1
            continue
        for place, value in values.items():
            compared += 1
            now = after[part].get(place)
            if now is None or not same(value, now):
                print(f"{name}: {part} {place}: {value!r}", "is missing" if now is None
                      else f"is now {now!r}")
                differences += 1
    added = {place for values in after.values() for place in values}
    added -= {place for values in before.values() for place in values}
    for place in sorted(added):
        print(f"{name}: {place}: is new")
    for part in sorted(after.keys() - before.keys()):
        print(f"{name}: {part}: is new")
    return compared, differences


def files_in(folder):
    ends = (".csv", ".tsv", ".json", ".tsv.gz")
    return {str(path.relative_to(folder)): path
            for path in sorted(folder.rglob("*")) if path.name.endswith(ends)}


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("before", type=pathlib.Path)
    parser.add_argument("after", type=pathlib.Path)
    parser.add_argument("--rename", action="append", default=[], metavar="OLD=NEW")
    parser.add_argument("--ignore", action="append", default=[], metavar="NAME")
    options = parser.parse_args()
    renamed = {}
    for rename in options.rename:
        old, equals, new = rename.partition("=")
        if not equals:
            parser.error(f"--rename {rename}: write OLD=NEW")
        renamed[old] = new
    before = files_in(options.before)
    after = files_in(options.after)
    if not before:
        parser.error(f"{options.before} has no CSV, TSV or JSON file")
    compared = differences = 0
    for name, path in before.items():
        path_after = after.pop(renamed.get(name, name), None)
        if name in options.ignore:
            continue
        if path_after is None:
            print(f"{name}: is missing")
            differences += 1
            continue
        of_file = compare_files(name,
                                *parts_of_files(path, path_after, renamed, options.ignore))
        compared += of_file[0]
        differences += of_file[1]
    for name in after:
        print(f"{name}: is new")
    print(f"{compared} values compared, {differences} differences")
    return 1 if differences else 0


if __name__ == "__main__":
    sys.exit(main())
