open Scc_calculus

let continue continuations (l : State.leaf) =
  match List.assoc_opt l.leaf continuations with
  | Some b -> { l with behaviour = Behaviour.fresh b }
  | None -> l

type released = {
  rest : Behaviour.t;
  push : Scc_exact.Rat.t;
  odds : Odds.t option;
  how : Behaviours.derivation;
}

let releases (m : Model.t) p name (f : State.finish) =
  Behaviours.derivations m.definitions (State.leaf_of p f.at).behaviour
  |> List.filter_map (fun (offer, derivation) ->
      match offer with
      | Behaviours.Offer_weak (c, { push; odds }, rest)
        when String.equal c.name name && Behaviour.active c f.site ->
        Some { rest; push; odds; how = derivation }
      | Offer_weak _ | Offer_open _ | Offer_strong _ -> None)

let free_releases m p name f = List.filter (fun r -> Option.is_none r.odds) (releases m p name f)

let weak_offers m p (b : State.bond) =
  let first = free_releases m p b.name b.one in
  if first = [] then []
  else
    let second = free_releases m p b.name b.two in
    List.concat_map (fun one -> List.map (fun two -> (one, two)) second) first

let releasable m p b = weak_offers m p b <> []
let weak_split_enabled m p = Array.exists (releasable m p) p.State.bonds

let restart_clock m p =
  State.with_clock (if weak_split_enabled m p then Some Scc_exact.Rat.zero else None) p

let steers (m : Model.t) (p : State.process) =
  Array.exists (fun (l : State.leaf) -> not (Law.is_inertial m.leaves.(l.leaf).law)) p.leaves
  && Option.is_some (State.mass m p)

let draws (m : Model.t) (p : State.process) =
  steers m p && Array.exists (fun (l : State.leaf) -> Law.draws m.leaves.(l.leaf).law) p.leaves

let stops (m : Model.t) p = Model.stops_walkers m && draws m p
let yielding_mass m p = if stops m p then None else State.mass m p

let begin_step p = State.map_leaves (fun l -> { l with waited = Scc_exact.Rat.zero }) p

(* Where processes have steps of their own: a process in this phase, if a law moves it. *)
let in_phase (m : Model.t) phase p =
  if not (Model.of_each m) then p
  else if not (steers m p) then State.with_phase None (begin_step p)
  else
    match phase with
    | Some _ -> State.with_phase phase p
    | None -> State.with_phase (Some State.Due) (begin_step p)

let restart_step m p = in_phase m None p

let end_step m (p : State.process) =
  match p.phase with
  | Some (Moving | Due) -> in_phase m (Some State.Due) p
  | Some Steered | None -> in_phase m p.phase p

let joined_step m (p : State.process) (q : State.process) whole =
  match (p.phase, q.phase) with
  | None, None -> in_phase m None whole
  | (Some (Moving | Due), _) | (_, Some (Moving | Due)) -> in_phase m (Some State.Due) whole
  | (Some Steered, (Some Steered | None)) | (None, Some Steered) -> in_phase m (Some State.Steered) whole

let piece_step m ~(whole : State.process) piece = in_phase m whole.phase piece

let running_clock (m : Model.t) (p : State.process) =
  match (m.splits, p.clock) with
  | Every step, Some clock -> Some (step, clock)
  | Every _, None | Any_time, _ -> None

let splits_at_any_time (m : Model.t) (p : State.process) =
  match m.splits with Any_time -> Option.is_some p.clock | Every _ -> false

let at_split_instant (p : State.process) =
  match p.clock with
  | Some clock -> Scc_exact.Rat.sign clock = 0
  | None -> false

(* By their places alone: neither names nor shifts nor the order of declaration change anything. *)
let placed m (p : State.process) =
  match p.leaves with
  | [| l |] -> ([ l ], p)
  | many -> (List.sort (State.compare_places m) (Array.to_list many), p)

let compare_placed m (a, _) (b, _) =
  match (a, b) with
  | [ l ], [ k ] -> State.compare_places m l k
  | _ -> List.compare (State.compare_places m) a b

let by_place m processes = List.map snd (List.stable_sort (compare_placed m) (List.map (placed m) processes))

let first compare m processes =
  let earlier first p = if compare first p <= 0 then first else p in
  match List.map (placed m) processes with
  | [] -> None
  | p :: rest -> Some (snd (List.fold_left earlier p rest))

let first_by_place m processes = first (compare_placed m) m processes

let compare_moving m ((_, p) as one) ((_, q) as two) =
  match Scc_exact.Vec.compare p.State.velocity q.State.velocity with 0 -> compare_placed m one two | c -> c

let by_velocity m processes = List.map snd (List.stable_sort (compare_moving m) (List.map (placed m) processes))
let first_by_velocity m processes = first (compare_moving m) m processes
