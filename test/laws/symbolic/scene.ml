open Scc_exact
open Scc_geometry
open Scc_polyhedra
open Scc_calculus
module Gen = QCheck2.Gen

type duration = Known of int  (** in halves *) | Unknown of { from : int; parameter : int }

type term =
  | Nil
  | Again
  | Open of { co : bool; name : int; surface : int; next : term }
  | Weak of { name : int; surface : int; push : int; next : term }
  | Strong of { name : int; surface : int; push : int; next : term }
  | Delay of duration * term
  | Sum of term * term

type kind = Free | Fixed | Absorbing

type body = {
  shape : int;
  base : int * int * int;
  moved : (int * int * int) option;  (** parameter, axis, sign *)
  velocity : int * int * int;
  mass : int;
  kind : kind;
  behaviour : term;
}

type splits = Grid | Any

type t = {
  ranges : (int * int * bool * bool) list;  (** from, to, and whether the ends belong to it *)
  bodies : body list;
  dimer : bool;
  splits : splits;
  together : bool;
  contact : bool;  (** binding contact *)
  timed : bool;
}

(* {1 Behaviours} *)

let names = [| "a"; "b" |]
let rat n d = Rat.make (Z.of_int n) (Z.of_int d)
let int = Rat.of_int

(* All faces, some, one; edges and vertices that are listed alone. *)
let features (p : Scc_geometry.Polyhedron.t) surface =
  let faces = List.init (Array.length p.faces) (fun i -> Feature.Face i) in
  match surface with
  | 0 -> (faces, [])
  | 1 -> (List.filteri (fun i _ -> i mod 2 = 1) faces, [])
  | 2 -> (List.filteri (fun i _ -> i mod 3 = 2) faces, [])
  | 3 -> ([], [ Feature.Edge 0; Feature.Edge 3; Feature.Edge 5 ])
  | 4 -> ([], [ Feature.Vertex 0; Feature.Vertex 2 ])
  | _ -> ([ Feature.Edge 1; Feature.Face 0 ], [ Feature.Vertex 3 ])

(* By contact, nothing binds without its closure (reading I-33). *)
let channel ~contact shape name surface =
  let part = if surface mod 2 = 1 then List.length Bodies.shapes.(shape) - 1 else 0 in
  let solid, _ = List.nth Bodies.shapes.(shape) part in
  let p = Bodies.solids.(solid).polyhedron in
  let sites, only = features p surface in
  let sites, only = if contact then (sites @ only, []) else (sites, only) in
  let at = List.map (fun feature -> { Site.part; feature }) in
  Behaviour.channel ~only:(at only) ~name:names.(name) ~sites:(at sites)
    ~closure:(at (Scc_geometry.Polyhedron.closure p sites)) ()

let form k from parameter = Linear.of_terms k ~constant:(int from) [ (parameter, Rat.one) ]

let rec term k ~contact ~self shape t =
  let go = term k ~contact ~self shape and channel = channel ~contact in
  match t with
  | Nil -> Behaviour.nil
  | Again -> Behaviour.call self
  | Open { co; name; surface; next } ->
    Behaviour.open_ (if co then Co_name else Name) (channel shape name surface) (go next)
  | Weak { name; surface; push; next } -> Behaviour.weak ~push:(int push) (channel shape name surface) (go next)
  | Strong { name; surface; push; next } ->
    Behaviour.strong ~push:(int push) [ channel shape name surface ] (go next)
  | Delay (Known n, next) -> Behaviour.delay (rat n 2) (go next)
  | Delay (Unknown { from; parameter }, next) -> Behaviour.wait (form k from parameter) (go next)
  | Sum (a, b) -> Behaviour.sum (go a) (go b)

(* {1 Models} *)

let parameters s = List.length s.ranges

let leaf i (b : body) : Model.leaf =
  let parts = Bodies.shapes.(b.shape) in
  let name = Printf.sprintf "p%d" i in
  let part j (solid, offset) : Model.part =
    let name = if List.length parts = 1 then name else Printf.sprintf "%s.s%d" name j in
    let mass = rat b.mass (List.length parts) in
    { name; template = "Shape"; solid = Bodies.solids.(solid); offset; open_offset = None; mass }
  in
  {
    name; template = "Shape"; parts = Array.of_list (List.mapi part parts);
    fixed = (match b.kind with Free -> false | Fixed | Absorbing -> true);
    absorbs = (match b.kind with Absorbing -> true | Free | Fixed -> false);
    mass = int b.mass; law = Inertial; law_at = Scc_base.Span.none;
  }

let range i (low, high, from, to_) : Ranges.range =
  {
    name = Printf.sprintf "x%d" i;
    low = { value = int low; included = from };
    high = { value = int high; included = to_ };
  }

