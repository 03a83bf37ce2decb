// What pegs.sc is made of: a peg, and behaviours for it and for the holes that it fits into.

param patience = 1   // how long each count of a peg that waits takes

// Rounded in the file, exact here.
shape Peg = mesh "peg.obj" snap 1e-5

// Counts down, and only then opens its tip.
behaviour Waiting[k] = eps(patience). Waiting[k - 1]
behaviour Waiting[0] on Peg = <~peg, {tip}>. In
behaviour In = nil

// Open at one face, once.
behaviour Hole(face) = <peg, {only face}>. nil
