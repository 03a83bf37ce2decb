"""Builds scc's benchmarks and the peers, and tells what is missing for which peer.

Nothing is written into the source tree: the objects of C++ and of cargo go to the folder `work`.
"""

import os
import re
import shutil
import subprocess

HERE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
ROOT = os.path.dirname(os.path.dirname(HERE))
PEERS = os.path.join(HERE, "peers")

# The oldest Rust that the pinned crates accept.
RUST = (1, 90)
RUST_HINT = "Rust %d.%d or newer with cargo, by https://rustup.rs where the distribution has an older one" % RUST

# Of each peer in C++: a header to look for, its Debian package, what to compile with.
CPP = {
    "libccd": ("ccd/ccd.h", "libccd-dev", ["-lccd"]),
    "fcl": ("fcl/config.h", "libfcl-dev", ["-I/usr/include/eigen3", "-lfcl", "-lccd"]),
    # Interval arithmetic needs -frounding-math.
    "cgal": ("CGAL/version.h", "libcgal-dev", ["-frounding-math", "-lgmp", "-lmpfr"]),
}


class Missing(Exception):
    """A peer that cannot be built here; the text says what to install."""


def say(text):
    print(text, flush=True)


def run(command, **options):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **options)
    return done.returncode, done.stdout


def build_scc(programs=("test/bench/geometry.exe", "test/bench/gas.exe")):
    """The folder of scc's bench programs."""
    target = os.path.join(ROOT, os.environ.get("DUNE_BUILD_DIR", "_release"))
    code, output = run(["sh", "-c", ". scripts/dependencies.sh && require build"], cwd=ROOT)
    if code != 0:
        raise Missing("scc's own dependencies:\n" + output)
    code, output = run(["dune", "build", "--profile", "release", "--build-dir", target, *programs], cwd=ROOT)
    if code != 0:
        raise Missing("scc does not build:\n" + output)
    return os.path.join(target, "default", "test", "bench")


def build_cpp(name, work):
    header, package, flags = CPP[name]
    if shutil.which("g++") is None:
        raise Missing("%s: no C++ compiler; apt-get install g++ %s" % (name, package))
    source = os.path.join(PEERS, "cpp", name + ".cpp")
    probe = subprocess.run(["g++", "-E", "-x", "c++", "-"], input="#include <%s>\n" % header, text=True,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    if probe.returncode != 0:
        raise Missing("%s: no <%s>; apt-get install %s" % (name, header, package))
    program = os.path.join(work, name)
    newest = max(os.path.getmtime(p) for p in (source, os.path.join(PEERS, "cpp", "bench.hpp")))
    if not os.path.exists(program) or os.path.getmtime(program) < newest:
        code, output = run(["g++", "-std=c++17", "-O3", "-DNDEBUG", source, "-o", program] + flags)
        if code != 0:
            raise Missing("%s does not build:\n%s" % (name, output))
    return program


def build_rust(package, work):
    if shutil.which("cargo") is None or shutil.which("rustc") is None:
        raise Missing("%s: no cargo; it needs %s" % (package, RUST_HINT))
    _, version = run(["rustc", "--version"])
    found = re.search(r"(\d+)\.(\d+)", version)
    if not found or tuple(map(int, found.groups())) < RUST:
        raise Missing("%s: %s is too old; it needs %s" % (package, version.strip(), RUST_HINT))
    target = os.path.join(work, "cargo")
    code, output = run(["cargo", "build", "--release", "--locked", "--target-dir", target, "-p", package],
                       cwd=os.path.join(PEERS, "rust"))
    if code != 0:
        raise Missing("%s does not build (the crates come from crates.io):\n%s" % (package, output))
    return os.path.join(target, "release", package)


def build(wanted, work):
    """The programs by name, and what is missing, in words."""
    os.makedirs(work, exist_ok=True)
    programs, missing = {}, []
    for name in wanted:
        say("building %s" % name)
        try:
            programs[name] = build_cpp(name, work) if name in CPP else build_rust(name, work)
        except Missing as lack:
            missing.append(str(lack))
            say("  left out: %s" % lack)
    return programs, missing
