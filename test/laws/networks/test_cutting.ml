(* The law Cutting: bodies cut into flush parts bounce and bind as they did. *)

open Scc_exact
open Scc_geometry
open Scc_calculus
open Scc_semantics
open Scc_test_networks
module Gen = QCheck2.Gen

let say = Printf.sprintf
let fail_on = function None -> true | Some why -> QCheck2.Test.fail_report why

let straight_states n =
  let m, start = Random_network.start n in
  (m, Reach.states m start ~limit:40)

(* {1 Bounces} *)

(* Cuts the only part of a leaf through its middle, across an axis. *)
let cut_leaf axis (l : Model.leaf) =
  match l.parts with
  | [| part |] when part.solid.polyhedron == Cube.polyhedron ->
    let one x =
      let at i = if axis = i then x else Rat.zero in
      Vec.make (at 0) (at 1) (at 2)
    in
    let half = Rat.make Z.one (Z.of_int 2) in
    let all_but = Vec.sub (Vec.of_ints 1 1 1) (one half) in
    let linear = Mat.mul part.solid.linear (Mat.diagonal all_but) in
    let solid = Solid.make ~id:(part.solid.id + (100 * (axis + 1))) part.solid.polyhedron linear in
    let piece name x : Model.part =
      let offset = Vec.add part.offset (Mat.apply part.solid.linear (one x)) in
      { part with name; solid; offset; mass = Rat.mul half part.mass }
    in
    { l with parts = [| piece (l.name ^ ".one") (Rat.neg half); piece (l.name ^ ".two") half |] }
  | _ -> l

let cut axes =
  let model (m : Model.t) =
    let leaf i l = match List.nth axes (i mod List.length axes) with 3 -> l | axis -> cut_leaf axis l in
    { m with leaves = Array.mapi leaf m.leaves }
  in
  Symmetry.make "cut" ~model Fun.id

let cut_straight name ~count networks =
  QCheck2.Test.make ~name ~count
    ~print:(fun (n, _) -> Random_network.print n)
    (Gen.pair networks Gen.(list_repeat 6 (0 -- 3)))
    (fun (n, axes) ->
       let m, states = straight_states (Random_network.inert n) in
       fail_on (Symmetry.broken (cut axes) m states))

