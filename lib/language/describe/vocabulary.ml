type category = Word | Setting | Solid | Function | Component | Atom | Law | Event | Measure
type entry = { category : category; word : string; kind : string; section : string; meaning : string }

let group category kind section words =
  List.map (fun (word, meaning) -> { category; word; kind; section; meaning }) words

let declarations =
  [
    ("model", "names the model, for reports");
    ("param", "a parameter: a number that `-D NAME=VALUE` sets, or one of a range that no one knows");
    ("let", "names a number, a vector or a formula, to be put in where the name stands");
    ("check", "a property that `scc check` judges");
    ("where", "names values for the declaration before it alone");
  ]

let settings =
  [
    ("timestep", "the length of a movement step, and of turns at most; 1 if not given");
    ("local", "each process has movement steps of its own: a collision ends those of the processes that collide");
    ("steady", "movement steps keep the beat: no collision ends one");
    ("split_step", "the time between the instants at which bonds may be released; the timestep if not given");
    ("dynamics", "what a turning body keeps: `constant_spin` (if not given) or `free_body`");
    ("collisions", "how collisions of one instant are resolved: `in_turn` (if not given) or `together`");
    ("binding", "when open features that fit bind: on `collision` (if not given), or on any `contact`");
    ("bonds", "whether the bonds of a process may close rings: `acyclic` (if not given) or `cyclic`; \
               in formulas, the number of bonds");
    ("resolution", "how near is in contact where bodies turn: a length");
    ("round", "`orientation` or `velocity` is rounded to multiples of a power of two; \
               as a function, to the nearest multiple: `round(a, q)`");
  ]

let setting_values =
  [
    ("any", "bonds may be released at any instant, as in the calculus");
    ("constant_spin", "a turning body keeps its spin");
    ("free_body", "a turning body keeps its angular momentum");
    ("in_turn", "the collisions of one instant follow each other");
    ("together", "the collisions of one instant are resolved together");
    ("collision", "open features that fit bind when their bodies collide");
    ("contact", "open features that fit bind whenever they touch");
    ("acyclic", "the bonds of a process form a tree");
    ("cyclic", "bonds may close rings within a process");
    ("orientation", "of quaternions that rule Round keeps short");
    ("velocity", "of velocities and spins that rule Round makes multiples of a power of two");
  ]

let shapes =
  [
    ("shape", "a template: a convex polyhedron with named vertices and faces, or an image of another one");
    ("vertices", "the corners of a template, each with its place in body space");
    ("faces", "the faces of a template, each with its vertices counter-clockwise as seen from outside");
    ("scaled", "the image of a solid, stretched along the axes by the three factors of a vector");
    ("mesh", "a solid from a file: OFF, OBJ, STL, PLY, VRML or X3D");
    ("snap", "how far the vertices of a mesh may be moved, so that it becomes an exact convex solid");
    ("hull", "the convex hull of named points");
    ("translate", "moves by a vector");
    ("rotate", "turns by a quaternion w, x, y, z of any length");
    ("quaternion", "w, x, y, z of a rotation; it need not have length one");
    ("scale", "stretches along the axes by the three factors of a vector");
    ("matrix", "an affine map: four rows of four numbers, the last one (0, 0, 0, 1)");
    ("mass", "the mass of a body: a positive number; in a law of motion, that of the process");
    ("velocity", "the velocity of the body's centre of mass; at rest if not given");
    ("spin", "the angular velocity, in radians per unit of time; none if not given");
    ("at", "where a body is placed: in `T1 * T2` the last is applied first");
  ]

let compounds =
  [
    ("compound", "a template made of parts that are glued together");
    ("part", "a part of a compound");
    ("decompose", "the convex parts of a solid that need not be convex, glued together");
    ("glue", "where two parts of a compound touch and stay together");
  ]

let behaviours =
  [
    ("behaviour", "what a body does: it opens channels, waits, and releases bonds; \
                   in formulas, `behaviour(p) = K` compares it");
    ("on", "the template that a behaviour is for");
    ("only", "the feature alone, without its edges and corners");
    ("nil", "the behaviour that does nothing; `network nil` is the empty network");
    ("omega", "a weak split: the bond is released when both of its ends offer that");
    ("rho", "a strong split: all of these bonds are released at once, and no time passes before");
    ("push", "an impulse that drives the two apart when a split releases their bond");
    ("eps", "waits for that long");
  ]

