#!/usr/bin/env python3
# python3 assets/meshes/hare.py > assets/meshes/hare.obj
# A hare with ears and fingers, 1 m tall, as a closed surface of triangles: where the smoothly joined distances to some
# capsules are 0, found on a cubic grid whose cubes are cut into six tets (marching tetrahedra).
import itertools
import math

STEP = 0.0203  # m, side of the cubes
JOIN = 0.025  # m, how smoothly parts are joined

# From, to, radius at both ends.
CAPSULES = [
    ((0, 0.24, 0), (0, 0.45, 0), 0.15, 0.11),  # body
    ((0, 0.62, 0.02), (0, 0.62, 0.05), 0.12, 0.105),  # head
]
for side in (-1, 1):
    CAPSULES += [
        ((side * 0.05, 0.70, 0), (side * 0.10, 0.96, -0.03), 0.030, 0.034),  # ear
        ((side * 0.09, 0.16, 0), (side * 0.12, 0.06, 0.10), 0.075, 0.050),  # foot
        ((side * 0.10, 0.43, 0), (side * 0.30, 0.40, 0.10), 0.045, 0.036),  # arm
        ((side * 0.31, 0.40, 0.11), (side * 0.37, 0.45, 0.13), 0.020, 0.017),  # fingers
        ((side * 0.31, 0.40, 0.11), (side * 0.39, 0.40, 0.15), 0.020, 0.017),
        ((side * 0.31, 0.40, 0.11), (side * 0.37, 0.35, 0.16), 0.020, 0.017),
        ((side * 0.30, 0.41, 0.12), (side * 0.29, 0.46, 0.19), 0.020, 0.017),  # thumb
    ]


def distance(p):
    """-JOIN log sum exp(-d/JOIN) over the capsules."""
    total = 0.0
    for a, b, r, s in CAPSULES:
        axis = [b[i] - a[i] for i in range(3)]
        arm = [p[i] - a[i] for i in range(3)]
        t = sum(x * y for x, y in zip(axis, arm)) / sum(x * x for x in axis)
        t = min(1.0, max(0.0, t))
        away = math.sqrt(sum((arm[i] - t * axis[i]) ** 2 for i in range(3)))
        total += math.exp(min(-(away - r - t * (s - r)) / JOIN, 50.0))
    return -JOIN * math.log(total)


LOW, HIGH = (-0.46, -0.03, -0.20), (0.46, 1.04, 0.26)
COUNT = [int((h - l) / STEP) + 2 for l, h in zip(LOW, HIGH)]


def place(c):
    return [LOW[i] + STEP * c[i] for i in range(3)]


grid = {c: distance(place(c)) for c in itertools.product(*(range(n) for n in COUNT))}
# Six tets around the diagonal of a cube, one for each order of the axes.
TETS = []
for order in itertools.permutations(range(3)):
    corner, tet = [0, 0, 0], [(0, 0, 0)]
    for axis in order:
        corner[axis] = 1
        tet.append(tuple(corner))
    TETS.append(tet)

vertices, numbers, faces = [], {}, []


def cut(a, b):
    key = (a, b) if a < b else (b, a)
    if key not in numbers:
        da, db = grid[a], grid[b]
        t = min(0.98, max(0.02, da / (da - db)))
        vertices.append([x + t * (y - x) for x, y in zip(place(a), place(b))])
        numbers[key] = len(vertices)
    return numbers[key]


def face(a, b, c, inside):
    p, q, r = (vertices[i - 1] for i in (a, b, c))
    u, v = [q[i] - p[i] for i in range(3)], [r[i] - p[i] for i in range(3)]
    n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    outwards = sum(n[i] * (p[i] - place(inside)[i]) for i in range(3)) > 0
    faces.append((a, b, c) if outwards else (a, c, b))


for cell in itertools.product(*(range(n - 1) for n in COUNT)):
    corners = [tuple(cell[i] + d[i] for i in range(3)) for d in itertools.product((0, 1), repeat=3)]
    inside_count = sum(grid[c] < 0 for c in corners)
    if inside_count in (0, 8):
        continue
    for tet in TETS:
        tet = [tuple(cell[i] + d[i] for i in range(3)) for d in tet]
        inner = [c for c in tet if grid[c] < 0]
        outer = [c for c in tet if grid[c] >= 0]
        if len(inner) == 1 or len(outer) == 1:
            lone, others = (inner[0], outer) if len(inner) == 1 else (outer[0], inner)
            face(*(cut(lone, o) for o in others), inner[0])
        elif len(inner) == 2:
            a, b, c, d = (cut(inner[i], outer[j]) for i, j in ((0, 0), (0, 1), (1, 1), (1, 0)))
            face(a, b, c, inner[0])
            face(a, c, d, inner[0])

print("# made by assets/meshes/hare.py")
for v in vertices:
    print("v %.4f %.4f %.4f" % tuple(v))
for f in faces:
    print("f %d %d %d" % f)
