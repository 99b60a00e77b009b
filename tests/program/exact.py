"""Thiessen weights in exact rational arithmetic, straight from the definition.

Nothing is shared with the program: a gauge's part of a basin is the basin's ring cut by the half-plane of every other
gauge. Cutting a ring that is not convex may leave bridges along the cutting line, but they enclose nothing, so that the
area, signed by the ring's direction, is exact all the same.
"""

from fractions import Fraction


def area(ring):
    """The signed area of a ring of (x, y), counter-clockwise positive."""
    ahead = ring[1:] + ring[:1]
    return sum((a[0] * b[1] - b[0] * a[1] for a, b in zip(ring, ahead)), Fraction(0)) / 2


def cut(ring, near, far):
    """The part of a ring that is at least as near to the point `near` as to the point `far`."""
    nx, ny = far[0] - near[0], far[1] - near[1]
    limit = (far[0] ** 2 - near[0] ** 2 + far[1] ** 2 - near[1] ** 2) / Fraction(2)
    beyond = [nx * x + ny * y - limit for x, y in ring]
    kept = []
    for i, here in enumerate(ring):
        j = (i + 1) % len(ring)
        if beyond[i] <= 0:
            kept.append(here)
        if beyond[i] * beyond[j] < 0:
            t = beyond[i] / (beyond[i] - beyond[j])
            kept.append(tuple(p + t * (q - p) for p, q in zip(here, ring[j])))
    return kept


def weights(gauges, basin):
    """{id: weight}, positive weights only.

    gauges: {id: (x, y)}, all at different places. basin: rings, outer ones counter-clockwise and holes clockwise.
    """
    total = sum(area(ring) for ring in basin)
    found = {}
    for name, place in gauges.items():
        part = Fraction(0)
        for ring in basin:
            for other in gauges.values():
                if other != place:
                    ring = cut(ring, place, other)
            part += area(ring)
        if part > 0:
            found[name] = part / total
    return found