let odds =
  [
    ("chance", "how likely the weak split before it is at each multiple of the split step");
    ("rate", "how often per unit of time the weak split before it happens where it may");
  ]

let processes =
  [
    ("process", "a body with its behaviour, or several that are bound");
    ("fixed", "a body of infinite mass that nothing moves");
    ("bond", "joins two bodies from the start on");
    ("absorb", "takes whatever process hits this fixed body out of the network; `event absorb` tells of it");
  ]

let families =
  [
    ("for", "repeats declarations, for each integer of a range");
    ("in", "what a variable or a parameter ranges over");
  ]

let modules =
  [
    ("import", "brings the shapes, compounds, behaviours and values of another file, or of the library");
    ("as", "another name for what is imported");
  ]

let motion =
  [
    ("network", "lists what takes part; everything declared does, if it is not given");
    ("motion", "the law by which bodies are steered, of all of them or of one");
    ("inertial", "bodies keep their velocities: the default");
    ("choose", "a finite choice of velocities");
    ("weight", "how likely a velocity is to be chosen");
  ]

let expressions =
  [
    ("true", "holds always");
    ("false", "never holds");
    ("if", "`if c then a else b`; after a range, which of its integers count");
    ("then", "what an `if` is where its condition holds");
    ("else", "what an `if` is where its condition does not hold");
    ("not", "the negation");
    ("and", "both hold");
    ("or", "one of them holds, or both");
    ("mod", "`a mod b` is a - b*floor(a/b): for b > 0 at least 0 and less than b");
    ("forall", "for each body of a template or family, or each integer of a range");
    ("exists", "for some body of a template or family, or some integer of a range");
    ("count", "for how many bodies or integers a formula holds");
  ]

let properties =
  [
    ("possibly", "some run reaches an instant at which this holds (EF)");
    ("always", "this holds at every instant of every run (AG)");
    ("eventually", "every run reaches an instant at which this holds (AF)");
    ("within", "bounds the time of the nearest operator before it");
    ("leads_to", "whenever the left side holds, every run from there reaches the right one");
    ("event", "holds right after a transition of this kind, before time passes");
    ("EF", "some run reaches an instant at which this holds");
    ("AG", "this holds at every instant of every run");
    ("AF", "every run reaches an instant at which this holds");
    ("EG", "on some run this holds at every instant");
    ("AX", "this holds right after the next event, whichever it is");
    ("EX", "this holds right after the next event, for some");
    ("A", "`A[f U g]`: on every run g comes to hold, and f does at every instant before");
    ("E", "`E[f U g]`: on some run g comes to hold, and f does at every instant before; \
           `E = ? [time U g]`: the mean over the runs");
    ("U", "until: `A[f U g]`, `E[f U g]`");
    ("F", "a letter of AF and EF, which are one word each");
    ("G", "a letter of AG and EG, which are one word each");
    ("X", "a letter of AX and EX, which are one word each");
  ]

let measures =
  [
    ("P", "the probability of what is in the brackets: `P >= 9/10 [eventually f]`, `P = ? [f U g]`");
    ("Pmin", "the least probability, over all ways in which what is not drawn may go");
    ("Pmax", "the greatest probability, over all ways in which what is not drawn may go");
    ("E", "the mean over the runs: `E = ? [time U f]`, `E <= 3 [event bounce U f]`, `E = ? [x(p) at 10]`");
    ("Emin", "the least mean, over all ways in which what is not drawn may go");
    ("Emax", "the greatest mean, over all ways in which what is not drawn may go");
  ]

let solids =
  [
    ("box", "`box(a, b, c)`: a box with these edges; faces left, right, front, back, bottom, top");
    ("prism", "`prism(n, r, h)`: over an n-gon of radius r, of height h; faces bottom, top, side1, …");
    ("antiprism", "`antiprism(n, r, h)`: its top is turned by half a corner; faces bottom, top, up1, …, down1, …");
    ("pyramid", "`pyramid(n, r, h)`: over an n-gon; faces bottom, side1, …; the vertex apex");
  ]

