open Scc_base
open Scc_verify

(* A start at which velocities never cease to change may go on for ever, while all others come to an end. *)
let default_depth = 1_000

let depth (b : Bounds.t) : Verdict.truncation =
  match b.depth with
  | Given d -> { limit = Depth d; origin = By_user }
  | Default d -> { limit = Depth d; origin = By_default }
  | Unbounded -> { limit = Depth default_depth; origin = By_default }

let states (b : Bounds.t) : Verdict.truncation =
  match b.states with
  | Given n -> { limit = States n; origin = By_user }
  | Default n -> { limit = States n; origin = By_default }
  | Unbounded -> Bug.fail __POS__ "a bound that is off was met"
