#!/usr/bin/env python3
"""Makes a wheel of the Python package that carries a program, and prints its path.

    make_wheel.py PROGRAM CLIENT LICENCE NOTICES FOLDER

setuptools makes a wheel of CLIENT, the folder of the package. The program, its licences and the command `scc` are added
to it. The tag of the wheel follows from the program: one that needs no library runs on every Linux of its machine,
whatever its C library; any other one is for the system on which it was linked. Files have the time SOURCE_DATE_EPOCH.
"""

import base64
import hashlib
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import time
import zipfile

MACHINES = {62: "x86_64", 183: "aarch64", 243: "riscv64"}
NEEDS_A_LOADER = 3  # PT_INTERP
DYNAMIC = 2  # PT_DYNAMIC


def fail(text):
    sys.exit("make_wheel.py: " + text)


def tags(program):
    """The platforms for which a program is, read from its ELF headers."""
    with open(program, "rb") as file:
        head = file.read(64)
        if len(head) < 64 or head[:6] != b"\x7fELF\x02\x01":
            fail("%s is no program for a Linux of 64 bits" % program)
        machine = MACHINES.get(struct.unpack_from("<H", head, 18)[0])
        if machine is None:
            fail("%s is for a machine that has no tag here" % program)
        start, size, count = struct.unpack_from("<Q14xHH", head, 32)
        file.seek(start)
        kinds = [struct.unpack("<I", file.read(size)[:4])[0] for _ in range(count)]
    if NEEDS_A_LOADER in kinds or DYNAMIC in kinds:
        return ["linux_" + machine]
    oldest = "2_17" if machine in ("x86_64", "aarch64") else "2_31"
    old_name = ["manylinux2014_" + machine] if oldest == "2_17" else []
    return ["manylinux_%s_%s" % (oldest, machine), *old_name, "musllinux_1_1_" + machine]


def pure_wheel(client, folder):
    """What setuptools makes of the package, from a copy of it: its name and its files."""
    copy = os.path.join(folder, "client")
    shutil.copytree(client, copy, ignore=shutil.ignore_patterns("__pycache__", "build", "*.egg-info"))
    script = "from setuptools import build_meta; build_meta.build_wheel(%r)" % folder
    done = subprocess.run([sys.executable, "-c", script], cwd=copy, capture_output=True, text=True, check=False)
    made = [name for name in os.listdir(folder) if name.endswith(".whl")]
    if done.returncode != 0 or len(made) != 1:
        fail("setuptools made no wheel:\n" + done.stdout + done.stderr)
    with zipfile.ZipFile(os.path.join(folder, made[0])) as wheel:
        return made[0], {entry: wheel.read(entry) for entry in wheel.namelist()}


def add_program(files, info, program, licence, notices, platforms):
    """Changes files, which are those of a wheel without a program; info is the folder of its metadata."""
    lines = files[info + "WHEEL"].decode().splitlines()
    kept = [line for line in lines if line and not line.startswith(("Tag:", "Root-Is-Purelib:"))]
    tagged = ["Root-Is-Purelib: false", *("Tag: py3-none-" + platform for platform in platforms)]
    files[info + "WHEEL"] = "\n".join([*kept, *tagged, ""]).encode()
    points = files[info + "entry_points.txt"].decode().rstrip("\n").split("\n")
    points.insert(points.index("[console_scripts]") + 1, "scc = shapecalculus._program:main")
    files[info + "entry_points.txt"] = "\n".join([*points, ""]).encode()
    for name, path in (("shapecalculus/program/scc", program), (info + "LICENSE", licence), (info + "NOTICES", notices)):
        with open(path, "rb") as file:
            files[name] = file.read()


def write(path, files, info):
    """Writes a wheel: files in order, all of one time, and last the record of them."""
    when = time.gmtime(max(int(os.environ["SOURCE_DATE_EPOCH"]), 315532800))[:6]  # a zip has none before 1980
    record = []
    with zipfile.ZipFile(path, "w") as wheel:

        def add(name, content, mode=0o644):
            entry = zipfile.ZipInfo(name, when)
            entry.external_attr = (0o100000 | mode) << 16
            entry.create_system = 3
            wheel.writestr(entry, content, zipfile.ZIP_DEFLATED, 9)

        order = sorted(set(files) - {info + "RECORD"}, key=lambda name: (name.startswith(info), name))
        for name in order:
            digest = base64.urlsafe_b64encode(hashlib.sha256(files[name]).digest()).rstrip(b"=").decode()
            record.append("%s,sha256=%s,%d\n" % (name, digest, len(files[name])))
            add(name, files[name], 0o755 if name == "shapecalculus/program/scc" else 0o644)
        record.append(info + "RECORD,,\n")
        add(info + "RECORD", "".join(record).encode(), 0o664)


def main():
    if len(sys.argv) != 6:
        fail("usage: make_wheel.py PROGRAM CLIENT LICENCE NOTICES FOLDER")
    program, client, licence, notices, out = map(os.path.abspath, sys.argv[1:])
    platforms = tags(program)
    with tempfile.TemporaryDirectory() as folder:
        name, files = pure_wheel(client, folder)
        project, version = name.split("-")[:2]
        info = "%s-%s.dist-info/" % (project, version)
        add_program(files, info, program, licence, notices, platforms)
        path = os.path.join(out, "%s-%s-py3-none-%s.whl" % (project, version, ".".join(platforms)))
        write(path, files, info)
    print(path)


if __name__ == "__main__":
    main()
