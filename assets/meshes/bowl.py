#!/usr/bin/env python3
# python3 assets/meshes/bowl.py > assets/meshes/bowl.obj
# A bowl of radius 1 m and depth 0.8 m around the y axis, standing on a round foot at y = 0, with a wall 0.06 m thick and
# a round rim, as a closed surface of triangles.
import math

AROUND = 36  # vertices of a ring
UP = 8  # rings of a side
WALL = 0.06  # m
FOOT = 0.04, 0.45  # m: height, radius


def profile():
    """(r, y) from the middle of the inside over the rim to the middle of the outside."""
    angles = [0.5 * math.pi * k / UP for k in range(1, UP + 1)]
    height, radius = FOOT
    inside = [(math.sin(a), height + WALL + (0.8 - WALL) * (1 - math.cos(a))) for a in angles]
    rim = [(1 + WALL / 2, height + 0.8 + WALL / 2)]
    outside = [((1 + WALL) * math.sin(a), height + 0.8 * (1 - math.cos(a))) for a in reversed(angles)]
    return inside + rim + [at for at in outside if at[0] > 1.2 * radius] + [(1.1 * radius, 1.5 * height), (radius, 0)]


rings = profile()
print("# python3 assets/meshes/bowl.py")
print(f"v 0 {FOOT[0] + WALL} 0")
for r, y in rings:
    for k in range(AROUND):
        angle = 2 * math.pi * k / AROUND
        print(f"v {r * math.cos(angle):.5f} {y:.5f} {r * math.sin(angle):.5f}")
print("v 0 0 0")
last = 2 + len(rings) * AROUND


def vertex(ring, k):
    return 2 + ring * AROUND + k % AROUND


# Counter-clockwise seen from outside: up on the inside of the bowl.
for k in range(AROUND):
    print("f", 1, vertex(0, k + 1), vertex(0, k))
    print("f", last, vertex(len(rings) - 1, k), vertex(len(rings) - 1, k + 1))
    for ring in range(len(rings) - 1):
        a, b, c, d = vertex(ring, k), vertex(ring, k + 1), vertex(ring + 1, k + 1), vertex(ring + 1, k)
        print("f", a, b, c)
        print("f", a, c, d)
