// The words of the language; editors/words writes this list.

static const char *const words[] = {
  // words: language
  "A", "AF", "AG", "AX", "E", "EF", "EG", "EX", "F", "G", "U", "X", "absorb", "always", "and", "as", "at",
  "behaviour", "binding", "blocked", "bond", "bonds", "check", "choose", "collisions", "compound", "count",
  "decompose", "dynamics", "else", "eps", "event", "eventually", "exists", "faces", "false", "fixed", "for",
  "forall", "glue", "grid", "hull", "if", "import", "in", "inertial", "leads_to", "let", "local", "mass",
  "matrix", "merge", "mesh", "mod", "model", "motion", "network", "nil", "not", "omega", "on", "only", "or",
  "orient", "param", "part", "possibly", "process", "push", "quaternion", "resolution", "rho", "rotate",
  "round", "scale", "scaled", "shape", "snap", "spin", "split_step", "steady", "then", "timestep",
  "translate", "true", "union", "velocity", "vertices", "weight", "weld", "where", "within",
  // words: end
};
