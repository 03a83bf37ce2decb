open Scc_exact
open Scc_polyhedra
open Scc_calculus
open Scc_semantics
open Scc_state_sets
open Scc_symbolic

let successors c s = match Network.successors c s with Ok ts -> ts | Error _ -> failwith "a fault"
let targets ts = List.map (fun (t : Transition.t) -> t.target) ts

let labelled c label s =
  targets (List.filter (fun (t : Transition.t) -> Transition.equal_label t.label label) (successors c s))

let step c s : Concrete.step -> State.t list = function
  | Happens label -> labelled c label s
  | Passes d -> labelled c (Transition.Time d) s
  | Passes_some d -> (
      match Network.wait c s d with Ok t -> targets (Option.to_list t) | Error _ -> failwith "a fault")

let show m : Concrete.step -> string = function
  | Happens label -> Transition.label_to_string m label
  | Passes d -> "time " ^ Rat.to_string d
  | Passes_some d -> "some time " ^ Rat.to_string d

let follow c initial (run : Concrete.t) =
  let m = Semantics.model c in
  let rec go states before = function
    | [] -> Ok states
    | s :: rest -> (
        let before = before @ [ show m s ] in
        match List.concat_map (fun state -> step c state s) states with
        | [] -> Error (String.concat "; " before)
        | states -> go states before rest)
  in
  go [ initial ] [] run.steps

(* {1 States in zones} *)

let same_bones (p : State.process) (q : State.process) =
  let leaves (p : State.process) = List.map (fun (l : State.leaf) -> l.leaf) (Array.to_list p.leaves) in
  List.equal Int.equal (leaves p) (leaves q)
  && List.equal State.equal_bond (Array.to_list p.bonds) (Array.to_list q.bonds)
  && Vec.equal p.velocity q.velocity
  && Bool.equal (Option.is_some p.clock) (Option.is_some q.clock)

let all_bones (a : State.t) (b : State.t) =
  List.equal same_bones (Array.to_list a.processes) (Array.to_list b.processes)

(* Terms that differ in nil, in equal summands and in names that stand for their bodies are the same behaviour: an
   eps(t) that turns out to be eps(0) is gone before the term is made on one side, and after that on the other, and
   what has aged is unfolded and tidied there (readings I-14 and I-17). *)
let tidied (definitions : Behaviour.definitions) (b : Behaviour.aged) =
  let rec summands = function
    | Behaviour.Sum (x, y) -> summands x @ summands y
    | Nil -> []
    | Call k -> summands definitions.(k).body
    | other -> [ other ]
  in
  match List.sort_uniq Behaviour.compare (summands b.term) with
  | [] -> Behaviour.aged b.origin Behaviour.nil
  | x :: rest -> Behaviour.aged b.origin (List.fold_left Behaviour.sum x rest)

let durations (b : Behaviour.t) point =
  match b with
  | Delay (t, _) -> t
  | Wait (t, _) -> Linear.eval t point
  | Nil | Open _ | Weak _ | Strong _ | Sum _ | Call _ -> failwith "no delay"

(* How long a behaviour of the zone has aged, if it is that of the state now. *)
let age definitions known_definitions point (old : Behaviour.aged) (now : Behaviour.aged) =
  match Behaviours.delays definitions old with
  | [] -> Some Rat.zero
  | delays ->
    let all = List.map (fun d -> durations d point) delays in
    let least = List.fold_left Rat.min (List.hd all) all in
    Option.map (Rat.sub least) (Behaviours.horizon known_definitions now)

let is_in (m : Model.t) (z : Zone.t) point (s : State.t) =
  let fixed (d : Behaviour.definition) = { d with body = Scene.known point d.body } in
  let known = Array.map fixed m.definitions in
  let n = Array.length z.places in
  let old leaf = Option.map (fun p -> State.leaf_of p leaf) (State.home z.skeleton leaf) in
  let now leaf = Option.map (fun p -> State.leaf_of p leaf) (State.home s leaf) in
  let exception Other in
  let age leaf =
    match (old leaf, now leaf) with
    | Some a, Some b -> (
        match age m.definitions known point a.behaviour b.behaviour with
        | Some age when Rat.sign age >= 0 ->
          let aged = Behaviours.pass known age (Scene.known_aged point a.behaviour) in
          if Behaviour.equal_aged (tidied known aged) (tidied known b.behaviour) then age else raise Other
        | Some _ | None -> raise Other)
    | _ -> Rat.zero
  in
  let clock leaf =
    match State.home s leaf with
    | Some p when p.leaves.(0).leaf = leaf -> Option.value p.clock ~default:Rat.zero
    | Some _ | None -> Rat.zero
  in
  let place leaf =
    let at : Vec.t = match now leaf with None -> Vec.zero | Some l -> l.position in
    [ at.x; at.y; at.z ]
  in
  all_bones z.skeleton s
  &&
  match List.init n age with
  | exception Other -> false
  | ages ->
    let time =
      match (z.time, s.time) with
      | None, _ -> []
      | Some _, Some t -> [ t ]
      | Some _, None -> failwith "time is kept on one side alone"
    in
    let values =
      let places = List.concat_map place (List.init n Fun.id) in
      Array.of_list (Array.to_list point @ time @ ages @ List.init n clock @ places)
    in
    let variables = Array.map (fun i -> values.(i)) z.basis in
    let forms = Zone.coordinates z in
    Array.length forms = Array.length values
    && Array.for_all2 (fun f v -> Rat.equal (Linear.eval f variables) v) forms values
    && Polyhedron.mem z.set variables
