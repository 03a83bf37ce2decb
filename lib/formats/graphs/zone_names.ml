open Scc_state_sets
module Invariant = Scc_certificate.Invariant

(* In the order of {!Zone.coordinates}: those of invariants, which have no time. *)
let coordinate m (z : Zone.t) i =
  let parameters = Array.length z.parameters in
  match z.time with
  | Some _ when i = parameters -> "model time"
  | Some _ when i > parameters -> Invariant.name m (i - 1)
  | Some _ | None -> Invariant.name m i

let variable m (z : Zone.t) i =
  if i < Array.length z.basis then coordinate m z z.basis.(i) else "time passed"
