#!/usr/bin/env python3
"""The texts of a package, which lead only to what is in it: texts.py SOURCE FOLDER copies README.md and the texts, recipes,
schemas and pictures of specs to the same places in FOLDER. Links to what is not there become words, and a text that names
folders of the source says at its beginning that they are not in the package."""
import os
import re
import shutil
import sys

LINK = re.compile(r'(!?)\[([^\]]*)\]\(([^)#\s]*)(#[^)\s]*)?\)')
FENCE = re.compile(r'^(```|    ).*')
#: Folders of the source, in the code of a text.
NAMED = re.compile(r'\b(bin|clients|editors|lib|scripts|test|web|specs/conformance)/')


def is_there(folder, path):
    return '://' in path or path == '' or os.path.exists(os.path.join(folder, path))


def rewritten(text, folder, root):
    def link(found):
        picture, words, path, _ = found.groups()
        if is_there(folder, path):
            return found.group()
        # A picture that is not there is told by its words.
        return words

    lines = [line if FENCE.match(line) else LINK.sub(link, line) for line in text.split('\n')]
    missing = sorted({name for name in NAMED.findall(text) if not os.path.isdir(os.path.join(root, name))})
    if missing:
        names = ', '.join(f'`{name}`' for name in missing)
        note = f'*In the source of scc there are also folders that this package does not have: {names}.*'
        at = next((i for i, line in enumerate(lines) if line.startswith('# ')), -1) + 1
        lines[at:at] = ['', note]
    return '\n'.join(lines)


def copied(source, root):
    specs = os.path.join(root, 'specs')
    os.makedirs(specs, exist_ok=True)
    shutil.copyfile(os.path.join(source, 'README.md'), os.path.join(root, 'README.md'))
    for name in sorted(os.listdir(os.path.join(source, 'specs'))):
        if name.endswith('.md'):
            shutil.copyfile(os.path.join(source, 'specs', name), os.path.join(specs, name))
    for name in 'cookbook', 'schema', 'pictures':
        shutil.copytree(os.path.join(source, 'specs', name), os.path.join(specs, name), ignore=shutil.ignore_patterns('dune'))


def main():
    source, root = sys.argv[1:]
    copied(source, root)
    for folder, _, names in sorted(os.walk(root)):
        for name in sorted(names):
            path = os.path.join(folder, name)
            if not name.endswith('.md') or os.path.islink(path):
                continue
            with open(path, encoding='utf-8') as file:
                text = file.read()
            with open(path, 'w', encoding='utf-8') as file:
                file.write(rewritten(text, folder, root))


if __name__ == '__main__':
    main()
