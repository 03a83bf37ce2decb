open Scc_exact
open Scc_geometry
open Scc_calculus
module Gen = QCheck2.Gen

type body = {
  cell : int * int * int;  (** distinct from body to body *)
  jitter : int * int * int;  (** in halves, 0 to 2 *)
  velocity : int * int * int;  (** in halves *)
  mass : int;
  shape : int;
  behaviour : int;
  fixed : bool;
  falls : bool;
}

type t = { bodies : body list; packed : bool; switches : Switches.t }

let plain bodies = { bodies; packed = false; switches = Switches.off }

(* {1 Shapes} *)

let rational n d = Rat.make (Z.of_int n) (Z.of_int d)
let int = Rat.of_int

let turned =
  match Mat.of_quaternion (int 2, int 1, int 0, int 1) with
  | Some r -> Mat.scale (rational 1 2) r
  | None -> failwith "the zero quaternion"

let sheared =
  Mat.make (Vec.make (rational 1 2) (rational 1 2) Rat.zero) (Vec.of_ints 0 1 0) (Vec.of_ints 0 0 1)

(* Linear maps that keep the cube within [-1, 1] in every coordinate. *)
let maps =
  [| Mat.identity; Mat.diagonal (Vec.make Rat.one (rational 1 2) Rat.one); turned; sheared |]

let solids = Array.mapi (fun id map -> Solid.make ~id Cube.polyhedron map) maps

(* A shape: parts as (solid, offset), within [-3, 1] along x and [-1, 1] along y and z. *)
let shapes =
  [|
    [ (0, Vec.zero) ];
    [ (1, Vec.zero) ];
    [ (2, Vec.zero) ];
    [ (3, Vec.zero) ];
    [ (0, Vec.zero); (1, Vec.of_ints (-2) 0 0) ];
  |]

(* {1 Behaviours} *)

let channel faces =
  let features = List.map (fun f -> Feature.Face f) faces in
  let sites = List.map (fun feature -> { Site.part = 0; feature }) in
  Behaviour.channel ~name:"a" ~sites:(sites features)
    ~closure:(sites (Polyhedron.closure Cube.polyhedron features)) ()

let all = channel [ 0; 1; 2; 3; 4; 5 ]
let some = channel [ 1; 3; 5 ]

(* With splits that push apart what they release, or without. *)
(* In models whose split step is 1/2. *)
let rate n : Odds.t = Rate { rate = int n; alone = Odds.within ~step:(rational 1 2) (int n) }

let definitions ~pushes ~lots : Behaviour.definitions =
  let open Behaviour in
  let push j = if pushes then rational 1 j else Rat.zero in
  (* Some ends have a chance, in one way or in two, and some are free. *)
  let weak j surface rest =
    let by odds rest = weak ~push:(push j) ?odds surface rest in
    if not lots then by None rest
    else
      match j with
      | 2 -> sum (by (Some (Chance (rational 1 3))) rest) (by (Some (Chance (rational 1 4))) nil)
      | 3 -> sum (by (Some (rate 2)) rest) (by (Some (rate 1)) nil)
      | _ -> by None rest
  in
  let strong j = strong ~push:(if pushes then rational 1 j else Rat.zero) in
  [|
    { name = "Sticky"; body = open_ Name all (call 1) };
    { name = "Stuck"; body = sum (weak 3 all (call 0)) (delay (rational 1 2) (strong 1 [ all ] nil)) };
    { name = "CoSticky"; body = open_ Co_name some (call 3) };
    {
      name = "CoStuck";
      body =
        sum
          (weak 4 all (call 2))
          (sum (strong 2 [ all ] nil) (open_ Name all nil));
    };
    { name = "Late"; body = delay (rational 1 3) (sum (call 0) (call 2)) };
    (* in crowds only *)
    { name = "Glue"; body = open_ Name all (call 6) };
    { name = "Glued"; body = delay (rational 2 5) (strong 5 [ all ] (call 5)) };
    { name = "CoGlue"; body = open_ Co_name all (call 8) };
    { name = "CoGlued"; body = strong 7 [ all ] (delay (rational 1 7) (call 7)) };
    { name = "Pulse"; body = delay (rational 1 4) (call 10) };
    { name = "Pulsed"; body = delay (rational 1 3) (sum (call 0) (call 9)) };
    { name = "Loose"; body = open_ Co_name all (call 12) };
    { name = "Loosened"; body = weak 3 all (delay (rational 1 9) (call 11)) };
    (* where bonds close rings only: as many bonds as there are neighbours *)
    {
      name = "Link";
      body =
        sum
          (sum (open_ Name all (call 13)) (open_ Co_name all (call 13)))
          (sum (weak 2 all (delay (rational 1 5) (call 13))) (delay (rational 1 2) (call 14)));
    };
    {
      name = "Linked";
      body =
        sum (strong 1 [ all ] (call 13))
          (sum (strong 2 [ all; all ] (call 13)) (strong 3 [ all; all; all ] nil));
    };
  |]

