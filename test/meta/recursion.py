#!/usr/bin/env python3
"""No function of lib/ takes stack for each step of a run or each element of a list.

    test/meta/recursion.py SCC ALLOWED [--list]

Reads the machine code of the program SCC by objdump (x86-64 and AArch64): which function calls which, and refers to which
as a closure. Functions of lib/ on a cycle of these that is not of jumps alone (tail calls) must be named in the file
ALLOWED, with what bounds them. With --list it prints the cycles. Calls of functions that are handed over are not seen where
they are made, but where their closures are. Nor may lib/ call what of the standard library's lists is not in constant stack
(lib/foundation/base/constant_stack.mli).
"""

import collections
import re
import subprocess
import sys

HEAD = re.compile(r'^[0-9a-f]+ <(\S+)>:$')
LINE = re.compile(r'^\s*[0-9a-f]+:\s+(\S+)\s.*<(caml[A-Z][^+>]*)>')
DEEP = re.compile(r'^camlStdlib(?:(?:__|[.$])List(?:__|[.$])(?:init|map|mapi|map2|append|concat|flatten|fold_right2?|split|combine|'
                  r'merge|remove_ass[oq]c?)|(?:__|[.$])(?:\$40|@))(?:_\d+)*$')
NAME = re.compile(r'^camlScc_(\w+?)(?:__|[.$])(\w+?)(?:__|[.$])(\w+?)(?:_\d+)*$')


def references(program):
    """Of each function of scc, those that it refers to by a jump, and by anything else."""
    jumps, others = collections.defaultdict(set), collections.defaultdict(set)
    with subprocess.Popen(['objdump', '-d', '--no-show-raw-insn', program], stdout=subprocess.PIPE, text=True) as code:
        current = None
        for line in code.stdout:
            head = HEAD.match(line)
            if head:
                current = head.group(1) if head.group(1).startswith('caml') else None
                continue
            found = current and LINE.match(line)
            if found:
                jump = found.group(1).startswith('j') or found.group(1) == 'b' or found.group(1).startswith('b.')
                (jumps if jump else others)[current].add(found.group(2))
    return jumps, others


def components(edges):
    """Tarjan's strong components, without recursion."""
    number, low, stack, on, result = {}, {}, [], set(), []
    for root in list(edges):
        if root in number:
            continue
        number[root] = low[root] = len(number)
        stack.append(root)
        on.add(root)
        work = [(root, iter(edges[root]))]
        while work:
            at, left = work[-1]
            for to in left:
                if to not in number:
                    number[to] = low[to] = len(number)
                    stack.append(to)
                    on.add(to)
                    work.append((to, iter(edges.get(to, ()))))
                    break
                if to in on:
                    low[at] = min(low[at], number[to])
            else:
                work.pop()
                if work:
                    low[work[-1][0]] = min(low[work[-1][0]], low[at])
                if low[at] == number[at]:
                    group = set()
                    while at not in group:
                        group.add(stack.pop())
                    on -= group
                    result.append(group)
    return result


def named(symbol):
    found = NAME.match(symbol)
    return found and (f'{found.group(1)}.{found.group(2)}', found.group(3))


def allowed(path):
    reasons, names = set(), set()
    with open(path) as lines:
        for line in lines:
            if line.startswith('#   ') and not line.startswith('#    '):
                reasons.add(line.split()[1])
            elif not line.startswith('#'):
                head, functions = line.split(':')
                reason, module = head.split()
                if reason not in reasons:
                    sys.exit(f'{path}: no reason {reason}')
                names |= {(module, function) for function in functions.split()}
    return names


def main():
    program, path = sys.argv[1:3]
    jumps, others = references(program)
    edges = {f: jumps[f] | others[f] for f in set(jumps) | set(others)}
    groups = [g for g in components(edges) if any(others[f] & g for f in g)]
    cycles = [names for names in ({named(f) for f in g} - {None} for g in groups) if names]
    if '--list' in sys.argv:
        for names in sorted(sorted(n) for n in cycles):
            print(' '.join(f'{module}:{function}' for module, function in names))
    if len(cycles) < 100:
        sys.exit(f'{len(cycles)} recursive functions: {program} cannot be read')
    # Anonymous functions on a cycle come with one that has a name.
    known = allowed(path)
    new = sorted({n for names in cycles for n in names if not re.match(r'fun$|code_', n[1]) and n not in known})
    for module, function in new:
        print(f'{module}: {function} is recursive, and not by tail calls alone: mend it, or say in {path} what bounds it')
    deep = sorted(f for f in edges if named(f) and any(DEEP.match(g) for g in edges[f]))
    for function in deep:
        print(f'{function} calls a function of lists that takes stack for each element: see lib/dune')
    print(f'{len(cycles)} groups of recursive functions, {len(new)} not accounted for')
    sys.exit(1 if new or deep else 0)


main()
