#!/usr/bin/env python3
"""Tells what of the manual of scc a shell does not complete: completions.py SCC BASH ZSH FISH, the last three the files
that scripts/completion writes. Says nothing where all is there."""
import re
import subprocess
import sys


def manual(*words):
    return subprocess.run([sys.argv[1], *words, '--help=plain'], capture_output=True, text=True, check=True).stdout


def read(path):
    with open(path, encoding='utf-8') as f:
        return f.read()


def main():
    bash, zsh, fish = map(read, sys.argv[2:])
    commands = re.findall(r'^       ([a-z]+) ', manual().split('\nCOMMANDS')[1].split('\nCOMMON')[0], re.M)
    if len(commands) < 10:
        print('the manual has no list of commands:', commands)
    for command in commands:
        of_bash = re.search(r'^      %s\) options=(.*)' % command, bash, re.M)
        of_zsh = re.search(r'^  %s\) _arguments.*?;;' % command, zsh, re.M | re.S)
        of_fish = [line for line in fish.splitlines() if "_from %s'" % command in line]
        for shell, known in ('bash', of_bash), ('zsh', of_zsh), ('fish', '-a %s ' % command in fish):
            if not known:
                print('%s: %s' % (shell, command))
        options = {o for line in re.findall(r'^       (-.*)', manual(command), re.M) for o in re.findall(r'--[a-z-]+', line)}
        if '--help' not in options:
            print('the manual has no options of', command)
        for option in sorted(options):
            for shell, known in (('bash', of_bash and re.search('[" ]%s[" ]' % option, of_bash.group())),
                                 ('zsh', of_zsh and re.search(r"'\*%s[=\[]" % option, of_zsh.group())),
                                 ('fish', any('-l %s ' % option[2:] in line for line in of_fish))):
                if not known:
                    print('%s: %s %s' % (shell, command, option))
            # Of an option whose manual names the values of its kind, they are offered.
            for value in offered(command, option):
                if not re.search(r'"%s %s"[^\n]*compgen -W "[^"]*\b%s\b' % (command, option, value), bash):
                    print('bash: %s %s %s' % (command, option, value))


def offered(command, option):
    return {'--format': {'simulate': ['csv', 'jsonl'], 'sweep': ['csv', 'jsonl'], 'explore': ['aut', 'drn'], 'export': ['glb', 'csv']},
            '--free': {'sweep': ['apart', 'evenly'], 'estimate': ['apart', 'evenly']}, '--pieces': {'inflate': ['one', 'plate']},
            '--choose': {'trace': ['first'], 'export': ['first']}, '--start': {'trace': ['simple'], 'export': ['simple']},
            '--no-reduce': {'check': ['symmetry', 'all'], 'successors': ['drift']}}.get(option, {}).get(command, [])


if __name__ == '__main__':
    main()
