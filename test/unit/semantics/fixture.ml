(* Small networks made by hand: cubes of side 2 with the face names left, right, front, back, bottom, top. *)

open Scc_exact
open Scc_geometry
open Scc_calculus

let standard = Scc_engine.Standard.of_model

let q = Rat.of_int
let ratio a b = Rat.make (Z.of_int a) (Z.of_int b)

let cube = Scc_test_networks.Cube.polyhedron
let solid = Solid.make ~id:0 cube Mat.identity

let face name : Feature.t =
  match Polyhedron.find_face cube name with Some i -> Face i | None -> failwith name

let site name : Site.t = { part = 0; feature = face name }

let channel name faces =
  let features = List.map face faces in
  let sites = List.map (fun feature -> { Site.part = 0; feature }) in
  Behaviour.channel ~name ~sites:(sites features) ~closure:(sites (Polyhedron.closure cube features)) ()

let open_ name faces b = Behaviour.open_ Behaviour.Name (channel name faces) b
let co_open name faces b = Behaviour.open_ Behaviour.Co_name (channel name faces) b
let weak name faces b = Behaviour.weak (channel name faces) b
let strong entries b = Behaviour.strong (List.map (fun (n, f) -> channel n f) entries) b
let eps t b = Behaviour.delay t b
let ( + ) = Behaviour.sum
let nil = Behaviour.nil

type body = {
  name : string;
  at : int * int * int;
  velocity : int * int * int;
  mass : int;
  fixed : bool;
  absorbs : bool;
  behaviour : Behaviour.t;
  law : Law.t;
}

let body ?(velocity = (0, 0, 0)) ?(mass = 1) ?(fixed = false) ?(absorbs = false) ?(law = Law.Inertial)
    ?(behaviour = nil) name at =
  { name; at; velocity; mass; fixed; absorbs; behaviour; law }

let vec (x, y, z) = Vec.of_ints x y z

let inertial = Law.is_inertial

let model ?(definitions = [||]) ?(timestep = q 1) ?(splits = Model.Every (q 1)) bodies : Model.t =
  let leaf b : Model.leaf =
    let part : Model.part =
      { name = b.name; template = "Cube"; solid; offset = Vec.zero; open_offset = None; mass = q b.mass }
    in
    {
      name = b.name; template = "Cube"; parts = [| part |]; fixed = b.fixed; absorbs = b.absorbs; mass = q b.mass;
      law = b.law; law_at = Scc_base.Span.none;
    }
  in
  {
    leaves = Array.of_list (List.map leaf bodies);
    definitions;
    timestep;
    splits;
    ranges = [||];
    keeps_time = false;
    collisions = In_turn;
    binding = On_collision;
    bonds = Acyclic;
    blocked = Bounce;
    round_velocity = None;
    lots = false;
    rigid = None;
    steered = List.exists (fun b -> not (inertial b.law)) bodies;
    steps = Shared;
  }

let leaf i b : State.leaf =
  { leaf = i; position = vec b.at; turned = Quaternion.identity; waited = Rat.zero;
    behaviour = Behaviour.fresh b.behaviour }

(* One process for each body. *)
let declared bodies =
  let process i b =
    State.process ~leaves:[ leaf i b ] ~bonds:[] ~velocity:(vec b.velocity) ~clock:None ()
  in
  State.make ~processes:(List.mapi process bodies) ~step:None ~time:None

(* One process of all bodies, joined by bonds (name, leaf and face, leaf and face). *)
let joined ?(velocity = (0, 0, 0)) bodies bonds =
  let finish (at, f) : State.finish = { at; site = site f } in
  let bonds = List.map (fun (name, one, two) -> State.bond name (finish one) (finish two)) bonds in
  let leaves = List.mapi leaf bodies in
  State.make
    ~processes:[ State.process ~leaves ~bonds ~velocity:(vec velocity) ~clock:None () ]
    ~step:None ~time:None

let ok = function Ok x -> x | Error _ -> Alcotest.fail "a law of motion could not be evaluated"

let labels m transitions =
  List.map
    (fun (t : Scc_semantics.Transition.t) -> Scc_semantics.Transition.label_to_string m t.label)
    transitions

(* The transitions of a state, and those of the initial state of a network. *)
let successors m s = ok (Scc_semantics.Network.successors (standard m) s)
let start m s = ok (Scc_semantics.Network.initial (standard m) s)

(* Takes the transition with a label. *)
let take m s label =
  let named t =
    String.equal (Scc_semantics.Transition.label_to_string m t.Scc_semantics.Transition.label) label
  in
  let all = successors m s in
  match List.find_opt named all with
  | Some t -> t.target
  | None -> Alcotest.failf "no %s among %s" label (String.concat "; " (labels m all))

let velocity s leaf =
  Vec.to_string (Option.get (State.home s leaf)).velocity

let check_labels what expected m s =
  Alcotest.(check (list string)) what expected (labels m (successors m s))