let body_term s i =
  let b = List.nth s.bodies i in
  term (parameters s) ~contact:s.contact ~self:i b.shape b.behaviour

let model s : Model.t =
  {
    leaves = Array.of_list (List.mapi leaf s.bodies);
    definitions =
      (let definition i = { Behaviour.name = Printf.sprintf "K%d" i; body = body_term s i } in
       Array.init (List.length s.bodies) definition);
    timestep = Rat.one;
    splits = (match s.splits with Grid -> Every Rat.one | Any -> Any_time);
    ranges = Array.of_list (List.mapi range s.ranges);
    keeps_time = s.timed;
    collisions = (if s.together then Together else In_turn);
    binding = (if s.contact then On_contact else On_collision);
    bonds = Acyclic;
    blocked = Bounce;
    round_velocity = None;
    lots = false;
    rigid = None;
    steered = false;
    steps = Shared;
  }

(* Of the leaf's reference point. *)
let place s (b : body) =
  let k = parameters s in
  let x, y, z = b.base in
  let along axis c =
    match b.moved with
    | Some (parameter, a, sign) when a = axis -> Linear.of_terms k ~constant:(int c) [ (parameter, int sign) ]
    | Some _ | None -> Linear.constant k (int c)
  in
  (along 0 x, along 1 y, along 2 z)

let uncertain s : Uncertain.t =
  let all f = Array.of_list (List.map f s.bodies) in
  { places = all (place s); glues = [] }

let velocity (b : body) =
  let x, y, z = b.velocity in
  match b.kind with Free -> Vec.of_ints x y z | Fixed | Absorbing -> Vec.zero

(* The first two are bound: the right side of a cube, and the left side of another. *)
let bond =
  let finish at face = { State.at; site = { Site.part = 0; feature = Feature.Face face } } in
  State.bond "a" (finish 0 3) (finish 1 2)

let declared s point =
  let at i (b : body) : State.leaf =
    let x, y, z = place s b in
    {
      leaf = i;
      position = Vec.make (Linear.eval x point) (Linear.eval y point) (Linear.eval z point);
      turned = Quaternion.identity;
      waited = Rat.zero;
      behaviour = Behaviour.fresh (match b.kind with Absorbing -> Behaviour.nil | Free | Fixed -> body_term s i);
    }
  in
  let leaves = List.mapi at s.bodies in
  let alone (l : State.leaf) =
    State.process ~leaves:[ l ] ~bonds:[] ~velocity:(velocity (List.nth s.bodies l.leaf)) ~clock:None ()
  in
  let processes =
    match leaves with
    | one :: two :: rest when s.dimer ->
      State.process ~leaves:[ one; two ] ~bonds:[ bond ] ~velocity:(velocity (List.hd s.bodies)) ~clock:None ()
      :: List.map alone rest
    | all -> List.map alone all
  in
  State.make ~processes ~step:None ~time:None

(* {1 What it is at a point} *)

let rec known point (b : Behaviour.t) =
  match b with
  | Nil -> Behaviour.nil
  | Call k -> Behaviour.call k
  | Open (p, c, b) -> Behaviour.open_ p c (known point b)
  | Weak (c, { push; odds }, b) -> Behaviour.weak ~push ?odds c (known point b)
  | Strong (l, push, b) -> Behaviour.strong ~push l (known point b)
  | Delay (t, b) -> Behaviour.delay t (known point b)
  | Wait (t, b) -> Behaviour.delay (Linear.eval t point) (known point b)
  | Sum (a, b) -> Behaviour.sum (known point a) (known point b)

let known_aged point (b : Behaviour.aged) = Behaviour.aged b.origin (known point b.term)

let model_at s ~timed point : Model.t =
  let m = model s in
  let definition (d : Behaviour.definition) = { d with body = known point d.body } in
  { m with ranges = [||]; keeps_time = timed; definitions = Array.map definition m.definitions }

let declared_at s point =
  let leaf (l : State.leaf) = { l with behaviour = Behaviour.fresh (known point l.behaviour.term) } in
  let d = declared s point in
  State.make ~processes:(List.map (State.map_leaves leaf) (Array.to_list d.processes)) ~step:None ~time:None

(* {1 Generation} *)

let three g = Gen.triple g g g

let duration ranges =
  let open Gen in
  let* unknown = bool and* n = 1 -- 4 in
  if not unknown then pure (Known n)
  else
    let* parameter = 0 -- (List.length ranges - 1) in
    let low, _, _, _ = List.nth ranges parameter in
    let+ more = 0 -- 1 in
    Unknown { from = more - min low 0; parameter }

(* Binds, and is released, perhaps after a while; perhaps again and again. *)
let sticky ranges ~bound i =
  let open Gen in
  let* co = frequencyl [ (5, i mod 2 = 1); (1, i mod 2 = 0) ] and* name = frequencyl [ (8, 0); (1, 1) ] in
  let* push = frequencyl [ (4, 0); (1, 1) ] in
  let* surface = if bound then pure 0 else frequencyl [ (6, 0); (1, 1); (1, 2); (1, 3); (1, 4); (1, 5) ] in
  let* last = oneofl [ Nil; Again; Again; Open { co; name; surface; next = Nil } ] in
  let* weak = frequencyl [ (2, true); (1, false) ] in
  let release =
    if weak then Weak { name; surface; push; next = last } else Strong { name; surface; push; next = last }
  in
  let* release =
    let late = map (fun d -> Delay (d, release)) (duration ranges) in
    frequency [ (2, pure release); (1, late); (1, map (fun d -> Sum (release, d)) late) ]
  in
  let opens = Open { co; name; surface; next = release } in
  if bound then oneof [ pure release; map (fun d -> Delay (d, release)) (duration ranges) ]
  else frequency [ (3, pure opens); (1, map (fun d -> Delay (d, opens)) (duration ranges)) ]

(* [guarded]: it may begin anew, as something has to happen first. *)
let rec behaviour ranges ~guarded depth =
  let open Gen in
  if depth = 0 then if guarded then frequencyl [ (2, Nil); (1, Again) ] else pure Nil
  else
    let next = behaviour ranges ~guarded:true (depth - 1) in
    let name = frequencyl [ (4, 0); (1, 1) ] in
    let surface = frequencyl [ (5, 0); (2, 1); (2, 2); (1, 3); (1, 4); (1, 5) ] in
    let push = frequencyl [ (4, 0); (1, 1) ] in
    let opens =
      let+ co = bool and+ name = name and+ surface = surface and+ next = next in
      Open { co; name; surface; next }
    in
    let weak =
      let+ name = name and+ surface = surface and+ push = push and+ next = next in
      Weak { name; surface; push; next }
    in
    let strong =
      let+ name = name and+ surface = surface and+ push = push and+ next = next in
      Strong { name; surface; push; next }
    in
    let delay =
      let+ d = duration ranges and+ next = behaviour ranges ~guarded (depth - 1) in
      Delay (d, next)
    in
    let sum =
      let+ a = behaviour ranges ~guarded (depth - 1) and+ b = behaviour ranges ~guarded (depth - 1) in
      Sum (a, b)
    in
    frequency [ (4, opens); (2, weak); (1, strong); (3, delay); (1, sum) ]

(* Mostly, bodies go towards the first one, which is about the origin. *)
let body ~cell ranges i =
  let open Gen in
  let cx, cy, cz = cell in
  let towards c =
    if c > 0 then frequencyl [ (4, -1); (2, 0); (1, -2) ] else frequencyl [ (5, 0); (1, 1); (1, -1) ]
  in
  let* shape = frequencyl [ (6, 0); (1, 1); (1, 2); (1, 3); (1, 4); (1, 5); (1, 6) ] in
  let* jitter = three (frequencyl [ (3, 0); (1, 1) ]) in
  let* velocity = triple (towards cx) (towards cy) (towards cz) in
  let* parameter = 0 -- (List.length ranges - 1) and* axis = 0 -- 2 and* sign = oneofl [ 1; -1 ] in
  let* is_moved = if i = 0 then pure false else frequencyl [ (3, true); (1, false) ] in
  let* mass = frequencyl [ (3, 1); (1, 2) ] and* kind = frequencyl [ (8, Free); (1, Fixed); (1, Absorbing) ] in
  let+ behaviour =
    frequency [ (1, pure Nil); (4, sticky ranges ~bound:false i); (2, behaviour ranges ~guarded:false 3) ]
  in
  let jx, jy, jz = jitter in
  let moved = if is_moved then Some (parameter, axis, sign) else None in
  {
    shape; moved; mass; kind; behaviour; velocity;
    base = ((4 * cx) + jx, (3 * cy) + jy, (3 * cz) + jz);
  }

(* Who is bound at the start: cubes side by side. *)
let as_dimer bodies releases =
  let cube base (b : body) =
    { b with shape = 0; base; moved = None; kind = (if b.kind = Absorbing then Free else b.kind) }
  in
  match bodies with
  | one :: two :: rest ->
    let x, y, z = one.base in
    let two = cube (x + 2, y, z) { two with kind = Free; velocity = one.velocity } in
    let one = cube one.base one in
    let behave (b : body) behaviour = { b with behaviour } in
    (match releases with None -> one :: two :: rest | Some (r, r') -> behave one r :: behave two r' :: rest)
  | few -> few

(* Cubes that glide along each other, or rest on each other: where they open what fits, they bind without a
   collision. *)
let gliding bodies =
  let one i (b : body) =
    let x, y, z = b.base and _, vy, _ = b.velocity in
    let moved = Option.map (fun (p, _, sign) -> (p, 1, sign)) b.moved in
    let still = { b with shape = 0; moved = None; velocity = (0, 0, 0) } in
    match i with
    | 0 -> { b with shape = 0; velocity = (0, Int.min 0 vy, 0) }
    | 1 ->
      let y = if y < 2 then y + 4 else y in
      { b with shape = 0; base = (2, y, z mod 2); velocity = (0, vy - 1, 0); moved }
    | 2 -> { still with base = (x mod 2, 0, -2) }
    | _ -> { b with shape = 0; base = (-2, -4 - (y mod 2), z mod 2); velocity = (0, 1 - Int.min 0 vy, 0); moved }
  in
  List.mapi one bodies

let dimers = Gen.frequencyl [ (1, true); (2, false) ]
let cells = [| (1, 0, 0); (0, 1, 0); (1, 1, 0); (2, 0, 0); (0, 0, 1); (0, 2, 0); (2, 1, 0) |]

let generated ~dimers =
  let open Gen in
  let range =
    let* low = frequencyl [ (3, 0); (1, -1) ] and* length = 1 -- 3 in
    let+ from = frequencyl [ (3, true); (1, false) ] and+ to_ = frequencyl [ (3, true); (1, false) ] in
    (low, low + length, from, to_)
  in
  let* ranges = list_size (frequencyl [ (3, 1); (4, 2); (2, 3) ]) range in
  let* n = frequencyl [ (2, 2); (3, 3); (2, 4) ] in
  let* order = shuffle_a cells in
  let bodies = flatten_l (List.init n (fun i -> body ~cell:(if i = 0 then (0, 0, 0) else order.(i)) ranges i)) in
  let* bodies = bodies and* dimer = dimers in
  let* one = sticky ranges ~bound:true 0 and* two = sticky ranges ~bound:true 1 in
  let* rare = frequencyl [ (3, false); (1, true) ] in
  let releases = if rare then None else Some (one, two) in
  let+ splits = oneofl [ Grid; Any ] and+ together = frequencyl [ (1, true); (2, false) ]
  and+ timed = frequencyl [ (2, true); (1, false) ]
  and+ contact = frequencyl [ (3, None); (1, Some true); (1, Some false) ] in
  let bodies = if contact = Some true then gliding bodies else bodies in
  let bodies = if dimer then as_dimer bodies releases else bodies in
  { ranges; bodies; dimer; splits; together; contact = Option.is_some contact; timed }

let generate = generated ~dimers
let generate_bound = Gen.map (fun s -> { s with splits = Any }) (generated ~dimers:(Gen.pure true))

(* {1 In words} *)

let rec term_to_string = function
  | Nil -> "nil"
  | Again -> "again"
  | Open { co; name; surface; next } ->
    Printf.sprintf "<%s%s,%d>.%s" (if co then "~" else "") names.(name) surface (term_to_string next)
  | Weak { name; surface; push; next } ->
    Printf.sprintf "omega(%s,%d;%d).%s" names.(name) surface push (term_to_string next)
  | Strong { name; surface; push; next } ->
    Printf.sprintf "rho(%s,%d;%d).%s" names.(name) surface push (term_to_string next)
  | Delay (Known n, next) -> Printf.sprintf "eps(%d/2).%s" n (term_to_string next)
  | Delay (Unknown { from; parameter }, next) ->
    Printf.sprintf "eps(%d+x%d).%s" from parameter (term_to_string next)
  | Sum (a, b) -> Printf.sprintf "(%s + %s)" (term_to_string a) (term_to_string b)

let print s =
  let triple (x, y, z) = Printf.sprintf "(%d,%d,%d)" x y z in
  let body i (b : body) =
    let moved = match b.moved with
      | None -> ""
      | Some (p, axis, sign) -> Printf.sprintf " %+d x%d along %d" sign p axis
    in
    Printf.sprintf "p%d: shape %d at %s%s velocity %s mass %d%s %s" i b.shape (triple b.base) moved
      (triple b.velocity) b.mass
      (match b.kind with Free -> "" | Fixed -> " fixed" | Absorbing -> " absorbing")
      (term_to_string b.behaviour)
  in
  String.concat "\n"
    (Printf.sprintf "%s%s%s%s%s; %s"
       (match s.splits with Grid -> "grid" | Any -> "any time")
       (if s.dimer then " dimer" else "")
       (if s.together then " together" else "")
       (if s.contact then " contact" else "")
       (if s.timed then " timed" else "")
       (Ranges.to_string (model s).ranges)
     :: List.mapi body s.bodies)
