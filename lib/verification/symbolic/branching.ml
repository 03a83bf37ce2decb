open Scc_exact
open Scc_polyhedra
open Scc_property
open State_sets
open Scc_state_sets

(* {1 Fixpoints} *)

(* Why sets may not come to rest: each time that a cycle is followed they may get more pieces. *)
let most_rounds = 10_000

let at_rest = "the sets of states do not come to rest within " ^ string_of_int most_rounds ^ " steps"

(* Computes [step] of each node anew as long as sets after it change; the last nodes, which lie deepest, first. *)
let iterate m start step =
  let at = Array.copy start in
  let size = Array.length at in
  let queued = Array.make size true in
  let module Deepest = Set.Make (Int) in
  let waiting = ref (Deepest.of_list (List.init size Fun.id)) and rounds = ref 0 in
  while not (Deepest.is_empty !waiting) do
    let i = Deepest.max_elt !waiting in
    waiting := Deepest.remove i !waiting;
    queued.(i) <- false;
    incr rounds;
    if !rounds > most_rounds + (10 * size) then not_known at_rest;
    let n = m.nodes.(i) in
    if not n.it.zone.halted then begin
      let next = tidy (step at i n) in
      if not (Union.equal next at.(i)) then begin
        at.(i) <- next;
        List.iter (fun j -> waiting := Deepest.add j !waiting) m.before.(i)
      end
    end
  done;
  at

let none m = Array.map (fun n -> Union.empty (Zone.dimension n.it.zone)) m.nodes

(* E[f U g]. *)
let exists_until m f g =
  let not_f = complement m f in
  let zipped i =
    let truths = List.combine f.along.(i) (List.combine not_f.along.(i) g.along.(i)) in
    List.combine m.nodes.(i).stretches truths
  in
  let target at n s f_along g_along = union g_along (inter f_along (halts n s at)) in
  let step at i n =
    let of_stretch u (s, (f_along, (bad, g_along))) =
      let found = reach_from_start s ~bad (target at n s f_along g_along) in
      union u (union found (inter (ends n s at) (clear_from_start s ~bad)))
    in
    union g.at.(i) (inter f.at.(i) (List.fold_left of_stretch (at_once n at) (zipped i)))
  in
  let at = iterate m (none m) step in
  let along i =
    let n = m.nodes.(i) in
    let of_stretch (s, (f_along, (bad, g_along))) =
      let found = reach s ~bad (target at n s f_along g_along) in
      let to_end = inter (clear_to_end s bad) (extend_over s (ends n s at)) in
      union g_along (inter f_along (union found to_end))
    in
    List.map of_stretch (zipped i)
  in
  { at; along = Array.init (Array.length at) along }

let is_beyond n = Option.is_some n.it.beyond

(* EG g. After the horizon a run goes on with g if g is there: the formula does not look further. *)
let exists_globally m g =
  let not_g = complement m g in
  let zipped i = List.combine m.nodes.(i).stretches (List.combine g.along.(i) not_g.along.(i)) in
  let goes_on at n s =
    let for_ever = if s.for_ever then some s.region else Union.empty (Zone.dimension n.it.zone) in
    union for_ever (union (late n s) (ends n s at))
  in
  let step at i n =
    let of_stretch u (s, (g_along, bad)) =
      let to_end = inter (goes_on at n s) (clear_from_start s ~bad) in
      let halted = reach_from_start s ~bad (inter g_along (halts n s at)) in
      union u (union to_end halted)
    in
    if is_beyond n then g.at.(i) else inter g.at.(i) (List.fold_left of_stretch (at_once n at) (zipped i))
  in
  let at = iterate m g.at step in
  let along i =
    let n = m.nodes.(i) in
    let of_stretch (s, (g_along, bad)) =
      let to_end = inter (clear_to_end s bad) (extend_over s (goes_on at n s)) in
      let halted = reach s ~bad (inter g_along (halts n s at)) in
      inter g_along (union to_end halted)
    in
    if is_beyond n then g.along.(i) else List.map of_stretch (zipped i)
  in
  { at; along = Array.init (Array.length at) along }

(* EX f: the first event leads to f, however much time passes before, to the end of a stretch or of several. *)
let exists_next m f =
  let step at _ n =
    let of_stretch u s =
      let halted = project (halts n s f.at) ~dimension:(Zone.dimension n.it.zone) in
      union u (union halted (ends n s at))
    in
    List.fold_left of_stretch (at_once n f.at) n.stretches
  in
  let at = iterate m (none m) step in
  let along n =
    let of_stretch s =
      let bad = Union.empty (Zone.dimension s.zone) in
      union (reach s ~bad (halts n s f.at)) (extend_over s (ends n s at))
    in
    List.map of_stretch n.stretches
  in
  { at; along = Array.map along m.nodes }

(* {1 Formulas} *)

(* The states right after which the set is there: on an open interval that begins with them. *)
let right_before m s =
  let not_s = complement m s in
  let at i n =
    let of_stretch u (x, bad) = union u (reach_from_start x ~bad (all_along x)) in
    List.fold_left of_stretch
      (Union.empty (Zone.dimension n.it.zone))
      (List.combine n.stretches not_s.along.(i))
  in
  let along i n =
    let of_stretch x bad =
      let n = Zone.dimension x.zone - 1 in
      project (restrict (clear_until x bad) [ before_ ~dimension:(n + 2) n (n + 1) ]) ~dimension:(n + 1)
    in
    List.map2 of_stretch n.stretches not_s.along.(i)
  in
  { at = Array.mapi at m.nodes; along = Array.mapi along m.nodes }

