"""Rule Draw, written naively: velocities that laws of motion leave to chance.

A law is a function from an environment to a velocity, or, if it chooses, to a list of velocities and weights.
"""

from fractions import Fraction as F

WAITS = 'waits'


def plus(u, v):
    return tuple(a + b for a, b in zip(u, v))


class Draws:
    def under_law(self, p):
        return not self.fixed(p) and any(self.bodies[l.name].law for l in p.leaves)

    def chooses(self, p):
        return self.under_law(p) and any(self.bodies[l.name].chooses for l in p.leaves)

    def choices(self, p, time, dt):
        """All combinations of what the leaves of a process draw: velocities of the whole, with their chances."""
        found = [(p.velocity, F(1))]
        for l in p.leaves:
            body = self.bodies[l.name]
            if body.law:
                x, y, z = plus(l.position, body.centroid())
                vx, vy, vz = p.velocity
                given = body.law(dict(x=x, y=y, z=z, vx=vx, vy=vy, vz=vz, mass=F(body.mass), time=time, dt=dt))
                given = given if body.chooses else [(given, F(1))]
                total = sum(weight for _, weight in given)
                share = F(body.mass) / self.mass(p)
                found = [(plus(v, [share * (a - b) for a, b in zip(kick, p.velocity)]), chance * weight / total)
                         for v, chance in found for kick, weight in given]
        return {v: sum(chance for w, chance in found if w == v) for v, chance in found if chance > 0}

    def first_to_draw(self, state):
        """Who is least by its leaves: by their places, then by their shapes, and then as it is declared."""
        order = list(self.bodies)

        def place(p):
            return (sorted((l.position, self.bodies[l.name].shape.name) for l in p.leaves),
                    min(order.index(l.name) for l in p.leaves))
        return min((p for p in state.processes if p.draw == WAITS), key=place, default=None)

    def waiting(self, state, dt):
        """With all whose laws are asked about to draw; None if none of these laws chooses."""
        if not any(self.chooses(p) for p in state.processes):
            return None
        processes = []
        for p in state.processes:
            if self.under_law(p):
                p = p._replace(draw=WAITS if self.chooses(p) else next(iter(self.choices(p, state.time, dt))))
            processes.append(p)
        return state._replace(processes=tuple(processes))

    def draws(self, state, p, dt):
        """The draws of a process; by the last one all velocities take effect."""
        found = set()
        names = frozenset(l.name for l in p.leaves)
        for velocity, chance in self.choices(p, state.time, dt).items():
            processes = tuple(q._replace(draw=velocity) if q is p else q for q in state.processes)
            after = state._replace(processes=processes)
            if self.first_to_draw(after) is None:
                after = self.steer(after, dt)
            found.add((('draw', names, velocity, chance), after))
        return found
