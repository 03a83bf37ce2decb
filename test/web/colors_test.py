"""The colours of the page: seen on what is below them, and told apart also by those who see fewer colours.

    colors_test.py WEB

Contrasts are those of WCAG 2.2: 4.5 for text, 3 for lines and marks (1.4.3, 1.4.11). For people without one kind of cones,
colours are projected as by Viénot, Brettel and Mollon (1999), in linear light. Differences are those of CIE 1976 (L*a*b*).
The last line is 'N passed, N failed'.
"""

import re
import sys
from itertools import combinations
from pathlib import Path

KINDS = ['time', 'bind', 'close', 'bounce', 'absorb', 'weak', 'strong', 'draw']
#: Marks that lie side by side, and have no words there: bars of the timeline.
LEAST = {'all': 15, 'protanopia': 8, 'deuteranopia': 8}

# Linear RGB to linear RGB.
SEEN = {
    'all': ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    'protanopia': ((0.11238, 0.88762, 0), (0.11238, 0.88762, 0), (0.00401, -0.00401, 1)),
    'deuteranopia': ((0.29275, 0.70725, 0), (0.29275, 0.70725, 0), (-0.02234, 0.02234, 1)),
}


def linear(text):
    parts = [int(text[i:i + 2], 16) / 255 for i in (1, 3, 5)]
    return [x / 12.92 if x <= 0.04045 else ((x + 0.055) / 1.055) ** 2.4 for x in parts]


def luminance(c):
    return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]


def contrast(a, b):
    low, high = sorted([luminance(linear(a)), luminance(linear(b))])
    return (high + 0.05) / (low + 0.05)


def lab(c):
    xyz = [sum(m * x for m, x in zip(row, c)) for row in
           ((0.4124 / 0.9505, 0.3576 / 0.9505, 0.1805 / 0.9505), (0.2126, 0.7152, 0.0722), (0.0193 / 1.089, 0.1192 / 1.089, 0.9505 / 1.089))]
    f = [t ** (1 / 3) if t > 0.008856 else 7.787 * t + 16 / 116 for t in (max(0, x) for x in xyz)]
    return 116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])


def difference(a, b, eye):
    one, two = (lab([sum(m * x for m, x in zip(row, linear(c))) for row in SEEN[eye]]) for c in (a, b))
    return sum((p - q) ** 2 for p, q in zip(one, two)) ** 0.5


def themes(css):
    light = css.split(':root {', 1)[1].split('}', 1)[0]
    dark = css.split(':root[data-theme="dark"] {', 1)[1].split('}', 1)[0]
    read = lambda text: dict(re.findall(r'--([a-z-]+): (#[0-9a-f]{6})', text))
    return {'light': read(light), 'dark': {**read(light), **read(dark)}}


def faults(name, c):
    texts = [('text', 'back'), ('text', 'panel'), ('text', 'raised'), ('text', 'soft'), ('quiet', 'panel'), ('quiet', 'raised'), ('accent', 'panel'), ('accent', 'soft'),
             ('accent-text', 'accent'), ('good', 'good-soft'), ('bad', 'bad-soft'), ('open', 'open-soft'), ('bad', 'panel')]
    for ink, below in texts:
        if contrast(c[ink], c[below]) < 4.5:
            yield f'{name}: text {ink} on {below}: {contrast(c[ink], c[below]):.2f}'
    for mark in [f'k-{kind}' for kind in KINDS] + ['good', 'bad', 'open', 'focus']:
        if contrast(c[mark], c['panel']) < 3:
            yield f'{name}: mark {mark}: {contrast(c[mark], c["panel"]):.2f}'
    for eye, least in LEAST.items():
        for a, b in combinations(KINDS, 2):
            found = difference(c[f'k-{a}'], c[f'k-{b}'], eye)
            if found < least:
                yield f'{name}: {a} and {b}, {eye}: {found:.1f}'
        for a, b in [('good', 'bad'), ('good', 'open'), ('bad', 'open')]:
            found = difference(c[a], c[b], eye)
            if found < least:
                yield f'{name}: {a} and {b}, {eye}: {found:.1f}'


def main():
    found = {name: list(faults(name, colours)) for name, colours in themes((Path(sys.argv[1]) / 'base.css').read_text()).items()}
    for wrong in found.values():
        for line in wrong:
            print(f'failed: {line}')
    print(f'{sum(not wrong for wrong in found.values())} passed, {sum(bool(wrong) for wrong in found.values())} failed')


if __name__ == '__main__':
    main()
