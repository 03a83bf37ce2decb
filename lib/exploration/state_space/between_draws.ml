open Scc_property

let is_state f = Option.is_some (Formula.state_formula f)

let rec is_flat (f : Property.temporal) =
  match f with
  | State _ -> true
  | Temporal_not f -> is_flat f
  | Temporal_and fs | Temporal_or fs -> List.for_all is_flat fs
  | Next _ -> false
  | Finally (_, _, f) | Globally (_, _, f) -> is_state f
  | Until (_, _, f, g) -> is_state f && is_state g

let counts_events (c : Property.check) =
  match c.asked with
  | Expected (_, Events_until _, _) -> true
  | Expected (_, (Time_until _ | Value_at _), _) | Whether | How_likely _ -> false

let unseen (c : Property.check) =
  is_flat c.formula && (not (Formula.has_events c.formula)) && not (counts_events c)

let is_number (c : Property.check) = match c.asked with How_likely _ | Expected _ -> true | Whether -> false

(* Runs that recur are shown for claims, but not for numbers. What such a run comes back to may have another
   velocity there. *)
let velocities_unseen (c : Property.check) =
  is_number c && not (List.exists (Atom.depends_on Speed) (Formula.atoms c.formula))
