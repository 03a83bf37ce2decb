#!/usr/bin/env python3
"""Models in XML against specs/schema/bioshape.xsd, by xmllint (libxml2).

    bioshape_check.py SCC FOLDER

Valid are the XML of every model of specs/models, random documents (documents.exe), and what is in XML there already; so
that the schema says something, it refuses some that differ from a valid one in one place. The last line is 'N passed, M
failed'.
"""

import glob
import os
import shutil
import subprocess
import sys

SCHEMA = 'specs/schema/bioshape.xsd'
DOCUMENTS = '_build/default/test/outside/documents/documents.exe'

# What xmllint has to refuse: changes of specs/models/bioshape/docking.xml.
WRONG = [
    ('<model name="docking"/>', '<model/>'), ('<model name="docking"/>', '<model name="dock ing"/>'),
    ('<nil/>', ''), ('<nil/>', '<nil/><nil/>'), ('<nil/>', '<nil name="a"/>'), ('<nil/>', '<stop/>'),
    ('co="true"', 'co="yes"'), ('<leaf>', ''), ('<mass value="1"/>', '<mass>1</mass>'),
    ('<feature name="side"/>', '<feature/>'), ('urn:scc:bioshape:1', 'urn:scc:bioshape:2'),
    ('<translate by="(1 + gap, 0, 0)"/>', ''), ('within gap</check>', 'within gap<nil/></check>'),
]


def valid(paths):
    """Those that are not, as xmllint tells it."""
    done = subprocess.run(['xmllint', '--noout', '--nonet', '--schema', SCHEMA, *paths], capture_output=True, text=True)
    good = {line[:-len(' validates')] for line in done.stderr.splitlines() if line.endswith(' validates')}
    return [p for p in paths if p not in good], done.stderr


def main(scc, folder):
    if shutil.which('xmllint') is None:
        print('xmllint is not installed (Debian: libxml2-utils)')
        return 3
    passed = failed = 0

    def count(good, what, told=''):
        nonlocal passed, failed
        passed, failed = passed + good, failed + (not good)
        if not good:
            print('FAILED', what, told)

    written = []
    for model in sorted(glob.glob('specs/models/**/*.sc', recursive=True)):
        path = os.path.join(folder, model.replace('/', '-')[:-3] + '.xml')
        done = subprocess.run([scc, 'translate', model, '--to', 'xml', '-o', path], capture_output=True, text=True)
        if os.path.exists(path):
            written.append(path)
        else:
            # A model that is no text of the language is refused for that.
            count('/refused/' in model, model, done.stderr)
    if os.path.exists(DOCUMENTS):
        subprocess.run([DOCUMENTS, '200', folder], check=True)
        written += sorted(glob.glob(os.path.join(folder, 'random-*.xml')))
    else:
        count(False, DOCUMENTS, 'is not built')
    written += sorted(glob.glob('specs/models/bioshape/*.xml'))
    wrong, told = valid(written)
    for path in written:
        count(path not in wrong, path, '\n'.join(l for l in told.splitlines() if l.startswith(path + ':')))
    with open('specs/models/bioshape/docking.xml', encoding='utf-8') as f:
        text = f.read()
    for i, (old, new) in enumerate(WRONG):
        path = os.path.join(folder, 'wrong-%d.xml' % i)
        with open(path, 'w', encoding='utf-8') as f:
            f.write(text.replace(old, new, 1))
        assert old in text, old
        count(valid([path])[0] == [path], 'accepted: %s for %s' % (new, old))
        code = subprocess.run([scc, 'translate', path, '--to', 'sc'], capture_output=True).returncode
        count(code == 3, 'accepted by scc: %s for %s: %d' % (new, old, code))
    print('%d documents' % len(written))
    print('%d passed, %d failed' % (passed, failed))
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main(*sys.argv[1:]))
