#!/usr/bin/env python3
"""The termination of owners that go in no order, in SPIN (https://spinroot.com): with the sum, the colours and the rest
nothing is told too early, and it ends; without one of them SPIN finds a run in which it is told too early.

    spin_check.py       exit code 3 if there is no spin or no C compiler
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile

MODEL = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'termination', 'termination.pml')


def errors(defines, what):
    """How many errors SPIN finds: of assertions and deadlocks, or of the property that it ends."""
    with tempfile.TemporaryDirectory() as folder:
        def run(*words):
            return subprocess.run(words, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=True).stdout.decode()
        run('spin', *defines, '-a', os.path.abspath(MODEL))
        safety = ['-DSAFETY', '-DNOCLAIM'] if what == 'safety' else ['-DNFAIR=4']
        run('cc', '-O1', '-w', *safety, '-o', 'pan', 'pan.c')
        out = run('./pan', '-m1000000', *([] if what == 'safety' else ['-a', '-f']))
        found = re.search(r'errors: (\d+)', out)
        if not found or 'max search depth too small' in out:
            sys.exit('spin has not come to an end:\n' + out)
        states = re.search(r'([\d.e+]+) states, stored', out)
        return int(found.group(1)), states.group(1) if states else '?'


def main():
    if not shutil.which('spin') or not shutil.which('cc'):
        print('there is no spin, or no C compiler')
        sys.exit(3)
    failed = 0
    for name, defines, what, expected in [
            ('nothing is told too early', ['-DWORK=3'], 'safety', False), ('it ends', ['-DWORK=3', '-DPROMPT'], 'liveness', False),
            ('four owners', ['-DOWNERS=4', '-DWORK=2'], 'safety', False), ('without the sum', ['-DNO_SUM', '-DWORK=3'], 'safety', True),
            ('without the colours', ['-DNO_COLOUR', '-DWORK=3'], 'safety', True), ('a busy owner passes the token on', ['-DBUSY'], 'safety', True)]:
        count, states = errors(defines, what)
        good = (count > 0) == expected
        failed += not good
        print('%s: %s, %s states: %s' % (name, 'an error is found' if count else 'no error', states, 'as it should' if good else 'FAILED'))
    print('%d passed, %d failed' % (6 - failed, failed))
    sys.exit(1 if failed else 0)


main()
