"""A tour of shapecalculus, in cells ("# %%") that notebooks and editors can run one by one.

    SCC=path/to/scc python examples/tour.py
"""

# %% A service, and two shapes
from fractions import Fraction
from typing import Optional, Sequence, Tuple

from shapecalculus import Body, Fixed, NotPossible, Oracle, ShapeRefused

oracle = Oracle(timeout=60)  # the program of the environment variable SCC, or else the scc on the PATH

# Corners of a cube of side 2; faces counter-clockwise for someone who looks from outside.
CORNERS = [(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
FACES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
NAMES = ["bottom", "top", "front", "back", "left", "right"]

cube = oracle.define_shape(CORNERS, FACES, face_names=NAMES)
turned = oracle.define_shape(CORNERS, FACES, face_names=NAMES, quaternion=(3, 0, 0, 1))
print("cube:", cube.vertices, "vertices, volume", cube.volume)

# %% When do they collide?
# The second cube is at (4, 0, 0) and comes with velocity (-1, 0, 0). Times are fractions.
meeting = oracle.first_time_of_contact(cube, turned, (4, 0, 0), (-1, 0, 0))
print("they meet:", meeting.outcome, meeting.time, "=", float(meeting.time or 0))
print("passing by:", oracle.first_time_of_contact(cube, cube, (4, 2, 0), (-1, 0, 0)).outcome)

# %% How do they touch?
contact = oracle.contact(cube, cube, (2, 1, 0), velocity=(-1, 0, 0))
assert contact.highest is not None
print(contact.relation, contact.highest.first.name, "and", contact.highest.second.name, contact.approaching)
print("corners of the region:", sorted(tuple(map(str, corner)) for corner in contact.region))

# %% What happens then?
after = oracle.response([(cube, cube, (2, 1, 0))], Body(mass=3, velocity=(2, 0, 0)), Body(mass=1, velocity=(0, 0, 0)))
print(after.outcome, *map(str, after.first.velocity), "|", *map(str, after.second.velocity))
wall = oracle.response([(cube, cube, (2, 1, 0))], Body(mass=3, velocity=(2, 0, 0)), Fixed())
print("off a wall:", *map(str, wall.first.velocity))

# %% A shape that is none
try:
    oracle.define_shape(CORNERS, FACES[:-1])
except ShapeRefused as refused:
    print("refused:", refused.data["faults"][0]["code"])

# %% Is your engine right? Ask for many at once.
# A float engine for axis-aligned cubes of side 2, with the mistake that it takes grazes for hits.


def engine(offset: Sequence[int], velocity: Sequence[int]) -> Optional[float]:
    enter, leave = 0.0, float("inf")
    for p, v in zip(offset, velocity):
        if v == 0:
            if abs(p) > 2:
                return None
        else:
            times = sorted(((-2 - p) / v, (2 - p) / v))
            enter, leave = max(enter, times[0]), min(leave, times[1])
    return enter if enter <= leave else None


casts = [((x, y, 0), (-1, v, 0)) for x in range(3, 9) for y in range(-4, 5) for v in (-1, 0, 1)]
answers = oracle.first_times_of_contact((cube, cube, offset, velocity) for offset, velocity in casts)
wrong = [
    (cast, said, answer)
    for cast, answer in zip(casts, answers)
    for said in [engine(*cast)]
    if (said is None) != (answer.time is None)
]
print(len(casts), "casts,", len(wrong), "wrong; the first:", wrong[0])

# %% Other requests go in batches, too
with oracle.batch() as batch:
    futures = [batch.contact(cube, cube, (Fraction(n, 2), 0, 0)) for n in range(1, 7)]
print([future.result().relation for future in futures])

# %% Models
model = oracle.load_model(
    """
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

behaviour Open  on Cube = <bond, {right}>. Bound
behaviour Shut  on Cube = <~bond, {left}>. Bound
behaviour Bound on Cube = eps(2). rho({<bond, {left, right}>}). nil

process p = Cube mass 3 velocity (2,0,0) [Open]
process q = Cube mass 1 at translate (7,0,0) [Shut]
"""
)
# A state is where a path of choices leads; () is the initial state.
path: Tuple[int, ...] = ()
while True:
    here = oracle.successors(model, path)
    if here.ending is not None:
        print("at time", here.time, here.ending)
        break
    print("at time", here.time, [t.label.text for t in here.transitions])
    path = oracle.step(model, path, 0).path

assert here.state is not None
print("q ends at", *map(str, here.state.leaf("q").position), "with", *map(str, here.state.process_of("q").velocity))
print("distance, after one choice:", oracle.evaluate(model, "x(q) - x(p)", path[:1]).value)
print("ever bound:", oracle.evaluate(model, "EF bound(p, q)").verdict)
try:
    oracle.step(model, (), 7)
except NotPossible as refused_step:
    print("no choice 7; possible:", refused_step.data["possible"])

# %% The end
oracle.close()
