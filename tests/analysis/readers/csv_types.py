#!/usr/bin/env python3
"""Opens every CSV file of an analysis with pandas, as anybody would, and compares each column's type
with codebook.csv.

csv_types.py FOLDER

FOLDER is that of `foveola analyze STUDY -o FOLDER`. A column without a single value fits any type.
Exits with 1 if a column has another type than the codebook says, or if it or its file is not in the
codebook; with 77 if pandas is missing.
"""

import pathlib
import sys

try:
    import pandas
except ImportError:
    print("skipped: pandas is not installed", file=sys.stderr)
    sys.exit(77)


def fits(values, kind):
    """Whether a column's values, those that are there, were read as what the codebook calls them."""
    # A column of whole numbers or of truth values with gaps is one of doubles or objects.
    if kind == "string":
        return all(isinstance(value, str) for value in values)
    if kind == "boolean":
        return all(isinstance(value, bool) for value in values.tolist())
    if not pandas.api.types.is_numeric_dtype(values) or pandas.api.types.is_bool_dtype(values):
        return False
    return kind == "number" or (kind == "integer" and (values == values.round()).all())


def faults_in(path, codebook):
    rows = codebook[codebook["file"] == path.stem]
    types = dict(zip(rows["variable"], rows["type"]))
    data = pandas.read_csv(path)
    for name in sorted(set(data.columns) ^ set(types)):
        yield f"{path.name}: {name}: is in the file or in the codebook, but not in both"
    for name in set(data.columns) & set(types):
        values = data[name].dropna()
        if len(values) > 0 and not fits(values, types[name]):
            yield f"{path.name}: {name}: the codebook says {types[name]}, pandas reads {values.dtype}"


def main():
    folder = pathlib.Path(sys.argv[1])
    codebook = pandas.read_csv(folder / "codebook.csv")
    files = sorted(path for path in folder.glob("*.csv") if path.name != "codebook.csv")
    faults = [fault for path in files for fault in faults_in(path, codebook)]
    missing = set(codebook["file"]) - {path.stem for path in files}
    faults += [f"{name}.csv: is in the codebook, but not in the folder" for name in sorted(missing)]
    for fault in faults:
        print(fault)
    print(f"pandas {pandas.__version__}: {len(files)} files, {len(codebook)} columns, "
          f"{len(faults)} faults")
    sys.exit(1 if faults or not files else 0)


if __name__ == "__main__":
    main()
