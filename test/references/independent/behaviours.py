"""Behaviours: what they offer and how they age."""

# ('nil',) ('open', name, barred, sites, B) ('weak', name, sites, B)
# ('strong', frozenset of (name, sites), B) ('eps', t, B) ('sum', (B, ...)) ('name', K)
# A set of sites is a frozenset of (part or None, frozenset of vertex names).


def greatest(sites):
    """Of features listed, those that no other has in its closure: lists of one closure have the same (I-17)."""
    return frozenset(s for s in sites if not any(s[0] == t[0] and s[1] < t[1] for t in sites))


def brought_up(name, written):
    """The last name that an eps(0) brings up as a name unfolds, outside of sums (Eps0)."""
    found, expired, b = name, False, written[name]
    while b[0] == 'name' or b[0] == 'eps' and b[1] == 0:
        if b[0] == 'eps':
            expired, b = True, b[2]
        else:
            found, expired, b = b[1] if expired else found, False, written[b[1]]
    return found


def canonical(b, written=None):
    """eps(0).B is B, sums have no brackets, and no list of features is redundant; with the definitions as they are
    written for a term that may have an eps(0)."""
    kind = b[0]
    if kind == 'nil':
        return b
    if kind == 'name':
        return ('name', brought_up(b[1], written)) if written else b
    if kind == 'eps':
        rest = canonical(b[2], written)
        return rest if b[1] == 0 else ('eps', b[1], rest)
    if kind == 'sum':
        summands = []
        for s in (canonical(s, written) for s in b[1]):
            summands.extend(s[1] if s[0] == 'sum' else [s])
        return ('sum', tuple(summands))
    if kind == 'strong':
        return ('strong', frozenset((name, greatest(sites)) for name, sites in b[1]), canonical(b[2], written))
    return b[:-2] + (greatest(b[-2]), canonical(b[-1], written))


def offers(b, definitions):
    """Rules Pre, Weak, Strong, Sum, Def, Eps0: all (prefix, continuation)."""
    kind = b[0]
    if kind in ('open', 'weak', 'strong'):
        return [(b[:-1], b[-1])]
    if kind == 'sum':
        return [o for s in b[1] for o in offers(s, definitions)]
    if kind == 'name':
        return offers(definitions[b[1]], definitions)
    return []


def horizon(b, definitions):
    """The least time left in an exposed eps; None for infinity."""
    if b[0] == 'eps':
        return b[1]
    if b[0] == 'sum':
        return least([horizon(s, definitions) for s in b[1]])
    if b[0] == 'name':
        return horizon(definitions[b[1]], definitions)
    return None


def least(times):
    known = [t for t in times if t is not None]
    return min(known) if known else None


def without_repetition(b, definitions):
    """An aged sum without nil and equal summands (I-17); what still ages stays a summand (I-14)."""
    summands = [s for s in dict.fromkeys(b[1]) if s != ('nil',)]
    if len(summands) == 1 and horizon(summands[0], definitions) is not None:
        summands.append(('nil',))
    if len(summands) > 1:
        return ('sum', tuple(summands))
    return summands[0] if summands else ('nil',)


def age(b, d, definitions):
    """Rule TimeBehaviour, for d not beyond the horizon."""
    aged = canonical(age_term(b, d, definitions))
    return without_repetition(aged, definitions) if aged != b and aged[0] == 'sum' else aged


def age_origin(b, origin, d, definitions):
    """The origin then (I-14): a name that comes up as the whole, and not as a summand."""
    aged = canonical(age_term(b, d, definitions))
    return aged[1] if aged != b and aged[0] == 'name' else origin


def age_term(b, d, definitions):
    if b[0] == 'eps':
        return canonical(('eps', b[1] - d, b[2]))
    if b[0] == 'sum':
        return ('sum', tuple(age_term(s, d, definitions) for s in b[1]))
    if b[0] == 'name' and horizon(b, definitions) is not None:
        return age_term(definitions[b[1]], d, definitions)
    return b
