#!/usr/bin/env python3
"""Writes the meshes of config/meshes, without any input.

  wing_nut.stl   a hub with a hole and two wings, flat, three different moments of inertia
  l_bracket.obj  two legs of different length

Units are metres. Usage: make_meshes.py [directory]
"""

import math
import pathlib
import struct
import sys


def extruded(outer, inner, thickness):
    """The prism between two outlines of equally many points, the inner one a hole."""
    n = len(outer)
    half = thickness / 2
    vertices = [(x, y, z) for z in (-half, half) for x, y in outer + inner]
    triangles = []

    def quad(a, b, c, d):
        triangles.extend([(a, b, c), (a, c, d)])

    for i in range(n):
        j = (i + 1) % n
        low_out, low_in = (i, j), (n + i, n + j)
        high_out, high_in = (2 * n + i, 2 * n + j), (3 * n + i, 3 * n + j)
        quad(low_out[0], low_out[1], high_out[1], high_out[0])
        quad(low_in[1], low_in[0], high_in[0], high_in[1])
        quad(high_out[0], high_out[1], high_in[1], high_in[0])
        quad(low_out[1], low_out[0], low_in[0], low_in[1])
    return vertices, triangles


def wing_nut():
    """Hub of radius 8 mm, hole of 4 mm, wings that reach 30 mm along x, 6 mm thick."""
    angles = [2 * math.pi * k / 96 for k in range(96)]
    reach = [0.008 + 0.022 * abs(math.cos(a)) ** 8 for a in angles]
    outer = [(r * math.cos(a), r * math.sin(a)) for r, a in zip(reach, angles)]
    inner = [(0.004 * math.cos(a), 0.004 * math.sin(a)) for a in angles]
    return extruded(outer, inner, 0.006)


def prism(outline, fan, thickness):
    """The prism over an outline, whose faces are divided into the triangles of fan."""
    n = len(outline)
    vertices = [(x, y, z) for z in (0, thickness) for x, y in outline]
    triangles = [(a, c, b) for a, b, c in fan] + [(n + a, n + b, n + c) for a, b, c in fan]
    for i in range(n):
        j = (i + 1) % n
        triangles.extend([(i, j, n + j), (i, n + j, n + i)])
    return vertices, triangles


def l_bracket():
    """Legs of 0.3 m and 0.2 m, 0.05 m wide and 0.1 m deep, the outer corner at the origin."""
    outline = [(0, 0), (0.3, 0), (0.3, 0.05), (0.05, 0.05), (0.05, 0.2), (0, 0.2)]
    return prism(outline, [(0, 1, 2), (0, 2, 3), (0, 3, 5), (3, 4, 5)], 0.1)


def normal(a, b, c):
    u = [b[i] - a[i] for i in range(3)]
    v = [c[i] - a[i] for i in range(3)]
    n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    length = math.sqrt(sum(x * x for x in n))
    return [x / length for x in n]


def write_stl(path, mesh):
    vertices, triangles = mesh
    with open(path, 'wb') as file:
        file.write(b'rigid_body_sim, metres'.ljust(80, b'\0'))
        file.write(struct.pack('<I', len(triangles)))
        for triangle in triangles:
            corners = [vertices[i] for i in triangle]
            numbers = normal(*corners) + [x for corner in corners for x in corner]
            file.write(struct.pack('<12fH', *numbers, 0))


def write_obj(path, mesh):
    vertices, triangles = mesh
    with open(path, 'w', newline='\n') as file:
        file.write('# rigid_body_sim, metres\n')
        for vertex in vertices:
            file.write('v {:g} {:g} {:g}\n'.format(*vertex))
        for triangle in triangles:
            file.write('f {} {} {}\n'.format(*(i + 1 for i in triangle)))


def main():
    here = pathlib.Path(__file__).resolve().parent
    directory = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else here.parent / 'config/meshes'
    directory.mkdir(parents=True, exist_ok=True)
    write_stl(directory / 'wing_nut.stl', wing_nut())
    write_obj(directory / 'l_bracket.obj', l_bracket())


if __name__ == '__main__':
    main()
