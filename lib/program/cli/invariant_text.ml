open Scc_exact
open Scc_polyhedra
open Scc_calculus
module Invariant = Scc_certificate.Invariant

let vector (v : Vec.t) = Printf.sprintf "(%s)" (String.concat ", " (List.map Rat.to_string [ v.x; v.y; v.z ]))

let leaf_text (m : Model.t) (l : State.leaf) =
  match l.behaviour.term with
  | Behaviour.Nil -> m.leaves.(l.leaf).name
  | term ->
    Printf.sprintf "%s [%s]" m.leaves.(l.leaf).name
      (Scc_runs.Behaviour_text.to_string m ~leaf:l.leaf term)

let process_text (m : Model.t) (p : State.process) =
  let leaves = String.concat " + " (List.map (leaf_text m) (Array.to_list p.leaves)) in
  Printf.sprintf "%s, velocity %s" leaves (vector p.velocity)

(* Every coordinate that has one value in all kinds says nothing. *)
let said (m : Model.t) (invariant : Invariant.t) =
  let value (l : Invariant.location) i =
    let only c =
      Constraint.mentions c i && (c : Constraint.t).relation = Equal
      && List.for_all (fun j -> j = i || not (Constraint.mentions c j)) (List.init (Invariant.dimension m) Fun.id)
    in
    List.find_opt only (Polyhedron.equalities l.set)
  in
  let constant i =
    match List.map (fun l -> value l i) invariant.locations with
    | Some first :: rest -> List.for_all (Option.fold ~none:false ~some:(Constraint.equal first)) rest
    | None :: _ | [] -> false
  in
  let constants = List.filter constant (List.init (Invariant.dimension m) Fun.id) in
  fun c -> not (List.exists (Constraint.mentions c) constants)

let to_string (m : Model.t) (invariant : Invariant.t) =
  let said = said m invariant in
  let location number (l : Invariant.location) =
    let moves (p : State.process) = not (Scc_calculus.State.mass m p = None) in
    let processes = List.filter moves (Array.to_list l.skeleton.processes) in
    let constraints = List.filter said (Polyhedron.constraints l.set) in
    let numbers = List.map (Text.constraint_ ~name:(Invariant.name m)) constraints in
    Printf.sprintf "%d." (number + 1)
    :: List.map (fun p -> "  " ^ process_text m p) processes
    @ List.map (fun e -> "  just now: " ^ Scc_property.Show.event m invariant.events.(e)) l.arrived
    @ List.map (fun text -> "    " ^ text) numbers
  in
  let heading =
    Printf.sprintf "%d kinds of states, of which no run leaves the union:" (List.length invariant.locations)
  in
  String.concat "\n" (heading :: List.concat (List.mapi location invariant.locations)) ^ "\n"
