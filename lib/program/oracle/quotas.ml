type t = {
  line_bytes : int;
  batch : int;
  reply_bytes : int;
  depth : int;
  values : int;
  digits : int;
  vertices : int;
  faces : int;
  corners : int;
  name_bytes : int;
  shapes : int;
  models : int;
  model_bytes : int;
  path : int;
  steps : int;
  touching : int;
  grid : int;
  formula_bytes : int;
  states : int;
  seconds : int;
  memory_mib : int;
}

let mib = Scc_base.Memory.mib

let default =
  {
    line_bytes = 16 * mib;
    batch = 50_000;
    reply_bytes = 64 * mib;
    depth = 64;
    values = 2_000_000;
    digits = 1_000;
    vertices = 1_000;
    faces = 2_000;
    corners = 10_000;
    name_bytes = 256;
    shapes = 4_096;
    models = 64;
    model_bytes = 4 * mib;
    path = 10_000;
    steps = 100_000;
    touching = 1_000;
    grid = 256;
    formula_bytes = 65_536;
    states = 1_000_000;
    seconds = 60;
    memory_mib = 2_048;
  }

let listed q =
  [
    ("line_bytes", q.line_bytes);
    ("batch", q.batch);
    ("reply_bytes", q.reply_bytes);
    ("depth", q.depth);
    ("values", q.values);
    ("digits", q.digits);
    ("vertices", q.vertices);
    ("faces", q.faces);
    ("corners", q.corners);
    ("name_bytes", q.name_bytes);
    ("shapes", q.shapes);
    ("models", q.models);
    ("model_bytes", q.model_bytes);
    ("path", q.path);
    ("steps", q.steps);
    ("touching", q.touching);
    ("grid", q.grid);
    ("formula_bytes", q.formula_bytes);
    ("states", q.states);
    ("seconds", q.seconds);
    ("memory_mib", q.memory_mib);
  ]

let default_states = 100_000