let behaviours = 6
let behaviours_in_crowds = 14
let link = 14
let behaviour i = if i = 0 then Behaviour.nil else Behaviour.call (i - 1)

(* {1 Networks} *)

(* About half of the fixed ones, where some may absorb: they do nothing. *)
let absorbs switches b = Switches.absorbs switches && b.fixed && b.behaviour mod 2 = 0

let leaf switches i (b : body) : Model.leaf =
  let name = Printf.sprintf "p%d" i in
  let parts = shapes.(b.shape) in
  let mass = rational b.mass (List.length parts) in
  let part j (solid, offset) : Model.part =
    let name = if List.length parts = 1 then name else Printf.sprintf "%s.s%d" name j in
    { name; template = "Cube"; solid = solids.(solid); offset; open_offset = None; mass }
  in
  {
    name; template = "Cube"; parts = Array.of_list (List.mapi part parts); fixed = b.fixed;
    absorbs = absorbs switches b; mass = int b.mass; law = (if b.falls then Switches.law switches else Inertial);
    law_at = Scc_base.Span.none;
  }

let model { bodies; switches; _ } : Model.t =
  Switches.apply switches
    {
      leaves = Array.of_list (List.mapi (leaf switches) bodies);
      definitions = definitions ~pushes:(Switches.pushes switches) ~lots:(Switches.has_lots switches);
      timestep = rational 1 2;
      splits = Every (rational 1 2);
      ranges = [||];
      keeps_time = false;
      collisions = In_turn;
      binding = On_collision;
      bonds = Acyclic;
      blocked = Bounce;
      round_velocity = None;
      lots = false;
      rigid = None;
      steered = List.exists (fun b -> b.falls) bodies;
      steps = Shared;
    }

(* Cells are as large as the greatest shape and the greatest jitter together; packed, as large as a cube. *)
let position ~packed b =
  let x, y, z = b.cell and jx, jy, jz = b.jitter in
  if packed then Vec.of_ints (2 * x) (2 * y) (2 * z)
  else
    Vec.make
      (Rat.add (int (5 * x)) (rational jx 2))
      (Rat.add (int (3 * y)) (rational jy 2))
      (Rat.add (int (3 * z)) (rational jz 2))

let velocity b =
  let x, y, z = b.velocity in
  if b.fixed then Vec.zero else Vec.make (rational x 2) (rational y 2) (rational z 2)

let declared { bodies; packed; switches } =
  let process i b =
    let behaviour = Behaviour.fresh (if absorbs switches b then Behaviour.nil else behaviour b.behaviour) in
    let position = position ~packed b in
    let leaf : State.leaf = { leaf = i; position; turned = Quaternion.identity; waited = Rat.zero; behaviour } in
    State.process ~leaves:[ leaf ] ~bonds:[] ~velocity:(velocity b) ~clock:None ()
  in
  State.make ~processes:(List.mapi process bodies) ~step:None ~time:None

let start network =
  let m = model network in
  (m, Reach.initial m (declared network))

(* {1 Generation} *)

let three g = Gen.triple g g g

let same_cell a b =
  let x, y, z = a.cell and x', y', z' = b.cell in
  x = x' && y = y' && z = z'

let distinct bodies =
  List.fold_left (fun kept b -> if List.exists (same_cell b) kept then kept else b :: kept) [] bodies
  |> List.rev

