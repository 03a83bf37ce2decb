open Scc_exact
open Scc_geometry
open Scc_calculus

let standard = Scc_engine.Standard.of_model
module Gen = QCheck2.Gen

type features = {
  dynamics : [ `Any | `Constant_spin | `Free_body ];
  rounds : bool;
  laws : bool;
  behaves : bool;
  plain : bool;
  switched : bool;
  draws : bool;
}

let anything =
  { dynamics = `Any; rounds = false; laws = false; behaves = true; plain = false; switched = false; draws = true }

type body = {
  cell : int * int * int;  (** distinct from body to body *)
  aim : int * int * int;  (** off the middle, in quarters *)
  speed : int;  (** in fifths of the way to the middle *)
  spin : int * int * int;  (** in halves *)
  mass : int;
  shape : int;
  behaviour : int;
  second : int;  (** of the second leaf, if there is one *)
  fixed : bool;
  falls : bool;
}

type t = {
  dynamics : Model.dynamics;
  rounding : int option;
  switches : Switches.t;
  packed : bool;
  bodies : body list;
}

(* {1 Shapes} *)

let rational n d = Rat.make (Z.of_int n) (Z.of_int d)
let int = Rat.of_int

let corner_polyhedron =
  let ifs =
    {
      Polyhedron.ifs_vertices =
        [|
          ("o", Vec.of_ints 0 0 0); ("x", Vec.of_ints 2 0 0); ("y", Vec.of_ints 0 2 0); ("z", Vec.of_ints 0 0 3);
        |];
      ifs_faces =
        [| ("xy", [| 0; 2; 1 |]); ("xz", [| 0; 1; 3 |]); ("yz", [| 0; 3; 2 |]); ("far", [| 1; 2; 3 |]) |];
    }
  in
  match Polyhedron.of_ifs ifs with Ok p -> p | Error _ -> failwith "the tetrahedron is refused"

let cube ~id = Solid.make ~id Cube.polyhedron Mat.identity

let plank ~id =
  Solid.make ~id Cube.polyhedron (Mat.diagonal (Vec.make Rat.one (rational 1 2) (rational 1 4)))

let tetrahedron ~id = Solid.make ~id corner_polyhedron Mat.identity

let turned ~id =
  match Mat.of_quaternion (int 2, int 1, int 0, int 1) with
  | Some r -> Solid.make ~id Cube.polyhedron (Mat.scale (rational 1 2) r)
  | None -> failwith "the zero quaternion"

let solids = [| cube ~id:0; plank ~id:1; tetrahedron ~id:2; turned ~id:3 |]

(* A body: leaves, each with its parts as (solid, offset), and the place of the leaf; within 7/2 of the middle of
   its cell. Each leaf is bound to the one before it, the right face to the left face. *)
let shapes =
  let single solid = [ ([ (solid, Vec.zero) ], Vec.zero) ] in
  [|
    single 0; single 1; single 2; single 3;
    (* a cube off its centre *)
    [ ([ (0, Vec.of_ints 1 0 1) ], Vec.of_ints (-1) 0 0) ];
    (* glued: an angle of two, and three in a row *)
    [ ([ (0, Vec.zero); (1, Vec.make (int 2) (rational 1 2) Rat.zero) ], Vec.zero) ];
    [ ([ (1, Vec.of_ints (-2) 0 0); (1, Vec.zero); (1, Vec.of_ints 2 0 0) ], Vec.zero) ];
    [ ([ (1, Vec.zero); (1, Vec.make (int 1) (rational 1 2) (rational 1 2)) ], Vec.zero) ];
    (* bound at birth *)
    [ ([ (0, Vec.zero) ], Vec.of_ints (-1) 0 0); ([ (0, Vec.zero) ], Vec.of_ints 1 0 0) ];
    [ ([ (1, Vec.zero) ], Vec.of_ints (-1) 0 0); ([ (1, Vec.zero) ], Vec.make Rat.one (rational 1 2) Rat.zero) ];
  |]

(* {1 Behaviours} *)

let channel faces =
  let features = List.map (fun f -> Feature.Face f) faces in
  let sites = List.map (fun feature -> { Site.part = 0; feature }) in
  Behaviour.channel ~name:"a" ~sites:(sites features)
    ~closure:(sites (Polyhedron.closure Cube.polyhedron features)) ()

let all = channel [ 0; 1; 2; 3; 4; 5 ]
let some = channel [ 1; 2; 5 ]

let definitions ~pushes ~rings ~lots : Behaviour.definitions =
  let push = if pushes then rational 1 2 else Rat.zero in
  let open Behaviour in
  let also b c = if rings then sum b c else b in
  let weak surface rest = weak ?odds:(if lots then Some (Odds.Chance (rational 2 5)) else None) surface rest in
  [|
    { name = "Sticky"; body = open_ Name all (call 1) };
    {
      name = "Stuck";
      body = also (sum (weak all (call 0)) (delay (rational 1 2) (strong [ all ] nil))) (open_ Name all (call 1));
    };
    { name = "CoSticky"; body = open_ Co_name some (call 3) };
    { name = "CoStuck"; body = also (sum (weak all (call 2)) (strong [ all ] nil)) (open_ Co_name all (call 3)) };
    { name = "Late"; body = delay (rational 1 3) (sum (call 0) (call 2)) };
    { name = "Breaks"; body = delay (rational 2 5) (strong ~push [ all ] nil) };
    { name = "Pulse"; body = delay (rational 1 7) (call 6) };
  |]

let behaviours = 8
let behaviour i = if i = 0 then Behaviour.nil else Behaviour.call (i - 1)

(* {1 Networks} *)

let leaves bodies =
  List.concat (List.mapi (fun i b -> List.mapi (fun j leaf -> (i, j, b, leaf)) shapes.(b.shape)) bodies)

(* Some of the fixed ones of one leaf, where some may absorb: they do nothing. *)
let absorbs switches b =
  Switches.absorbs switches && b.fixed && List.length shapes.(b.shape) = 1 && b.mass <> 2

let model_leaf switches (i, j, b, (parts, _)) : Model.leaf =
  let name = Printf.sprintf "p%d.l%d" i j in
  let part k (solid, offset) : Model.part =
    let mass = rational b.mass (Int.add (List.length parts) k) in
    let name = Printf.sprintf "%s.s%d" name k in
    { name; template = "Cube"; solid = solids.(solid); offset; open_offset = None; mass }
  in
  let parts = Array.of_list (List.mapi part parts) in
  {
    name; template = "Cube"; parts; fixed = b.fixed; absorbs = absorbs switches b;
    mass = Array.fold_left (fun sum (p : Model.part) -> Rat.add sum p.mass) Rat.zero parts;
    law = (if b.falls then Switches.law switches else Inertial);
    law_at = Scc_base.Span.none;
  }

let model { dynamics; rounding; switches; bodies; packed = _ } : Model.t =
  Switches.apply switches
    {
      leaves = Array.of_list (List.map (model_leaf switches) (leaves bodies));
      definitions = definitions ~pushes:(Switches.pushes switches) ~rings:(Switches.closes_rings switches)
          ~lots:(Switches.has_lots switches);
      timestep = Rat.one;
      splits = Every (rational 1 2);
      ranges = [||];
      keeps_time = false;
      collisions = In_turn;
      blocked = Bounce;
      binding = On_collision;
      bonds = Acyclic;
      round_velocity = rounding;
      lots = false;
      rigid =
        Some { dynamics; resolution = rational 1 1024; round_orientation = rounding };
      steered = List.exists (fun b -> b.falls && not b.fixed) bodies;
      steps = Shared;
    }

(* Packed, a cell is as large as a cube. *)
let place ~packed b =
  let x, y, z = b.cell and side = if packed then 2 else 7 in
  Vec.of_ints (side * x) (side * y) (side * z)

(* Most fly towards the middle of all, and so at each other. *)
let velocity { bodies; packed; _ } b =
  let n = List.length bodies and place = place ~packed in
  let sum = List.fold_left (fun s b -> Vec.add s (place b)) Vec.zero bodies in
  let x, y, z = b.aim in
  let target = Vec.add (Vec.scale (rational 1 n) sum) (Vec.make (rational x 4) (rational y 4) (rational z 4)) in
  if b.fixed then Vec.zero
  else
    let v = Vec.scale (rational b.speed 5) (Vec.sub target (place b)) in
    let near x = Rat.round_to x ~quantum:(rational 1 4) in
    Vec.make (near v.x) (near v.y) (near v.z)

let spin b =
  let x, y, z = b.spin in
  if b.fixed then Vec.zero else Vec.make (rational x 2) (rational y 2) (rational z 2)

let declared ({ bodies; packed; _ } as network) =
  let count = ref 0 in
  let process b =
    let first = !count in
    let leaf j (_, at) : State.leaf =
      let behaviour = Behaviour.fresh (behaviour (if j = 0 then b.behaviour else b.second)) in
      { leaf = first + j; position = Vec.add (place ~packed b) at; turned = Quaternion.identity; waited = Rat.zero;
        behaviour }
    in
    let leaves = List.mapi leaf shapes.(b.shape) in
    count := first + List.length leaves;
    let finish j face : State.finish = { at = first + j; site = { part = 0; feature = Feature.Face face } } in
    let bond j = State.bond "a" (finish j 3) (finish (j + 1) 2) in
    State.process ~leaves ~bonds:(List.init (List.length leaves - 1) bond) ~velocity:(velocity network b)
      ~spin:(spin b) ~clock:None ()
  in
  State.make ~processes:(List.map process bodies) ~step:None ~time:None

let start network =
  let m = model network in
  match Scc_semantics.Network.initial (standard m) (declared network) with
  | Ok s -> (m, s)
  | Error _ -> failwith "a law of motion could not be evaluated"

(* {1 Generation} *)

let three g = Gen.triple g g g

let distinct bodies =
  let same a b =
    let x, y, z = a.cell and x', y', z' = b.cell in
    x = x' && y = y' && z = z'
  in
  List.fold_left (fun kept b -> if List.exists (same b) kept then kept else b :: kept) [] bodies |> List.rev

let body ~packed (features : features) =
  let open Gen in
  let* cell = three (0 -- 1) and* aim = three (-2 -- 2) and* speed = 1 -- 6 in
  let* spin = three (-3 -- 3) and* spins = map (fun n -> n > 0) (0 -- 3) and* mass = 1 -- 3 in
  let* shape =
    if packed then frequencyl [ (4, 0); (1, 1); (1, 3) ]
    else if features.plain then oneofl [ 0; 1; 3 ]
    else 0 -- (Array.length shapes - 1)
  in
  let* fixed = map (fun n -> n = 0) (0 -- 4) in
  let any = if features.behaves then oneof [ 0 -- (behaviours - 1); oneofl [ 1; 3 ] ] else pure 0 in
  let* behaviour = any and* second = any in
  let+ falls = if features.laws then map (fun n -> n = 0) (0 -- 1) else pure false in
  {
    cell; aim; speed; spin = (if spins then spin else (0, 0, 0)); mass; shape; behaviour; second; fixed;
    falls = falls && not fixed;
  }

let generate (features : features) =
  let open Gen in
  let* packed = if features.switched then frequencyl [ (2, true); (1, false) ] else pure false in
  let switches = Switches.generate ~rigid:true ~draws:features.draws () in
  let* switches = if features.switched then switches else pure Switches.off in
  let* bodies = map distinct (list_size (if packed then 3 -- 5 else 2 -- 4) (body ~packed features)) in
  let* dynamics =
    match features.dynamics with
    | `Any -> oneofl [ Model.Constant_spin; Free_body ]
    | `Constant_spin -> pure Model.Constant_spin
    | `Free_body -> pure Model.Free_body
  in
  let+ rounding = if features.rounds then map Option.some (oneofl [ 4; 10; 20 ]) else pure None in
  { dynamics; rounding; switches; packed; bodies }

let all_free n = { n with bodies = List.map (fun b -> { b with fixed = false }) n.bodies }

let print ({ dynamics; rounding; switches; packed; bodies } as network) =
  let triple (x, y, z) = Printf.sprintf "(%d,%d,%d)" x y z in
  let body b =
    Printf.sprintf
      "{cell %s aim %s/4 speed %d/5 spin %s/2 mass %d shape %d behaviours %d, %d%s%s; velocity %s}" (triple b.cell)
      (triple b.aim) b.speed (triple b.spin) b.mass b.shape b.behaviour b.second
      (if b.fixed then " fixed" else "")
      (if b.falls then " falls" else "")
      (Vec.to_string (velocity network b))
  in
  let kind = match dynamics with Model.Constant_spin -> "constant spin" | Free_body -> "free body" in
  let rounding = match rounding with None -> "" | Some k -> Printf.sprintf ", rounded to 2^-%d" k in
  let kind = kind ^ rounding ^ (if packed then ", packed" else "") ^ Switches.print switches in
  String.concat "\n" (kind :: List.map body bodies)

let with_switches switches n = { n with switches }

let like a b = { b with dynamics = a.dynamics; rounding = a.rounding; switches = a.switches }
