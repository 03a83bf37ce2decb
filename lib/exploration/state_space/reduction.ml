open Scc_calculus
open Scc_property

type kind = Symmetry | Translation | Order | Jump | Slice | Drift | Time | Draws | Isometry

let all = [ Symmetry; Translation; Order; Jump; Slice; Drift; Time; Draws; Isometry ]

let name = function
  | Symmetry -> "symmetry"
  | Translation -> "translation"
  | Order -> "order"
  | Jump -> "jump"
  | Slice -> "slice"
  | Time -> "time"
  | Drift -> "drift"
  | Draws -> "draws"
  | Isometry -> "isometry"

let of_name text = List.find_opt (fun k -> String.equal (name k) text) all
let equal a b = String.equal (name a) (name b)
let used kinds kind = List.exists (equal kind) kinds

let joins kinds (m : Model.t) checks =
  let unseen = List.for_all Between_draws.unseen in
  used kinds Draws && Model.leaves_to_chance m && Option.is_none m.rigid && unseen checks

let forgets kinds model checks = joins kinds model checks && List.for_all Between_draws.velocities_unseen checks
let seen_on_courses kinds model checks = if forgets kinds model checks then Course_units.of_checks checks else None

(* Of a number only its predicates count, each by itself. *)
let symmetry model state ~checks ~searched ~evaluated =
  let is_number (c : Property.check) = Between_draws.is_number c && Between_draws.unseen c in
  let numbers = List.filter_map (fun c -> if is_number c then Some c.Property.formula else None) checks in
  let predicates f = List.map (fun p -> Property.State p) (Formula.predicates f) in
  let evaluated = List.filter (fun f -> not (List.memq f numbers)) evaluated in
  Symmetry.find model ~initial:state ~searched:(searched @ List.concat_map predicates numbers) ~evaluated

(* Shown runs need no names of places, and states between draws are seen by none of these checks. *)
let isometries kinds model state checks =
  if used kinds Isometry && joins kinds model checks && List.for_all Between_draws.is_number checks then
    let predicates = List.concat_map (fun (c : Property.check) -> Formula.predicates c.formula) checks in
    let number (c : Property.check) =
      match c.asked with
      | Expected (_, Value_at (n, _), _) -> Some n
      | Expected (_, (Time_until _ | Events_until _), _) | Whether | How_likely _ -> None
    in
    Isometry.find model ~initial:state ~predicates ~numbers:(List.filter_map number checks)
  else []

let quotient kinds model state ~checks ~searched ~evaluated : Quotient.t =
  let translation = used kinds Translation && Quotient.translatable model state (searched @ evaluated) in
  let drift = if used kinds Drift then Drift.make model state checks else None in
  {
    forgets = forgets kinds model checks;
    symmetry =
      (if used kinds Symmetry then symmetry model state ~checks ~searched ~evaluated else Symmetry.none);
    translation; drift;
    isometries = (if translation || Option.is_some drift then [] else isometries kinds model state checks);
  }

let sees_far kinds model state checks = used kinds Drift && Drift.sees_far model state checks

let visible kinds ~deep ~searched ~evaluated =
  match (searched, evaluated) with
  | _ :: _, []
    when used kinds Order && (not deep)
         && (not (List.exists Formula.global searched))
         && List.for_all Slice.favours_events searched ->
    let leaves = List.concat_map Formula.leaves searched in
    Some (fun leaf -> List.exists (Int.equal leaf) leaves)
  | _ -> None

(* A model that no law steers has no steps of single processes to jump over. *)
let without_jumps kinds (m : Model.t) =
  if used kinds Jump || m.steered then m else { m with steered = true; steps = Shared }

let time_seen kinds (m : Model.t) checks : Time_seen.t =
  if not m.keeps_time then Never
  else if not (used kinds Time) then Always
  else
    let of_law seen (l : Model.leaf) = Time_seen.join seen (Time_seen.law m l.law) in
    Array.fold_left of_law (Time_seen.checks m checks) m.leaves