let body ?(shapes = Array.length shapes) ~steered ~cells ~behaviours () =
  let open Gen in
  let* cell = three (0 -- (cells - 1)) and* jitter = three (0 -- 2) and* velocity = three (-3 -- 3) in
  let* mass = 1 -- 3 and* shape = 0 -- (shapes - 1) in
  let* behaviour = 0 -- (behaviours - 1) and* fixed = map (fun n -> n = 0) (0 -- 9) in
  let+ falls = if steered then map (fun n -> n = 0) (0 -- 1) else pure false in
  { cell; jitter; velocity; mass; shape; behaviour; fixed; falls = falls && not fixed }

let apart ~steered = Gen.(map distinct (list_size (2 -- 6) (body ~steered ~cells:2 ~behaviours ())))

(* All but the glued pair fit into a cell that is as large as a cube. Most are cubes, and most are inert: they
   touch, and bounce. *)
let packed ~steered =
  let open Gen in
  let plainly b =
    let+ cube = 0 -- 3 and+ inert = 0 -- 2 in
    { b with shape = (if cube > 0 then 0 else b.shape); behaviour = (if inert > 0 then 0 else b.behaviour) }
  in
  map distinct (list_size (4 -- 8) (body ~shapes:4 ~steered ~cells:2 ~behaviours () >>= plainly))

let generate ?(steered = false) () = Gen.map plain (apart ~steered)

let switched ?(steered = false) ?draws () =
  let open Gen in
  let* switches = Switches.generate ?draws () and* tight = frequencyl [ (2, true); (1, false) ] in
  let* bodies = if tight then packed ~steered else apart ~steered in
  let linking b = map (fun linked -> if linked then { b with behaviour = link } else b) bool in
  let+ bodies = if Switches.closes_rings switches then flatten_l (List.map linking bodies) else pure bodies in
  { bodies; packed = tight; switches }

let absorbing () =
  let walls = List.mapi (fun i b -> if i mod 3 = 2 then { b with fixed = true; behaviour = 0 } else b) in
  let network bodies = { bodies = walls bodies; packed = false; switches = Switches.absorbing } in
  Gen.map network (apart ~steered:false)

let linked =
  let linking n = { n with behaviour = link } in
  Gen.map
    (fun bodies -> { bodies = List.map linking bodies; packed = true; switches = Switches.rings })
    (packed ~steered:false)

let rounding () =
  Gen.map (fun n -> { n with switches = Switches.rounding }) (switched ())

let crowd =
  let body = body ~steered:false ~cells:3 ~behaviours:behaviours_in_crowds () in
  Gen.map (fun bodies -> plain (distinct bodies)) (Gen.list_size Gen.(10 -- 30) body)

let bystander i =
  {
    cell = (i, 333_333, 0); jitter = (0, 0, 0); velocity = (0, 0, 0); mass = 1; shape = 0; behaviour = 0;
    fixed = i mod 2 = 0; falls = false;
  }

let map f n = { n with bodies = f n.bodies }
let with_bystanders = map (fun bodies -> bodies @ List.init 16 bystander)
let none = plain []
let inert = map (List.map (fun b -> { b with behaviour = 0 }))
let sticking = map (List.mapi (fun i b -> { b with behaviour = 1 + (2 * (i mod 2)) }))
let all_free = map (List.map (fun b -> { b with fixed = false }))
let without_pushes n = { n with switches = Switches.without_pushes n.switches }
let with_switches switches n = { n with switches }
let like a b = { b with switches = a.switches }

let print { bodies; packed; switches } =
  let triple (x, y, z) = Printf.sprintf "(%d,%d,%d)" x y z in
  let body b =
    Printf.sprintf "{cell %s jitter %s/2 velocity %s/2 mass %d shape %d behaviour %d%s%s}" (triple b.cell)
      (triple b.jitter) (triple b.velocity) b.mass b.shape b.behaviour
      (if b.fixed then " fixed" else "")
      (if b.falls then " falls" else "")
  in
  let kind = (if packed then "packed" else "apart") ^ Switches.print switches in
  String.concat "\n" (kind :: List.map body bodies)
