open Scc_exact
open Scc_polyhedra
open Scc_offsets
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_state_sets

type t = bool array

let ranges (c : Instant.context) = Array.length (Semantics.model c.semantics).ranges
let all c = Array.make (ranges c) true

(* Terms are the same all along, but for the time that has passed of a delay. *)
let rec lengths (b : Behaviour.t) =
  let own = match b with Wait (f, _) -> [ f ] | _ -> [] in
  own @ List.concat_map lengths (Behaviour.parts b)

let make (c : Instant.context) predicates (zones : Zone.t list) =
  let m = Semantics.model c.semantics in
  let of_leaf (l : State.leaf) = lengths l.behaviour.term in
  let of_definition (d : Behaviour.definition) = lengths d.body in
  let of_part (p : Model.part) = Option.fold ~none:[] ~some:Place.coordinates p.open_offset in
  let of_model_leaf (l : Model.leaf) = List.concat_map of_part (Array.to_list l.parts) in
  let forms =
    List.concat_map (fun (z : Zone.t) -> List.concat_map of_leaf (State.leaves z.skeleton)) zones
    @ List.concat_map of_definition (Array.to_list m.definitions)
    @ List.concat_map of_model_leaf (Array.to_list m.leaves)
  in
  let atoms = List.concat_map (fun p -> Formula.atoms (Property.State p)) predicates in
  let is_in_form i f = Rat.sign (Linear.coefficient f i) <> 0 in
  let is_argument i (a : Atom.t) =
    List.exists (function Atom.Parameter k -> Int.equal k i | _ -> false) a.arguments
  in
  Array.init (ranges c) (fun i -> List.exists (is_in_form i) forms || List.exists (is_argument i) atoms)

let forget t (z : Zone.t) =
  let none = Linear.constant (Zone.dimension z) Rat.zero in
  { z with parameters = Array.mapi (fun i f -> if t.(i) then f else none) z.parameters }
