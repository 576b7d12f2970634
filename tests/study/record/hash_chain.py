#!/usr/bin/env python3
"""Checks the hash chains of a study's file as schema.sql describes them: an outsider's program.

Prints each session's participant, number of events and last hash; fails at the first event whose
hash is not what it says.
"""
import hashlib
import json
import sqlite3
import sys

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
    ("session", "id", "id state", "1"),
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
        lines += [as_line(value for name, value in zip(names, row) if name not in left_out.split())
                  for row in rows]
    return sha256(lines)


def main():
    study = sqlite3.connect(f"file:{sys.argv[1]}?mode=ro", uri=True)
    for session, participant in study.execute("SELECT id, participant FROM session ORDER BY id"):
        previous = hash_before_events(study, session)
        count = 0
        for *line, expected in study.execute(
                "SELECT sequence, time_ns, utc, type, payload, hash FROM event WHERE session = ?"
                " ORDER BY sequence", [session]):
            previous = sha256([previous, *map(str, line)])
            if previous != expected:
                sys.exit(f"{participant}: event {line[0]} is not what was written")
            count += 1
        print(participant, count, previous)


main()
