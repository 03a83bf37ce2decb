open Scc_calculus

let continue continuations (l : State.leaf) =
  match List.assoc_opt l.leaf continuations with
  | Some b -> { l with behaviour = Behaviour.fresh b }
  | None -> l

type released = Behaviour.t * Behaviours.derivation

(* What an end of a bond may do to release it: its summands omega(a, Phi) that match. *)
let releases (m : Model.t) p name (f : State.finish) =
  Behaviours.derivations m.definitions (State.leaf_of p f.at).behaviour
  |> List.filter_map (fun (offer, derivation) ->
      match offer with
      | Behaviours.Offer_weak (c, b) when String.equal c.name name && Behaviour.active c f.site ->
        Some (b, derivation)
      | Offer_weak _ | Offer_open _ | Offer_strong _ -> None)

let weak_offers m p (b : State.bond) =
  let first = releases m p b.name b.one in
  if first = [] then []
  else
    let second = releases m p b.name b.two in
    List.concat_map (fun one -> List.map (fun two -> (one, two)) second) first

let releasable m p b = weak_offers m p b <> []
let weak_split_enabled m p = Array.exists (releasable m p) p.State.bonds

let restart_clock m p =
  State.with_clock (if weak_split_enabled m p then Some Scc_exact.Rat.zero else None) p

let at_split_instant (p : State.process) =
  match p.clock with
  | Some clock -> Scc_exact.Rat.sign clock = 0
  | None -> false
