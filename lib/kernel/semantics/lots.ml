open Scc_base
open Scc_exact
open Scc_calculus

type 'c side = { finish : State.finish; drawn : (Behaviour.t * 'c) list }

let step (m : Model.t) =
  match m.splits with
  | Every step -> step
  | Any_time -> Bug.fail __POS__ "chances without split instants"

(* Each summand once, with all of its chance. *)
let add (n : _ Chances.t) (summand, q) =
  let joined (other, r) = if Behaviour.equal summand other then Some (other, n.add q r) else None in
  Scc_data.Lists.put joined (summand, q)

(* What never happens is not offered. *)
let side (n : _ Chances.t) m p name (finish : State.finish) =
  let offers = Process.releases m p name finish in
  let by_chance (r : Process.released) = Option.map (fun odds -> (r.how.summand, odds)) r.odds in
  let free = List.exists (fun (r : Process.released) -> Option.is_none r.odds) offers in
  let left_to_chance = List.filter_map by_chance offers in
  let shares = n.shares ~step:(step m) (List.map snd left_to_chance) in
  let drawn = List.fold_left2 (fun all (summand, _) q -> add n (summand, q) all) [] left_to_chance shares in
  match List.filter (fun (_, q) -> Rat.sign (n.value q) > 0) drawn with
  | [] when not free -> None
  | drawn -> Some { finish; drawn }

let sides n (m : Model.t) p (b : State.bond) =
  if not m.lots then None
  else
    match (side n m p b.name b.one, side n m p b.name b.two) with
    | Some { drawn = []; _ }, Some { drawn = []; _ } | None, _ | _, None -> None
    | Some one, Some two -> Some (one, two)

let has_lot m p b = Option.is_some (sides Chances.rationals m p b)

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

(* {1 How a bond is released} *)

(* Free summands of which the same comes are one way; of those by chance the equal ones are. *)
let alike (r : Process.released) (s : Process.released) =
  match (r.odds, s.odds) with
  | None, None -> Rat.equal r.push s.push && Behaviour.equal r.rest s.rest
  | Some _, Some _ -> Behaviour.equal r.how.summand s.how.summand
  | None, Some _ | Some _, None -> false

let ways offers =
  let rec from found = function
    | [] -> List.rev found
    | r :: rest ->
      let same, others = List.partition (alike r) rest in
      from ((r :: same) :: found) others
  in
  from [] offers

let followed m p (b : State.bond) drawn (f : State.finish) =
  let is_free (r : Process.released) = Option.is_none r.odds in
  let is summand (r : Process.released) = Behaviour.equal summand r.how.summand in
  let follows = match List.assoc_opt f.at drawn with Some summand -> is summand | None -> is_free in
  List.filter (List.exists follows) (ways (Process.releases m p b.name f))

let would_follow m p (b : State.bond) drawn =
  List.for_all (fun f -> followed m p b drawn f <> []) [ b.one; b.two ]

let piece m ~(whole : State.process) (piece : State.process) =
  let stays (b, (lot : State.lot)) =
    Array.exists (State.equal_bond b) piece.bonds
    &&
    match lot with
    | Let_go drawn -> would_follow m piece b drawn
    | Undecided | Next _ -> Bug.fail __POS__ "a bond is released before all lots are drawn"
  in
  let left (lots : State.lots) = { lots with pending = List.filter stays lots.pending } in
  State.with_lots (Option.map left whole.lots) piece

(* {1 What is due} *)

let is_pending (p : State.process) =
  match p.lots with Some { pending = _ :: _; _ } -> true | Some { pending = []; _ } | None -> false

let pending (s : State.t) = Array.exists is_pending s.processes

