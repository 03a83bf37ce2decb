open Scc_exact
open Scc_calculus
open Scc_property

type t = { symmetry : Symmetry.t; translation : bool }

let none = { symmetry = Symmetry.none; translation = false }

let translatable (m : Model.t) (s : State.t) formulas =
  let stays (p : State.process) = Option.is_none (State.mass m p) in
  (not (Array.exists stays s.processes))
  && (not (Array.exists (fun (l : Model.leaf) -> Law.mentions_position l.law) m.leaves))
  && not (List.exists Formula.mentions_position formulas)

let present catalogue tuple =
  let n = Array.length (Catalogue.model catalogue).leaves in
  let rec from i acc =
    if i < 0 then acc else from (i - 1) (if tuple.(i) = Catalogue.nobody then acc else i :: acc)
  in
  from (n - 1) []

let process catalogue tuple slot = (Catalogue.body catalogue tuple.(slot)).process

let sorted q catalogue tuple =
  if Symmetry.is_none q.symmetry then tuple
  else
    let slots = present catalogue tuple in
    let processes = Array.of_list (List.map (process catalogue tuple) slots) in
    match Symmetry.canonical q.symmetry processes with
    | None -> tuple
    | Some renamed ->
      let copy = Array.copy tuple in
      List.iter (fun slot -> copy.(slot) <- Catalogue.nobody) slots;
      List.iter (fun p -> copy.(Catalogue.first_leaf p) <- Catalogue.process catalogue p) renamed;
      copy

(* The first leaf comes to the origin. *)
let centred q catalogue tuple =
  if not q.translation then tuple
  else
    match present catalogue tuple with
    | [] -> tuple
    | first :: _ as slots ->
      let place = (process catalogue tuple first).leaves.(0).position in
      if Vec.is_zero place then tuple
      else begin
        let copy = Array.copy tuple in
        let by = Vec.neg place in
        List.iter (fun slot -> copy.(slot) <- Catalogue.shifted catalogue by tuple.(slot)) slots;
        copy
      end

let representative q catalogue tuple = centred q catalogue (sorted q catalogue tuple)
