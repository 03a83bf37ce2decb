#!/usr/bin/env python3
"""The transcripts of texts are what the program prints.

    transcripts.py SCC ROOT TEXT…

A transcript is a block of a text: a command after `$ `, and lines below it that it prints. Each command of scc whose
output stands below it runs in a copy of ROOT, after the commands above it in its text. Its output has to be those
lines. A line `[…]` stands for any lines that are left out. Commands of other programs are not run, and neither is
what stands on SKIPPED, with its reason. The last line is 'N passed, N failed'.
"""
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

LEFT_OUT = "[…]"
SKIPPED = {  # the beginning of a command: why it is not run
    "scc check dock.sc": "its model is written in the text, piece by piece",
    "scc check ruin.sc --parametric k": "its model is that of specs/models with k in its weights; test/cli has both",
    "scc shape dodecahedron.off": "its file is one of the reader's",
    "scc shape --weld": "its file is one of the reader's",
    "scc inflate": "its output is a file",
    "scc sweep": "its output is files",
    "scc check --witness out model.sc": "its model is one of the reader's",
    "scc trace model.sc": "its model is one of the reader's",
    "scc explain out/NAME.json": "its schedule is one of the reader's",
}


def blocks(text):
    """The code blocks of a text: pairs of the number of the first line and the lines."""
    found, block, fenced = [], None, False
    for number, line in enumerate(text.split("\n"), 1):
        if line.startswith("```"):
            fenced = not fenced
            if fenced:
                block = (number + 1, [])
            else:
                found.append(block)
                block = None
        elif fenced:
            block[1].append(line)
        elif line.startswith("    ") or (block and not line.strip()):
            block = block or (number, [])
            block[1].append(line[4:])
        elif block:
            found.append(block)
            block = None
    return found + ([block] if block else [])


def transcripts(lines):
    """The commands of a block, each with its line in the block and the lines that it prints."""
    found = []
    for i, line in enumerate(lines):
        if line.startswith("$ "):
            found.append([i, line[2:], []])
        elif found and found[-1][1].endswith("\\"):
            found[-1][1] = found[-1][1][:-1] + line.strip()
        elif found:
            found[-1][2].append(line)
    for one in found:
        while one[2] and not one[2][-1].strip():
            one[2].pop()
    return found


def fits(said, printed):
    """Whether the printed lines are those said, in which `[…]` stands for any number of lines."""
    pattern = "".join("(?:.*\n)*" if line.strip() == LEFT_OUT else re.escape(line.rstrip()) + "\n" for line in said)
    return re.fullmatch(pattern, "".join(line.rstrip() + "\n" for line in printed)) is not None


def main():
    scc, root, texts = os.path.abspath(sys.argv[1]), sys.argv[2], sys.argv[3:]
    passed = failed = 0
    for text in texts:
        with open(text, encoding="utf-8") as file:
            content = file.read()
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(os.path.join(root, "specs", "models"), os.path.join(folder, "specs", "models"))
            os.mkdir(os.path.join(folder, "bin"))
            os.symlink(scc, os.path.join(folder, "bin", "scc"))
            # copies of a build are read-only
            for base, folders, files in os.walk(os.path.join(folder, "specs")):
                for name in folders + files:
                    os.chmod(os.path.join(base, name), 0o755)
            environment = {**os.environ, "PATH": os.path.join(folder, "bin") + os.pathsep + os.environ["PATH"]}
            for first, lines in blocks(content):
                for at, command, said in transcripts(lines):
                    words = shlex.split(command, comments=True)
                    if words[:1] == ["cat"]:  # a file that the text shows is one that later commands read
                        with open(os.path.join(folder, words[1]), "w", encoding="utf-8") as file:
                            file.write("\n".join(said) + "\n")
                        continue
                    if not words or words[0] not in ("scc", "grep") or any(
                            command.startswith(start) for start in SKIPPED):
                        continue
                    run = subprocess.run(command, shell=True, cwd=folder, env=environment, text=True, timeout=600,
                                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
                    printed = run.stdout.rstrip("\n").split("\n") if run.stdout.strip() else []
                    if not said:
                        continue
                    if fits(said, printed):
                        passed += 1
                    else:
                        failed += 1
                        print(f"{text}:{first + at}: $ {command}\n" + "\n".join("  " + line for line in printed))
    print(f"{passed} passed, {failed} failed")
    return 1 if failed or not passed else 0


if __name__ == "__main__":
    sys.exit(main())
