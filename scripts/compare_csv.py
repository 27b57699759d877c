#!/usr/bin/env python3
"""Compares CSV files of `simulate`, scene by scene, with those of the first directory.

usage: compare_csv.py DIRECTORY...
"""
import csv
import pathlib
import sys

# columns of one kind share a scale: that of the greatest magnitude in the scene
KINDS = {'position': slice(2, 5), 'attitude': slice(5, 9), 'velocity': slice(9, 12),
         'turning': slice(12, 15)}


def rows(path):
    with open(path, newline='') as file:
        return [[row[0], row[1]] + [float(x) for x in row[2:]] for row in list(csv.reader(file))[1:]]


def difference(reference, other):
    """The greatest of the differences of each kind over that kind's greatest magnitude."""
    assert [r[:2] for r in reference] == [r[:2] for r in other], 'other instants or bodies'
    worst = 0.0
    for kind in KINDS.values():
        scale = max(abs(x) for row in reference for x in row[kind])
        if scale == 0:
            scale = 1.0
        worst = max([worst] + [abs(x - y) / scale for a, b in zip(reference, other)
                               for x, y in zip(a[kind], b[kind])])
    return worst


directories = [pathlib.Path(name) for name in sys.argv[1:]]
print('| scene | ' + ' | '.join(d.name for d in directories[1:]) + ' |')
print('|---' * len(directories) + '|')
for path in sorted(directories[0].glob('*.csv')):
    reference = rows(path)
    cells = []
    for directory in directories[1:]:
        same = path.read_bytes() == (directory / path.name).read_bytes()
        cells.append('same bytes' if same else
                     f'{difference(reference, rows(directory / path.name)):.0e}')
    print(f'| {path.stem} | ' + ' | '.join(cells) + ' |')