let functions =
  [
    ("min", "the least of some numbers");
    ("max", "the greatest of some numbers");
    ("abs", "the absolute value");
    ("sign", "-1, 0 or 1");
    ("floor", "the greatest integer that is not above");
    ("ceil", "the least integer that is not below");
    ("mod", "`mod(a, b)` is a - b*floor(a/b)");
    ("round", "`round(a, q)`: the multiple of q nearest to a");
    ("dot", "the product of two vectors that is a number");
    ("cross", "the product of two vectors that is a vector");
  ]

let components = [ ("x", "along the x axis"); ("y", "along the y axis"); ("z", "along the z axis") ]

let quantities =
  [
    ("bonds", "the number of bonds: `bonds()`, of a channel `bonds(a)`, between two bodies `bonds(a, p, q)`");
    ("size", "the number of basic shapes in the body's whole process");
    ("processes", "the number of processes");
    ("x", "the x coordinate of the body's centroid");
    ("y", "the y coordinate of the body's centroid");
    ("z", "the z coordinate of the body's centroid");
    ("vx", "the velocity of the body's centroid along x");
    ("vy", "the velocity of the body's centroid along y");
    ("vz", "the velocity of the body's centroid along z");
    ("speed2", "the square of the speed of the body's centroid");
    ("wx", "the body's spin about x in its present turn");
    ("wy", "the body's spin about y in its present turn");
    ("wz", "the body's spin about z in its present turn");
    ("spin2", "the square of the body's spin in its present turn");
    ("distance2", "the squared distance of the centroids of two bodies");
    ("momentum", "the momentum of everything that is not fixed: `momentum.x`");
    ("angular", "the angular momentum of everything that is not fixed, about the world's origin: `angular.x`");
    ("energy", "the kinetic energy of everything that is not fixed");
    ("time", "model time since the start");
  ]

let predicates =
  [
    ("bound", "a bond joins the two bodies");
    ("same", "the two are bodies of one process");
    ("behaviour", "`behaviour(p) = K`: the body's behaviour is K, perhaps aged");
    ("offers", "the body has a channel on offer now: `offers(p, a)`, of any kind; `offers(p, ~a)`, its co-name");
    ("touching", "the two bodies touch, be they bound or not");
    ("gone", "the body has been absorbed, and is nowhere");
    ("quiescent", "nothing can ever happen again");
  ]

let law =
  [
    ("x", "the x coordinate of the process's own position");
    ("y", "the y coordinate of the process's own position");
    ("z", "the z coordinate of the process's own position");
    ("vx", "the process's own velocity along x");
    ("vy", "the process's own velocity along y");
    ("vz", "the process's own velocity along z");
    ("mass", "the process's own mass");
    ("time", "model time since the start");
    ("dt", "the time since the last update of this law");
    ("diffuse", "a law of motion: `diffuse(d)` kicks a body as diffusion with the constant d does; \
                 `diffuse(d, v)` with the drift v besides, `diffuse(d, v, h)` by kicks of the length h");
  ]

let events =
  [
    ("bind", "a bond was made: `event bind(a, p, q)`");
    ("weak", "a bond was released by a weak split");
    ("strong", "a bond was released by a strong split, alone or with others");
    ("split", "a bond was released by a split of either kind");
    ("bounce", "a process bounced off another one");
    ("absorb", "a process was absorbed");
    ("hit", "a body itself, or a part of it, touched another one in a bounce");
  ]

let all =
  List.concat
    [
      group Word "keyword" "Declarations" declarations;
      group Word "setting" "Declarations" settings;
      group Setting "setting" "Declarations" setting_values;
      group Word "keyword" "Shapes" shapes;
      group Word "keyword" "Compounds" compounds;
      group Word "keyword" "Features, channels, behaviours" behaviours;
      group Setting "word" "Features, channels, behaviours" odds;
      group Word "keyword" "Processes" processes;
      group Word "keyword" "Families" families;
      group Word "keyword" "Modules" modules;
      group Word "keyword" "Networks and motion" motion;
      group Word "keyword" "Expressions" expressions;
      group Word "keyword" "Properties" properties;
      group Measure "keyword" "Properties" measures;
      group Solid "shape" "Shapes" solids;
      group Function "function" "Expressions" functions;
      group Component "component" "Expressions" components;
      group Atom "quantity" "Properties" quantities;
      group Atom "predicate" "Properties" predicates;
      group Law "quantity" "Networks and motion" law;
      group Event "event" "Properties" events;
    ]

let find category word = List.find_opt (fun e -> e.category = category && String.equal e.word word) all
