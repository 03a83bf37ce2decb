"""Whether scc inflate and resvg agree about which pixels of random SVG drawings are at least half opaque.

  opacity_check.py SCC [--count N] [--seed S]

Rectangles on whole pixels lie over each other in groups, inner drawings and uses, each with opacities of its own. Resvg
counts in bytes, so that pixels within five levels of half opaque are left out.
"""

import argparse
import io
import os
import random
import subprocess
import tempfile
from fractions import Fraction

import resvg_py
from PIL import Image

SIDE = 32
DEFS = """<defs><linearGradient id="g1"><stop stop-color="red" stop-opacity=".45"/><stop offset="1" stop-opacity=".45"/>
</linearGradient><linearGradient id="g2" href="#g1"/><g id="u" opacity=".7"><rect width="9" height="9" opacity=".5"/>
<rect x="3" y="3" width="9" height="9" opacity=".6"/></g></defs>"""


def opacity(rnd):
    return rnd.choice(["", f' opacity="{rnd.randrange(2, 10) / 10}"'])


def paint(rnd):
    alpha = rnd.randrange(1, 100) / 100
    return rnd.choice([
        "", f' fill-opacity="{alpha}"', f' fill="rgba({rnd.randrange(256)},1,2,{alpha})"',
        f' style="fill:#123456{rnd.randrange(256):02x}"', ' fill="url(#g1)"',
        f' fill="url(#g2)" fill-opacity="{alpha}"', f' stroke="red" stroke-width="2" stroke-opacity="{alpha}"'])


def content(rnd, depth):
    out = []
    for _ in range(rnd.randrange(1, 4)):
        kind = rnd.randrange(6)
        if depth and kind < 2:
            out.append(f"<g{opacity(rnd)}>{content(rnd, depth - 1)}</g>")
        elif depth and kind == 2:
            out.append(f'<svg{opacity(rnd)} x="{rnd.randrange(9)}" width="20" height="20">'
                       f"{content(rnd, depth - 1)}</svg>")
        elif kind == 3:
            out.append(f'<use href="#u" x="{rnd.randrange(20)}"{opacity(rnd)}/>')
        else:
            x, y, w, h = rnd.randrange(24), rnd.randrange(24), rnd.randrange(4, 16), rnd.randrange(4, 16)
            out.append(f'<rect x="{x}" y="{y}" width="{w}" height="{h}"{paint(rnd)}{opacity(rnd)}/>')
    return "".join(out)


def silhouette(path):
    half = Fraction(SIDE - 1, 2)
    with open(path, encoding="utf-8") as file:
        places = [[Fraction(q) for q in line.split()[1:]] for line in file if line.startswith("v ")]
    return {(int(x + half), int(half - y)) for x, y, z in places if z > 0}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scc")
    parser.add_argument("--count", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    rnd = random.Random(given.seed)
    pixels = near = differ = empty = 0
    with tempfile.TemporaryDirectory() as folder:
        svg, obj = os.path.join(folder, "a.svg"), os.path.join(folder, "a.obj")
        for number in range(given.count):
            text = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {SIDE} {SIDE}" width="{SIDE}" '
                    f'height="{SIDE}"{opacity(rnd)}>{DEFS}{content(rnd, 3)}</svg>')
            with open(svg, "w", encoding="utf-8") as file:
                file.write(text)
            done = subprocess.run([given.scc, "inflate", svg, "--resolution", str(SIDE), "--pieces", "apart", "--faces",
                                   "all", "-o", obj], capture_output=True, text=True)
            if done.returncode and "SC0343" not in done.stderr:
                raise SystemExit(f"drawing {number}: {done.stderr}\n{text}")
            inside = silhouette(obj) if done.returncode == 0 else set()
            empty += done.returncode != 0
            image = Image.open(io.BytesIO(bytes(resvg_py.svg_to_bytes(svg_string=text)))).convert("RGBA")
            for x in range(SIDE):
                for y in range(SIDE):
                    alpha = image.getpixel((x, y))[3]
                    pixels += 1
                    if abs(alpha - 127.5) < 5:
                        near += 1
                    elif (alpha > 127) != ((x, y) in inside):
                        differ += 1
                        print(f"drawing {number}, pixel {x}, {y}: {alpha} of 255\n{text}")
    print(f"{given.count} drawings ({empty} empty), {pixels} pixels: {near} near half, {differ} differ")


main()
