#!/usr/bin/env python3
"""Compiles threads.c with the sanitisers of the C compiler, and runs it.

    sanitised.py WHERE FOLDER COMPILER…

WHERE has the headers of OCaml, and FOLDER the stubs. What the compiler lacks is told as 'not run: …'; where CI is set
it has to be there.
"""
import os
import subprocess
import sys
import tempfile

SANITISERS = ["thread", "address,undefined"]
EMPTY = "int main(void) { return 0; }\n"


def output(command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=100)
    return done.returncode, done.stdout


def main():
    where, stubs, *compiler = sys.argv[1:]
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        empty, program = os.path.join(folder, "empty.c"), os.path.join(folder, "program")
        with open(empty, "w") as file:
            file.write(EMPTY)
        for sanitiser in SANITISERS:
            flags = ["-g", "-O1", "-fsanitize=" + sanitiser, "-fno-sanitize-recover=all", "-o", program]
            if output(compiler + flags + [empty])[0] or output([program])[0]:
                print("not run: -fsanitize=%s of %s" % (sanitiser, compiler[0]))
                failed += "CI" in os.environ
                continue
            code, text = output(compiler + flags + ["-I", where, "-I", stubs, "threads.c", "-lpthread"])
            if code == 0:
                code, text = output([program])
            if code or text != "as it should be\n":
                print("-fsanitize=%s: exit code %d\n%s" % (sanitiser, code, text))
                failed += 1
    sys.exit(failed)


if __name__ == "__main__":
    main()
