"""Every trace that scc writes conforms to its model, whatever the options: drawn at random, for every model.

usage: trace_conform_test.py SCC MODELS [ROUNDS]
"""

import glob
import os
import random
import re
import subprocess
import sys
import tempfile

# Longer runs of bodies that turn have numbers too long for a test.
STEPS = (0, 1, 2, 3, 5, 8, 13)


def options(draw):
    chosen = []
    steps = draw.choice(STEPS)
    if draw.random() < 0.7:
        time = draw.choice(['0', '1/3', '1', '3/2', '7/4', '5', '63/8', '40'])
        chosen += ['--time', time]
    chosen += ['--steps', str(steps)]
    if draw.random() < 0.5:
        chosen += ['--choose', 'random:%d' % draw.randrange(1000)]
    if draw.random() < 0.5:
        chosen += ['--states', draw.choice(['all', 'ends'])]
    return chosen


def is_open(model):
    """Its start or the instants of its splits are left open: traces are compared with models that are known (SC0902)."""
    with open(model, encoding='utf-8') as file:
        return re.search(r'^(param \w+ in [\[(]|split_step any)', file.read(), re.M) is not None


def main():
    scc, models = sys.argv[1:3]
    rounds = int(sys.argv[3]) if len(sys.argv) > 3 else 3
    draw = random.Random(14)
    passed = failed = 0
    with tempfile.TemporaryDirectory() as folder:
        trace = os.path.join(folder, 'run.jsonl')
        for model in sorted(glob.glob(os.path.join(models, '*.sc')) + glob.glob(os.path.join(models, 'laws', '*.sc'))):
            for _ in range(rounds):
                chosen = options(draw)
                if is_open(model):
                    continue
                run = subprocess.run([scc, 'trace', model, '-o', trace] + chosen, capture_output=True, text=True)
                if run.returncode not in (0, 2, 4):
                    print('FAIL %s %s: exit %d\n%s' % (model, ' '.join(chosen), run.returncode, run.stderr))
                    failed += 1
                    continue
                told = subprocess.run([scc, 'conform', model, trace], capture_output=True, text=True)
                if told.returncode == 0:
                    passed += 1
                else:
                    failed += 1
                    print('FAIL %s %s: %s%s' % (model, ' '.join(chosen), told.stdout, told.stderr))
    print('%d passed, %d failed' % (passed, failed))
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
