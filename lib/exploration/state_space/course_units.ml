open Scc_property
open Property

type t = { prop : prop; leaves : int list }

let is_motion a = Atom.depends_on Motion a
let atoms_of p = Formula.atoms (State p)
let leaves_of p = Formula.leaves (State p)
let reads_motion p = List.exists is_motion (atoms_of p)

exception Seen

(* A number is known to be the same in the end where what it reads does not move. *)
let rec units_of_number units n =
  match n with
  | Const _ -> units
  | Quantity q -> if is_motion (Atom.quantity q) then raise Seen else units
  | Count ps -> List.fold_left units_of units ps
  | Neg a -> units_of_number units a
  | Add (a, b) | Sub (a, b) | Mul (a, b) | Div (a, b) -> units_of_number (units_of_number units a) b
  | If (p, a, b) -> units_of_number (units_of_number (units_of units p) a) b

(* Of numbers that read motion directly, the comparison is a unit. *)
and units_of units p =
  match (p, leaves_of p) with
  | _ when not (reads_motion p) -> units
  | (And ps | Or ps), _ :: _ :: _ -> List.fold_left units_of units ps
  | Not p, _ -> units_of units p
  | Compare (_, a, b), leaves -> (
      match units_of_number (units_of_number units a) b with
      | units -> units
      | exception Seen -> { prop = p; leaves } :: units)
  | (Bool _ | Fact _ | And _ | Or _), leaves -> { prop = p; leaves } :: units

let is_named (a : Atom.t) = match a.scope with Named -> true | Whole -> false
let is_timeless a = not (Atom.depends_on Absolute_time a)

(* A unit is looked at in the processes of its leaves alone, whatever time it is. *)
let is_local u = List.for_all (fun a -> is_named a && is_timeless a) (atoms_of u.prop)

let of_check units (c : check) =
  let predicates = List.fold_left units_of units (Formula.predicates c.formula) in
  match c.asked with
  | Expected (_, Value_at (n, _), _) -> units_of_number predicates n
  | Expected (_, (Time_until _ | Events_until _), _) | Whether | How_likely _ -> predicates

let of_checks checks =
  match List.fold_left of_check [] checks with
  | exception Seen -> None
  | units -> if List.for_all is_local units then Some (List.rev units) else None
