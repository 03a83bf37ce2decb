#!/usr/bin/env python3
import json
import sys
from fractions import Fraction

shapes = {}


class NotDone(Exception):
    pass


def numbers(vector):
    return [Fraction(a) for a in vector]


def define(params):
    """A box, as its least and greatest corner."""
    points = [numbers(v) for v in params["vertices"]]
    low, high = [min(c) for c in zip(*points)], [max(c) for c in zip(*points)]
    corners = {(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)}
    found = {tuple(int(p[i] == high[i]) for i in range(3)) for p in points if all(
        p[i] in (low[i], high[i]) for i in range(3))}
    if len(points) != 8 or found != corners or len(params["faces"]) != 6 or "linear" in params or "quaternion" in params:
        raise NotDone
    handle = "s%d" % (len(shapes) + 1)
    shapes[handle] = (low, high)
    return {"shape": handle}


def first_time_of_contact(params):
    if set(params) != {"a", "b", "offset", "velocity"}:
        raise NotDone  # spins
    (low_a, high_a), (low_b, high_b) = shapes[params["a"]], shapes[params["b"]]
    start, end = None, None
    for i, (at, speed) in enumerate(zip(numbers(params["offset"]), numbers(params["velocity"]))):
        # The interiors overlap along this axis while at + t speed is strictly between these.
        low, high = low_a[i] - high_b[i], high_a[i] - low_b[i]
        if speed == 0:
            if not low < at < high:
                return {"outcome": "never", "time": None}
        else:
            enters, leaves = sorted([(low - at) / speed, (high - at) / speed])
            start = enters if start is None else max(start, enters)
            end = leaves if end is None else min(end, leaves)
    if start is None:
        return {"outcome": "inside", "time": None}
    if start >= end or end <= 0:
        return {"outcome": "never", "time": None}
    if start < 0:
        return {"outcome": "inside", "time": None}
    return {"outcome": "at", "time": str(start)}


methods = {"shape.define": define, "first_time_of_contact": first_time_of_contact}
for line in sys.stdin:
    request = json.loads(line)
    answer = {"jsonrpc": "2.0", "id": request["id"]}
    try:
        answer["result"] = methods[request["method"]](request["params"])
    except (KeyError, NotDone):
        answer["error"] = {"code": -32601, "message": "not done"}
    print(json.dumps(answer), flush=True)
