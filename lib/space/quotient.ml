open Scc_exact
open Scc_calculus
open Scc_property

type t = { symmetry : Symmetry.t; translation : bool; drift : Drift.t option }

let none = { symmetry = Symmetry.none; translation = false; drift = None }
let is_none q = Symmetry.is_none q.symmetry && (not q.translation) && Option.is_none q.drift

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

let processes catalogue tuple slots = Array.of_list (List.map (process catalogue tuple) slots)

(* Each group that meets nobody else any more is moved to where it would be alone. *)
let apart d catalogue tuple =
  let slots = present catalogue tuple in
  match Drift.place d (processes catalogue tuple slots) with
  | [] -> None
  | shifts ->
    let copy = Array.copy tuple and slots = Array.of_list slots in
    let shift (i, by) =
      if not (Vec.is_zero by) then copy.(slots.(i)) <- Catalogue.shifted catalogue by tuple.(slots.(i))
    in
    List.iter shift shifts;
    Some copy

(* To place groups and to rename leaves by their places is one in any order; places count after that. *)
let representative q catalogue tuple =
  match Option.bind q.drift (fun d -> apart d catalogue tuple) with
  | Some placed -> sorted q catalogue placed
  | None -> centred q catalogue (sorted q catalogue tuple)

let same_but_for_places q catalogue one two =
  match q.drift with
  | None -> false
  | Some d -> (
      match (apart d catalogue one, apart d catalogue two) with
      | Some a, Some b -> a = b
      | None, _ | _, None -> false)

let keeps q catalogue tuple quantity =
  match q.drift with
  | None -> true
  | Some d -> Drift.keeps d (processes catalogue tuple (present catalogue tuple)) quantity
