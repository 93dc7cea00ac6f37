#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prints measured tables, tables/NAME.csv, in Markdown. README.md says what is in them.

usage: python3 tables.py [NAME...]
"""

import csv
import sys

import measure

FOLDER = measure.HERE / "tables"

for name in sys.argv[1:] or sorted(file.stem for file in FOLDER.glob("*.csv")):
    with open(FOLDER / f"{name}.csv", encoding="ascii", newline="") as stream:
        columns, *rows = csv.reader(stream)
    if any(len(row) != len(columns) for row in rows):
        sys.exit(f"{name}.csv: a row does not have as many cells as there are columns.")
    measure.print_table(name, columns, rows)