(* Since the start, where bounds of the outermost operator count from. *)
let in_time (b : Property.bound) =
  let time = Property.Quantity Time in
  let low = if Rat.sign b.low = 0 then [] else [ Property.Compare (Ge, time, Const b.low) ] in
  let high = List.map (fun t -> Property.Compare (Le, time, Const t)) (Option.to_list b.high) in
  Property.And (low @ high)

let unbounded (b : Property.bound) = Rat.sign b.low = 0 && b.high = None

let in_bound b f = if unbounded b then f else Property.Temporal_and [ f; State (in_time b) ]

(* {2 What decides a formula}

   That some run exists: one that comes to a goal, by its next event or by any, or one that goes on for ever. *)

type search =
  | Comes of { before : sets; goal : sets }  (** to the goal, through states of [before] *)
  | Stays of sets  (** for ever in such states *)
  | Leads of sets  (** to them, by its next event *)

let solve m = function
  | Comes { before; goal } -> exists_until m before goal
  | Stays states -> exists_globally m states
  | Leads goal -> exists_next m goal

type quantified = { holds_if_any : bool; searches : (search * sets) list }

type t = { model : model; mutable known : ((Property.temporal * bool) * (sets * quantified option)) list }

(* A run breaks f U g if g never comes, or f is over at an instant without g before; or else, where g has no first
   instant, if f does not hold right after the last one without g. *)
let breaks_until m f g =
  let not_f = complement m f and not_g = complement m g in
  [
    Comes { before = not_g; goal = map2 inter not_f not_g };
    Comes { before = not_g; goal = map2 inter not_g (right_before m (map2 inter not_f g)) };
    Stays not_g;
  ]

let rec find (t : t) ~outermost (f : Property.temporal) =
  let same ((g, o), _) = Bool.equal o outermost && Formula.equal f g in
  match List.find_opt same t.known with
  | Some (_, found) -> found
  | None ->
    let found = compute t ~outermost f in
    t.known <- ((f, outermost), found) :: t.known;
    found

and eval t ~outermost f = fst (find t ~outermost f)

and compute t ~outermost (f : Property.temporal) =
  let m = t.model in
  let inner f = eval t ~outermost:false f in
  let within b g =
    if unbounded b || outermost then inner (in_bound b g)
    else not_known "a bound of time within another operator, over all starts and instants"
  in
  let quantified holds_if_any searches =
    let solved = List.map (fun s -> (s, solve m s)) searches in
    let any = List.fold_left (fun u (_, s) -> map2 union u s) (snd (List.hd solved)) (List.tl solved) in
    let holds = if holds_if_any then any else complement m any in
    (holds, Some { holds_if_any; searches = solved })
  in
  match f with
  | State p -> (of_prop m p, None)
  | Temporal_not f -> (complement m (eval t ~outermost f), None)
  | Temporal_and fs -> (List.fold_left (fun u f -> map2 inter u (eval t ~outermost f)) (everything m) fs, None)
  | Temporal_or fs ->
    let fails u f = map2 inter u (complement m (eval t ~outermost f)) in
    (complement m (List.fold_left fails (everything m) fs), None)
  | Next (Chance _, _) | Finally (Chance _, _, _) | Globally (Chance _, _, _) | Until (Chance _, _, _, _) ->
    not_known "a probability, over all starts and instants"
  | Next (Exists, f) -> quantified true [ Leads (inner f) ]
  | Next (All, f) -> quantified false [ Leads (complement m (inner f)) ]
  | Finally (Exists, b, f) -> quantified true [ Comes { before = everything m; goal = within b f } ]
  | Finally (All, b, f) -> quantified false [ Stays (complement m (within b f)) ]
  | Globally (All, b, f) ->
    quantified false [ Comes { before = everything m; goal = within b (Temporal_not f) } ]
  | Globally (Exists, b, f) -> quantified true [ Stays (complement m (within b (Temporal_not f))) ]
  | Until (Exists, b, f, g) -> quantified true [ Comes { before = inner f; goal = within b g } ]
  | Until (All, b, f, g) -> quantified false (breaks_until m (inner f) (within b g))

let model t = t.model
let truth t ~outermost f ~holds = if holds then eval t ~outermost f else complement t.model (eval t ~outermost f)
let quantified t ~outermost f = snd (find t ~outermost f)

let holds context atoms graph formula =
  let t = { model = of_graph context atoms graph; known = [] } in
  match eval t ~outermost:true formula with
  | exception Not_known reason -> Error reason
  | sets ->
    let of_root (n : Zone_graph.node) =
      let values p = Polyhedron.image p n.zone.parameters in
      List.map values (Union.pieces sets.at.(n.number))
    in
    let roots = Zone_graph.roots graph in
    let parameters = match roots with n :: _ -> Array.length n.zone.parameters | [] -> 0 in
    Ok (t, tidy (Union.of_polyhedra parameters (List.concat_map of_root roots)))
