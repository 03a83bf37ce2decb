open Scc_exact
open Scc_calculus

type side = { finish : State.finish; drawn : (Behaviour.t * Rat.t) list }

let step (m : Model.t) =
  match m.splits with
  | Every step -> step
  | Any_time -> Scc_base.Bug.fail __POS__ "chances without split instants"

(* Each summand once, with all of its chance. *)
let rec add (summand, q) = function
  | [] -> [ (summand, q) ]
  | (other, r) :: rest when Behaviour.equal summand other -> (other, Rat.add q r) :: rest
  | other :: rest -> other :: add (summand, q) rest

(* What never happens is not offered. *)
let side m p name (finish : State.finish) =
  let offers = Process.releases m p name finish in
  let by_chance (r : Process.released) = Option.map (fun odds -> (r.how.summand, odds)) r.odds in
  let free = List.exists (fun (r : Process.released) -> Option.is_none r.odds) offers in
  let left_to_chance = List.filter_map by_chance offers in
  let shares = Odds.shares ~step:(step m) (List.map snd left_to_chance) in
  let drawn = List.fold_left2 (fun all (summand, _) q -> add (summand, q) all) [] left_to_chance shares in
  match List.filter (fun (_, q) -> Rat.sign q > 0) drawn with
  | [] when not free -> None
  | drawn -> Some { finish; drawn }

let sides (m : Model.t) p (b : State.bond) =
  if not m.lots then None
  else
    match (side m p b.name b.one, side m p b.name b.two) with
    | Some { drawn = []; _ }, Some { drawn = []; _ } | None, _ | _, None -> None
    | Some one, Some two -> Some (one, two)

let has_lot m p b = Option.is_some (sides m p b)

let wait m (p : State.process) =
  match p.lots with
  | Some { since; _ } when Array.exists (has_lot m p) p.bonds -> Some (Rat.sub (step m) since)
  | Some _ | None -> None

let start (m : Model.t) p =
  State.with_lots (if m.lots then Some { since = Rat.zero; pending = [] } else None) p

let pass m d (p : State.process) =
  match p.lots with
  | None -> p
  | Some { since; _ } ->
    let since = Rat.modulo (Rat.add since d) (step m) in
    let undecided b = if has_lot m p b then Some (b, State.Undecided) else None in
    let pending = if Rat.sign since = 0 then List.filter_map undecided (Array.to_list p.bonds) else [] in
    State.with_lots (Some { since; pending }) p

(* {1 After a release} *)

let would_follow m p (b : State.bond) drawn =
  let would (f : State.finish) =
    let fits (r : Process.released) =
      match List.assoc_opt f.at drawn with
      | Some summand -> Behaviour.equal summand r.how.summand
      | None -> Option.is_none r.odds
    in
    List.exists fits (Process.releases m p b.name f)
  in
  would b.one && would b.two

let piece m ~(whole : State.process) (piece : State.process) =
  let stays (b, (lot : State.lot)) =
    Array.exists (State.equal_bond b) piece.bonds
    &&
    match lot with
    | Undecided -> has_lot m piece b
    | Let_go drawn | Next drawn -> would_follow m piece b drawn
  in
  let left (lots : State.lots) = { lots with pending = List.filter stays lots.pending } in
  State.with_lots (Option.map left whole.lots) piece

(* {1 Whose turn it is} *)

let is_pending (p : State.process) =
  match p.lots with Some { pending = _ :: _; _ } -> true | Some { pending = []; _ } | None -> false

let pending (s : State.t) = Array.exists is_pending s.processes

let next m (s : State.t) = Process.first_by_velocity m (List.filter is_pending (Array.to_list s.processes))

(* By their places alone, so that names change nothing. *)
let compare_ends (m : Model.t) p (f : State.finish) (g : State.finish) =
  let k = State.leaf_of p f.at and l = State.leaf_of p g.at in
  let rec first = function [] -> 0 | c :: rest -> ( match c () with 0 -> first rest | c -> c) in
  first
    [
      (fun () -> Vec.compare k.position l.position);
      (fun () -> Quaternion.compare k.turned l.turned);
      (fun () -> String.compare m.leaves.(f.at).template m.leaves.(g.at).template);
      (fun () -> Site.compare f.site g.site);
    ]

let in_order m (p : State.process) =
  let ends (b : State.bond) = List.sort (compare_ends m p) [ b.one; b.two ] in
  let by_place (b, _) (c, _) = List.compare (compare_ends m p) (ends b) (ends c) in
  match p.lots with None -> [] | Some { pending; _ } -> List.stable_sort by_place pending
