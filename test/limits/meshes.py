#!/usr/bin/env python3
"""Limits of memory while a mesh is read and prepared.

    test/limits/meshes.py SCC

Each command meets one mesh that takes more than its limit, by itself or in a model: it ends with code 4, says that
the limit of memory was met, and its greatest memory is little more than that. With a small mesh the same commands
end as they do without a limit.
"""

import os
import subprocess
import sys
import tempfile

LIMIT = 100
# What reading may take in any case, and what the program has before.
READING = 64
OVER = 60
SMALL = 4
LARGE = 400
MODEL = """shape B = mesh "%s.off" weld
param v = 1
process p = B mass 1 velocity (v, 0, 0) [nil]
check far : possibly x(p) > 3
"""
RUNS = ["--observe", "x(p)", "--every", "1", "--until", "3", "--runs", "2"]
COMMANDS = [
    (["shape", "--weld"], ".off"), (["decompose"], ".off"), (["shape", "--json"], ".off"),
    (["check"], ".sc"), (["check", "--json"], ".sc"), (["explore", "--format", "aut", "-o", "-"], ".sc"),
    (["view", "-o", "page.html"], ".sc"), (["trace"], ".sc"), (["simulate", *RUNS], ".sc"),
    (["estimate", "--property", "P = ? [ eventually x(p) > 3 ]"], ".sc"), (["sweep", "-D", "v=1,2"], ".sc"),
    (["conform", "%s", "trace.csv"], ".sc"),
]


def terrain(n):
    """A surface of n by n squares, each of two triangles. It bounds no solid."""
    corner = lambda i, j: i * (n + 1) + j
    lines = ["OFF", "%d %d 0" % ((n + 1) ** 2, 2 * n * n)]
    lines += ["%d %d %d" % (i, j, (7 * i + 13 * j) % 5) for i in range(n + 1) for j in range(n + 1)]
    for i in range(n):
        for j in range(n):
            one, two, three, four = corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)
            lines += ["3 %d %d %d" % (one, two, three), "3 %d %d %d" % (one, three, four)]
    return "\n".join(lines) + "\n"


def words_of(words, path):
    """The command on that file, which is the last word unless the words say where it stands."""
    return [path if word == "%s" else word for word in words] + ([] if "%s" in words else [path])


def run(words, folder):
    """The code, what is said, and the greatest memory in MiB."""
    with tempfile.TemporaryFile() as out:
        process = subprocess.Popen(words, cwd=folder, stdin=subprocess.DEVNULL, stdout=out, stderr=out)
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0)
        return process.returncode, out.read().decode("utf-8", "replace"), used.ru_maxrss / 1024


def large(scc, words, file, folder):
    code, told, used = run([scc, *words_of(words, "large" + file), "--memory", str(LIMIT)], folder)
    if code != 4:
        return "code %d: %s" % (code, told[-200:])
    if "--json" not in words and "the limit of memory was met" not in told:
        return "it does not say which limit was met: " + told[-200:]
    return "it took %d MiB" % used if used > LIMIT + READING + OVER else None


def small(scc, words, file, folder):
    words = words_of(words, "small" + file)
    free = run([scc, *words], folder)
    bound = run([scc, *words, "--memory", str(LIMIT)], folder)
    return None if free[:2] == bound[:2] and free[0] != 4 else "code %d, without a limit %d" % (bound[0], free[0])


def main():
    scc = os.path.abspath(sys.argv[1])
    passed, failed = 0, 0
    with tempfile.TemporaryDirectory() as folder:
        for name, n in (("small", SMALL), ("large", LARGE)):
            with open(os.path.join(folder, name + ".off"), "w") as file:
                file.write(terrain(n))
            with open(os.path.join(folder, name + ".sc"), "w") as file:
                file.write(MODEL % name)
        with open(os.path.join(folder, "trace.csv"), "w") as file:
            file.write("time,event\n0,time\n")
        for words, file in COMMANDS:
            for case in (large, small):
                wrong = case(scc, words, file, folder)
                passed, failed = (passed, failed + 1) if wrong else (passed + 1, failed)
                if wrong:
                    print("FAULT %s, a %s mesh: %s" % (" ".join(words), case.__name__, wrong))
    print("%d passed, %d failed" % (passed, failed))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
