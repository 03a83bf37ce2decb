#!/usr/bin/env python3
"""Runs the tests of the Python client against a built scc, by pytest when there is one and by unittest otherwise.

    run.py CLIENT SCC

CLIENT is the folder clients/python, SCC the program. The last line is 'N passed, N failed'.
"""

import os
import sys
import unittest


def by_pytest(tests):
    import pytest

    class Counter:
        passed = failed = 0

        def pytest_runtest_logreport(self, report):
            if report.failed:
                self.failed += 1
            elif report.when == "call" and report.passed and type(report).__name__ == "TestReport":
                self.passed += 1

        def pytest_collectreport(self, report):
            self.failed += report.failed

    counter = Counter()
    code = pytest.main(["-q", "-p", "no:cacheprovider", tests], plugins=[counter])
    return counter.passed, counter.failed, code == 0


def by_unittest(tests):
    suite = unittest.defaultTestLoader.discover(tests, top_level_dir=os.path.dirname(tests))
    result = unittest.TextTestRunner(stream=sys.stdout, verbosity=0).run(suite)
    failed = len(result.failures) + len(result.errors) + len(result.unexpectedSuccesses)
    return result.testsRun - failed - len(result.skipped), failed, result.wasSuccessful()


def main():
    client, scc = map(os.path.abspath, sys.argv[1:3])
    os.environ["SCC"] = scc
    sys.path[:0] = [os.path.join(client, "src"), client]
    os.chdir(client)
    tests = os.path.join(client, "tests")
    try:
        import pytest  # noqa: F401

        passed, failed, well = by_pytest(tests)
    except ImportError:
        passed, failed, well = by_unittest(tests)
    if passed == 0 or (not well and failed == 0):
        failed += 1
    sys.stdout.flush()
    print("%d passed, %d failed" % (passed, failed))
    return 0 if failed == 0 else 1


if __name__ == "__main__":
    sys.exit(main())