(* Where bodies turn, the cut is seen: in the grid of instants, and in the corners that count. *)
let cut_is_seen () =
  let rand = Random.State.make [| 42 |] in
  let features = { Random_rigid.anything with dynamics = `Constant_spin; plain = true; behaves = false } in
  let generate = Random_rigid.generate features in
  let broken n =
    let m, states = Rigid_reach.reached n in
    Option.is_some (Symmetry.broken (cut [ 0; 1; 2 ]) m states)
  in
  Alcotest.(check bool) "some network shows it" true (List.exists broken (Gen.generate ~rand ~n:30 generate))

(* {1 Bindings}

   The two halves of a face have the channels that it had. A leaf that is cut has behaviours of its own, since
   channels name parts: the definitions are there once for each way to cut. *)

(* The halves that a face is on: 0, 1 or both. *)
let halves axis face =
  let low, high = List.nth [ (2, 3); (4, 5); (0, 1) ] axis in
  if face = low then [ 0 ] else if face = high then [ 1 ] else [ 0; 1 ]

let cut_channel axis (c : Behaviour.channel) =
  let of_site (site : Site.t) =
    match site.feature with
    | Face f -> List.map (fun part -> { Site.part; feature = Feature.Face f }) (halves axis f)
    | Edge _ | Vertex _ -> failwith "channels of random networks are faces"
  in
  let sites = List.concat_map of_site c.sites in
  let closure (site : Site.t) =
    List.map (fun feature -> { site with feature }) (Polyhedron.closure Cube.polyhedron [ site.feature ])
  in
  Behaviour.channel ~name:c.name ~sites ~closure:(List.concat_map closure sites) ()

let rec cut_behaviour axis shift (b : Behaviour.t) =
  let again = cut_behaviour axis shift and channel = cut_channel axis in
  match b with
  | Nil -> b
  | Call k -> Behaviour.call (k + shift)
  | Open (polarity, c, b) -> Behaviour.open_ polarity (channel c) (again b)
  | Weak (c, { push; odds }, b) -> Behaviour.weak ~push ?odds (channel c) (again b)
  | Strong (l, push, b) -> Behaviour.strong ~push (List.map channel l) (again b)
  | Delay (t, b) -> Behaviour.delay t (again b)
  | Wait (t, b) -> Behaviour.wait t (again b)
  | Sum (b, c) -> Behaviour.sum (again b) (again c)

(* How each leaf is cut; one that has two parts is not. *)
let axis_of axes (m : Model.t) leaf =
  if Array.length m.leaves.(leaf).parts > 1 then 3 else List.nth axes (leaf mod List.length axes)

let shift_of (m : Model.t) axis = (axis + 1) * Array.length m.definitions

let cut_term axes m leaf term =
  match axis_of axes m leaf with 3 -> term | axis -> cut_behaviour axis (shift_of m axis) term

let with_definitions (m : Model.t) =
  let definition axis (d : Behaviour.definition) = { d with body = cut_behaviour axis (shift_of m axis) d.body } in
  let copy axis = Array.map (definition axis) m.definitions in
  { m with definitions = Array.concat [ m.definitions; copy 0; copy 1; copy 2 ] }

let cut_state axes (m : Model.t) (s : State.t) =
  let leaf (l : State.leaf) =
    let shift k = match axis_of axes m l.leaf with 3 -> k | axis -> k + shift_of m axis in
    let term = cut_term axes m l.leaf l.behaviour.term in
    { l with behaviour = Behaviour.aged (Option.map shift l.behaviour.origin) term }
  in
  let process p = State.map_leaves leaf p in
  State.make ~processes:(List.map process (Array.to_list s.processes)) ~step:s.step ~time:s.time

(* What a transition is, whatever features a bond names, and where it leads. *)
type seen = { label : string; state : State.t }

let unbound (s : State.t) = Array.for_all (fun (p : State.process) -> p.bonds = [||]) s.processes

(* The bond of a state as one between the first sites of its leaves. *)
let plain_bond (b : State.bond) =
  let finish (f : State.finish) = { f with site = { Site.part = 0; feature = Feature.Face 0 } } in
  State.bond b.name (finish b.one) (finish b.two)

let plain (s : State.t) =
  let process (p : State.process) =
    State.process
      ~leaves:(Array.to_list p.leaves)
      ~bonds:(List.map plain_bond (Array.to_list p.bonds))
      ~velocity:p.velocity ~clock:None ()
  in
  State.make ~processes:(List.map process (Array.to_list s.processes)) ~step:s.step ~time:s.time

let see (t : Transition.t) state =
  let label =
    match t.label with
    | Bind b -> say "bind %s %d %d" b.name b.one.at b.two.at
    | Close b -> say "close %s %d %d" b.name b.one.at b.two.at
    | Bounce { firsts; _ } -> String.concat " " ("bounce" :: List.map string_of_int firsts)
    | Time d -> say "time %s" (Rat.to_string d)
    | Absorb { first; absorber } -> say "absorb %d %d" first absorber
    | Draw { first; given; chance } ->
      say "draw %d %s %s" first (Given.to_string given) (Rat.to_string chance)
    | Lot { decision; chance; _ } -> say "%s %s" (Transition.decision_to_string decision) (Rat.to_string chance)
    | Weak_split _ | Strong_split _ -> "split"
  in
  { label; state = plain state }

let includes some all =
  List.find_opt
    (fun a -> not (List.exists (fun b -> String.equal a.label b.label && State.equal a.state b.state) all))
    some

(* Of states without bonds. *)
let binds_alike axes m states =
  let symmetry = cut axes in
  let image = with_definitions (symmetry.model m) in
  List.find_map
    (fun (s, transitions) ->
       if not (unbound s) then None
       else
         let image_of = cut_state axes m in
         let whole = List.map (fun (t : Transition.t) -> see t (image_of t.target)) transitions in
         let parts =
           List.map (fun (t : Transition.t) -> see t t.target) (Reach.successors image (image_of s))
         in
         match (includes whole parts, includes parts whole) with
         | None, None -> None
         | Some lost, _ -> Some ("lost: " ^ lost.label)
         | None, Some more -> Some ("more: " ^ more.label))
    states

let bindings name ~count networks =
  QCheck2.Test.make ~name ~count
    ~print:(fun (n, axes) -> Random_network.print n ^ String.concat " " (List.map string_of_int axes))
    (Gen.pair networks Gen.(list_repeat 6 (0 -- 3)))
    (fun (n, axes) ->
       let m, states = straight_states n in
       fail_on (binds_alike axes m states))

let suite =
  let any = Random_network.generate () and switched = Random_network.switched () in
  ("cutting",
   [
     ( "Cutting",
       Scc_test_support.Property.cases
         [
           cut_straight "Cutting: bounces of random networks" ~count:300 any;
           cut_straight "Cutting: bounces, with the switches of a model" ~count:100 switched;
           bindings "Cutting: who may bind to whom, and what comes of it" ~count:300 any;
           bindings "Cutting: who may bind, with the switches of a model" ~count:100 switched;
         ]
       @ [ Alcotest.test_case "Cutting: fails for bodies that turn" `Quick cut_is_seen ] );
   ])