(* By their places alone, so that neither names nor the order of declaration change anything. *)
let compare_ends (m : Model.t) p (f : State.finish) (g : State.finish) =
  let k = State.leaf_of p f.at and l = State.leaf_of p g.at in
  let rec first = function [] -> 0 | c :: rest -> ( match c () with 0 -> first rest | c -> c) in
  first
    [
      (fun () -> State.compare_places m k l);
      (fun () -> Site.compare f.site g.site);
    ]

let in_order m (p : State.process) =
  let ends (b : State.bond) = List.sort (compare_ends m p) [ b.one; b.two ] in
  let by_place (b, _) (c, _) = List.compare (compare_ends m p) (ends b) (ends c) in
  match p.lots with None -> [] | Some { pending; _ } -> List.stable_sort by_place pending

(* Those that hang together by leaves: each such set in order, and the sets in the order of their first ones. *)
let clusters pending =
  let share (b : State.bond) (c : State.bond) =
    List.exists (fun leaf -> leaf = c.one.at || leaf = c.two.at) [ b.one.at; b.two.at ]
  in
  let rec apart_from found left =
    match List.partition (fun b -> List.exists (share b) found) left with
    | [], others -> others
    | more, left -> apart_from more left
  in
  let rec from found = function
    | [] -> List.rev found
    | (first, _) :: _ as all ->
      let others = apart_from [ first ] (List.map fst all) in
      let apart, together = List.partition (fun (b, _) -> List.exists (State.equal_bond b) others) all in
      from (together :: found) apart
  in
  from [] pending

type to_release = { bond : State.bond; drawn : State.drawn }

type due =
  | To_draw of State.process * State.bond
  | To_be_first of State.process * State.bond list
  | To_choose of State.process * to_release
  | To_release of (State.process * to_release list) list

let bonds = List.map fst
let is_undecided = function _, State.Undecided -> true | _, (State.Let_go _ | Next _) -> false
let is_first = function _, State.Next _ -> true | _, (State.Undecided | Let_go _) -> false
let some_undecided (p : State.process) =
  match p.lots with Some { pending; _ } -> List.exists is_undecided pending | None -> false

let undecided m p = bonds (List.filter is_undecided (in_order m p))

(* Those of which none has been drawn to be first. *)
let is_contested cluster = List.compare_length_with cluster 1 > 0 && not (List.exists is_first cluster)

let some_contested (p : State.process) =
  match p.lots with Some { pending; _ } -> List.exists is_contested (clusters pending) | None -> false

let contested m p = bonds (List.find is_contested (clusters (in_order m p)))

(* Of each cluster the only one, or the one that is first. *)
let released_now m p =
  let of_cluster cluster =
    match List.find_opt is_first cluster with Some first -> first | None -> List.hd cluster
  in
  let to_release = function
    | bond, (State.Let_go drawn | Next drawn) -> { bond; drawn }
    | _, Undecided -> Bug.fail __POS__ "a bond is released before all lots are drawn"
  in
  List.map (fun cluster -> to_release (of_cluster cluster)) (clusters (in_order m p))

let is_open m p { bond; drawn } =
  let several f = List.compare_length_with (followed m p bond drawn f) 1 > 0 in
  several bond.one || several bond.two

let several_ways m p = List.filter (is_open m p) (released_now m p)

let due m (s : State.t) =
  let waiting = List.filter is_pending (Array.to_list s.processes) in
  let first test = Process.first_by_velocity m (List.filter test waiting) in
  match (waiting, first some_undecided) with
  | [], _ -> None
  | _, Some p -> Some (To_draw (p, fst (List.find is_undecided (in_order m p))))
  | _, None -> (
      match first some_contested with
      | Some p -> Some (To_be_first (p, contested m p))
      | None -> (
          let some p = match several_ways m p with [] -> false | _ :: _ -> true in
          match (List.concat_map (several_ways m) waiting, first some) with
          | _ :: _ :: _, Some p -> Some (To_choose (p, List.hd (several_ways m p)))
          | _, _ -> Some (To_release (List.map (fun p -> (p, released_now m p)) waiting))))
