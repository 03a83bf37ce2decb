#!/usr/bin/env python3
"""Numbers of convex pieces of random simple polygons: lib/solids/polygon beside CGAL's optimal_convex_partition_2.

    test/outside/polygons/compare.py [COUNT [CORNERS [SEED]]]

By hand: needs a C++ compiler and CGAL (Debian: g++, libcgal-dev), which it installs where apt-get can, and builds both
programs. Corners are in general position, since CGAL says nothing of straight angles.
"""

import os
import random
import subprocess
import sys
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.join(HERE, '..', '..', '..')


def cross(o, a, b):
    return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])


def meet(a, b, c, d):
    return cross(a, b, c) * cross(a, b, d) <= 0 and cross(c, d, a) * cross(c, d, b) <= 0


def polygon(n, size, rng):
    """A tour of random points, turned around between edges that cross until none do."""
    while True:
        points = list({(rng.randrange(size), rng.randrange(size)) for _ in range(n)})
        rng.shuffle(points)
        for _ in range(40 * n):
            k = len(points)
            found = next(((i, j) for i in range(k) for j in range(i + 2, k) if not (i == 0 and j == k - 1)
                          and meet(points[i], points[i + 1], points[j], points[(j + 1) % k])), None)
            if found is None:
                break
            i, j = found
            points[i + 1:j + 1] = reversed(points[i + 1:j + 1])
        else:
            continue
        k = len(points)
        if any(cross(points[i - 2], points[i - 1], points[i]) == 0 for i in range(k)):
            continue
        area = sum(points[i - 1][0] * points[i][1] - points[i - 1][1] * points[i][0] for i in range(k))
        return points if area > 0 else points[::-1]


def installed():
    for header in ('/usr/include/CGAL/partition_2.h', '/usr/local/include/CGAL/partition_2.h'):
        if os.path.exists(header):
            return
    subprocess.run(['apt-get', 'install', '-y', '--no-install-recommends', 'g++', 'libcgal-dev'], check=True,
                   stdout=subprocess.DEVNULL)


def main():
    count, corners, seed = ([int(a) for a in sys.argv[1:]] + [200, 16, 1][len(sys.argv) - 1:])[:3]
    rng = random.Random(seed)
    polygons = [polygon(rng.randint(4, corners), 1000, rng) for _ in range(count)]
    text = ''.join('%d %s\n' % (len(p), ' '.join('%d %d' % q for q in p)) for p in polygons)
    installed()
    with tempfile.TemporaryDirectory() as folder:
        peer = os.path.join(folder, 'convex')
        subprocess.run(['g++', '-O2', '-o', peer, os.path.join(HERE, 'convex.cpp'), '-lgmp', '-lmpfr'], check=True)
        subprocess.run(['dune', 'build', '--profile', 'release', 'test/outside/polygons/ours.exe'], cwd=ROOT, check=True)
        answers = []
        for command in ([peer], [os.path.join(ROOT, '_build/default/test/outside/polygons/ours.exe')]):
            start = time.time()
            out = subprocess.run(command, input=text, capture_output=True, text=True, check=True).stdout.split()
            answers.append(out)
            print('%s: %.2f s, %d pieces' % (os.path.basename(command[0]), time.time() - start, sum(map(int, out))))
    differ = [(p, a, b) for p, a, b in zip(polygons, *answers) if a != b]
    for p, a, b in differ[:5]:
        print('differ: CGAL %s, ours %s: %s' % (a, b, p))
    print('%d polygons, %d differ' % (count, len(differ)))
    return 1 if differ or len(answers[0]) != count or len(answers[1]) != count else 0


if __name__ == '__main__':
    sys.exit(main())
