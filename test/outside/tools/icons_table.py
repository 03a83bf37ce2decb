"""Which icons of some sets come through scc inflate, why the others do not, and whether the silhouettes are right.

  icons_table.py SCC FOLDER... [--count N] [--resolution R]

Each folder holds one set. Of each, N drawings (*.svg) are taken, at equal steps through the sorted names. Files larger
than 100 kB, which hold a whole set at once, are left out. A drawing
comes through if `scc inflate --pieces plate` writes a solid that `scc decompose` cuts into convex parts. Its
silhouette is taken from `scc inflate --pieces apart --faces all`, whose front has a vertex over each pixel. Resvg
renders the same drawing with eight times as many pixels each way, without scc: a pixel that it covers by at least 5/8
should be in the silhouette, and one that it covers by at most 3/8 should not. Where lines cross in a pixel, scc adds
up what each one covers, as programs do that draw one over the other: up to four pixels may differ.
"""

import argparse
import collections
import io
import os
import re
import subprocess
import tempfile
from fractions import Fraction

import numpy as np
import resvg_py
from PIL import Image

COLUMNS = ("icons", "in one piece", "on a plate", "refused", "parts", "silhouettes", "other silhouettes")
FINER = 8
LARGEST = 100_000


def call(scc, *words):
    done = subprocess.run([scc, *words, "--seconds", "60"] if words[0] == "decompose" else [scc, *words],
                          capture_output=True, text=True, errors="replace", timeout=600)
    return done.returncode, done.stdout, " ".join(done.stderr.split())


def short(message, path):
    found = re.search(r"error\[(SC\d+)\]: (.*?)(?= (?:error|warning|hint|note)\b|$)", message.replace(path, "FILE"))
    return f"{found[1]}: {found[2][:100]}" if found else message[:100]


def drawings(folder, count):
    found = sorted(os.path.join(place, name) for place, _, names in os.walk(folder) for name in names
                   if name.lower().endswith(".svg") and os.path.getsize(os.path.join(place, name)) <= LARGEST)
    taken = min(count, len(found))
    return [found[k * len(found) // taken] for k in range(taken)]


def silhouette(out, width, height):
    inside = np.zeros((height, width), bool)
    with open(out, encoding="utf-8") as file:
        for line in file:
            word, *rest = line.split()
            if word == "v" and Fraction(rest[2]) > 0:
                x, y = Fraction(rest[0]), Fraction(rest[1])
                inside[int(Fraction(height - 1, 2) - y), int(x + Fraction(width - 1, 2))] = True
    return inside


def coverage(path, width, height):
    """Of each pixel, by resvg: 0 to 1."""
    data = resvg_py.svg_to_bytes(svg_path=path, width=FINER * width, height=FINER * height, skip_system_fonts=True)
    alpha = np.asarray(Image.open(io.BytesIO(bytes(data))).convert("RGBA"))[:, :, 3] >= 128
    if alpha.shape != (FINER * height, FINER * width):
        return None
    return alpha.reshape(height, FINER, width, FINER).mean(axis=(1, 3))


def compare(scc, path, resolution, work):
    """How many pixels are in one silhouette and not in the other; None if there is nothing to compare."""
    out = os.path.join(work, "all.obj")
    code, told, _ = call(scc, "inflate", path, "--resolution", str(resolution), "--pieces", "apart", "--faces", "all",
                         "-o", out)
    found = re.search(r": (\d+) x (\d+) pixels", told)
    if code or not found:
        return None
    width, height = int(found[1]), int(found[2])
    ours, theirs = silhouette(out, width, height), coverage(path, width, height)
    if theirs is None:
        return None
    return int(((theirs >= 0.625) & ~ours).sum() + ((theirs <= 0.375) & ours).sum())


def one(scc, path, resolution, work, line):
    words = ["inflate", path, "--resolution", str(resolution), "-o", os.path.join(work, "solid.obj")]
    line["icons"] += 1
    code, _, _ = call(scc, *words)
    if code == 0:
        line["in one piece"] += 1
    code, _, message = call(scc, *words, "--pieces", "plate")
    if code:
        line["refused"] += 1
        return f"refused {short(message, path)}"
    line["on a plate"] += 1
    code, _, message = call(scc, "decompose", os.path.join(work, "solid.obj"))
    if code == 0:
        line["parts"] += 1
    told = [] if code == 0 else [f"no parts: {code} {short(message, path)}"]
    off = compare(scc, path, resolution, work)
    if off is not None:
        line["silhouettes"] += 1
        if off > 4:
            line["other silhouettes"] += 1
            told.append(f"{off} pixels are not as resvg has them")
    return "; ".join(told)


def main():
    reader = argparse.ArgumentParser()
    reader.add_argument("scc")
    reader.add_argument("folders", nargs="+")
    reader.add_argument("--count", type=int, default=50)
    reader.add_argument("--resolution", type=int, default=64)
    options = reader.parse_args()
    table = {}
    for folder in options.folders:
        line = table[os.path.basename(os.path.normpath(folder))] = collections.Counter()
        for path in drawings(folder, options.count):
            with tempfile.TemporaryDirectory() as work:
                told = one(options.scc, path, options.resolution, work, line)
            if told:
                print(f"{os.path.relpath(path, folder)}: {told}", flush=True)
    print("| set | " + " | ".join(COLUMNS) + " |")
    print("|---" * (len(COLUMNS) + 1) + "|")
    for name, line in table.items():
        print(f"| {name} | " + " | ".join(str(line[c]) for c in COLUMNS) + " |")
    total = sum(table.values(), collections.Counter())
    print(f"{total['parts']} of {total['icons']} icons come through ({100 * total['parts'] / total['icons']:.1f} %), "
          f"{total['other silhouettes']} of {total['silhouettes']} silhouettes are others")


if __name__ == "__main__":
    main()
