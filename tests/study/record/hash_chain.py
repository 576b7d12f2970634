#!/usr/bin/env python3
"""Checks the hash chains of a study's file as schema.sql describes them: an outsider's program.

Prints each session's participant, number of events and last hash; fails at the first event whose
hash is not what it says.
"""
import hashlib
import json
import sqlite3
import sys
import zlib

FACTS = [
    ("protocol_name, protocol_title, protocol_text, protocol_sha256", "study"),
    ("position, name", "study_scene ORDER BY position"),
    ("position, name", "study_method ORDER BY position"),
    ("method, file_name, file_sha256", "study_method_file ORDER BY method, file_name"),
    ("device, name, toml, toml_sha256", "study_profile ORDER BY device, name"),
    ("position, mark", "study_mark ORDER BY position"),
    ("position, rating, question", "study_rating ORDER BY position"),
]
SESSION_FACTS = [
    ("session", "id", "id state site", "1"),
    ("session_scene", "session", "session", "scene"),
    ("planned_trial", "session", "session", "trial"),
    ("planned_step", "session", "session", "step"),
]


def sha256(lines):
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()


def as_line(row):
    return json.dumps(list(row), separators=(",", ":"), ensure_ascii=False)


def hash_before_events(study, session):
    lines = [as_line(row) for columns, table in FACTS
             for row in study.execute(f"SELECT {columns} FROM {table}")]
    for table, key, left_out, order in SESSION_FACTS:
        rows = study.execute(f"SELECT * FROM {table} WHERE {key} = ? ORDER BY {order}", [session])
        names = [column[0] for column in rows.description]
        for row in rows:
            values = dict(zip(names, row))
            if values.get("site"):
                values["participant"] = values["participant"].removeprefix(values["site"] + "-")
            lines.append(as_line(value for name, value in values.items()
                                 if name not in left_out.split()))
    return sha256(lines)


def chunk_hash(uuid, trial, attempt, first, count, encoding, data):
    place = "".join(f"{value}\n" for value in (uuid, trial, attempt, first, count, encoding))
    return hashlib.sha256(place.encode() + zlib.decompress(data)).hexdigest()


def what_was_measured(study, session, trial, attempt):
    """What an event that ends an attempt has to state, from the rows themselves."""
    uuid, = study.execute("SELECT uuid FROM session WHERE id = ?", [session]).fetchone()

    def chunks(table, first, count):
        rows = study.execute(
            f"SELECT {first}, {count}, encoding, data FROM {table} WHERE session = ? AND trial = ?"
            f" AND attempt = ? ORDER BY {first}", [session, trial, attempt]).fetchall()
        return (sum(row[1] for row in rows),
                [chunk_hash(uuid, trial, attempt, *row) for row in rows])

    films = [sha256([as_line([uuid, trial, attempt, *row])]) for row in study.execute(
        "SELECT frame, film_sha256 FROM film_hash WHERE session = ? AND trial = ? AND attempt = ?"
        " ORDER BY frame", [session, trial, attempt])]
    return json.dumps({
        name: {"count": count, "sha256": sha256(hashes)} for name, (count, hashes) in [
            ("frames", chunks("frame_chunk", "first_frame", "frame_count")),
            ("gaze", chunks("gaze_chunk", "first_sample", "sample_count")),
            ("films", (len(films), films))]
    }, separators=(",", ":"))


def main():
    study = sqlite3.connect(f"file:{sys.argv[1]}?mode=ro", uri=True)
    for session, participant in study.execute("SELECT id, participant FROM session ORDER BY id"):
        previous = hash_before_events(study, session)
        count = 0
        for *line, trial, attempt, measured, expected in study.execute(
                "SELECT sequence, time_ns, utc, type, payload, trial, attempt, measured, hash"
                " FROM event WHERE session = ? ORDER BY sequence", [session]):
            if measured and measured != what_was_measured(study, session, trial, attempt):
                sys.exit(f"{participant}: event {line[0]} states other measurements")
            line += ["" if value is None else value for value in (trial, attempt, measured)]
            previous = sha256([previous, *map(str, line)])
            if previous != expected:
                sys.exit(f"{participant}: event {line[0]} is not what was written")
            count += 1
        print(participant, count, previous)


main()
