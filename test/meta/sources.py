"""The source files of a folder of the build tree."""
import os
import pathlib


def under(folder, ending):
    """The files under the folder whose names end so, sorted. Names that begin with a dot, and folders _build, are left
    out: compilers and test runners make and remove files there while tests run."""
    found = []
    for path, folders, files in os.walk(folder):
        folders[:] = [name for name in folders if name[0] != '.' and name != '_build']
        found += [pathlib.Path(path, name) for name in files if name[0] != '.' and name.endswith(ending)]
    return sorted(found)
