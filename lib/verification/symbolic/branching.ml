open Scc_exact
open Scc_polyhedra
open Scc_property
open Timed_sets
open Scc_state_sets

(* {1 Fixpoints} *)

(* Why sets may not come to rest: each time that a cycle is followed they may get more pieces. *)
let at_rest steps = Printf.sprintf "the sets of states do not come to rest within %d steps" steps

(* Where more is to be explored, a bit of patience is enough. *)
let patience m =
  let size = Array.length m.nodes in
  (10 * size) + if m.whole then 10_000 else 100

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
    if !rounds > patience m then not_known (at_rest (patience m));
    let n = m.nodes.(i) in
    if is_explored n && not n.it.zone.halted then begin
      let next = tidy (step at i n) in
      if not (Union.equal next at.(i)) then begin
        at.(i) <- next;
        List.iter (fun j -> waiting := Deepest.add j !waiting) m.before.(i)
      end
    end
  done;
  at

(* A fixpoint begins with nothing where its steps add to it. What is not expanded has no steps. *)
let start m ~explored ~other = Array.mapi (fun i n -> if is_explored n then explored i n else other i n) m.nodes

let nothing _ n = Union.empty (Zone.dimension n.it.zone)

(* E[f U g]. *)
let exists_until m ~may f g =
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
  let other i n = union g.at.(i) (inter f.at.(i) (unknown n ~may)) in
  let at = iterate m (start m ~explored:nothing ~other) step in
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
let exists_globally m ~may ~over g =
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
  let other i n = inter g.at.(i) (union over.at.(i) (unknown n ~may)) in
  let at = iterate m (start m ~explored:(fun i _ -> g.at.(i)) ~other) step in
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
let exists_next m ~may f =
  let step at _ n =
    let of_stretch u s =
      let halted = project (halts n s f.at) ~dimension:(Zone.dimension n.it.zone) in
      union u (union halted (ends n s at))
    in
    List.fold_left of_stretch (at_once n f.at) n.stretches
  in
  let at = iterate m (start m ~explored:nothing ~other:(fun _ n -> unknown n ~may)) step in
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
let right_before m ~may s =
  let not_s = complement m s in
  let at i n =
    if not (is_explored n) then unknown n ~may
    else
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

(* Before a goal within the bound no state is later than its end. *)
let up_to (b : Property.bound) f =
  match b.high with
  | None -> f
  | Some t -> Property.Temporal_and [ f; State (Compare (Le, Quantity Time, Const t)) ]

let in_bound b f = if unbounded b then f else Property.Temporal_and [ f; State (in_time b) ]

(* {2 What decides a formula}

   That some run exists: one that comes to a goal, by its next event or by any, or one that goes on for ever. *)

type search =
  | Comes of { before : sets; goal : sets }  (** to the goal, through states of [before] *)
  | Stays of { states : sets; over : sets }  (** for ever in such states; of those in [over] all runs do *)
  | Leads of sets  (** to them, by its next event *)

let solve m ~may = function
  | Comes { before; goal } -> exists_until m ~may before goal
  | Stays { states; over } -> exists_globally m ~may ~over states
  | Leads goal -> exists_next m ~may goal

(* {2 What is known where not all is explored}

   The states of which something is known to be so, and those of which it is not known not to be so. *)

type known = { surely : sets; perhaps : sets }

let pick k ~may = if may then k.perhaps else k.surely

let both m sets =
  let surely = sets ~may:false in
  { surely; perhaps = (if m.whole then surely else sets ~may:true) }

let negation m k = both m (fun ~may -> complement m (pick k ~may:(not may)))
let combined m f a b = both m (fun ~may -> map2 f (pick a ~may) (pick b ~may))

type quantified = { holds_if_any : bool; searches : (search * sets) list }

type t = { model : model; mutable known : ((Property.temporal * bool) * (known * quantified option)) list }

(* A run breaks f U g if g never comes, or f is over at an instant without g before; or else, where g has no first
   instant, if f does not hold right after the last one without g. *)
let breaks_until m ~over f g =
  let not_f = negation m f and not_g = negation m g in
  let over_before g = both m (fun ~may -> right_before m ~may (map2 inter (pick not_f ~may) (pick g ~may))) in
  let goals = [ combined m inter not_f not_g; combined m inter not_g (over_before g) ] in
  let comes goal ~may = Comes { before = pick not_g ~may; goal = pick goal ~may } in
  List.map comes goals @ [ (fun ~may -> Stays { states = pick not_g ~may; over = pick over ~may }) ]

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
    let solved = List.map (fun search -> both m (fun ~may -> solve m ~may (search ~may))) searches in
    let any = List.fold_left (combined m union) (List.hd solved) (List.tl solved) in
    let holds = if holds_if_any then any else negation m any in
    let shown search s = (search ~may:false, s.surely) in
    (holds, Some { holds_if_any; searches = List.map2 shown searches solved })
  in
  let truth = Property.State (Bool true) in
  let all () = inner truth in
  let comes before goal = [ (fun ~may -> Comes { before = pick before ~may; goal = pick goal ~may }) ] in
  let over b = inner (State (Property.Not (in_time { b with low = Rat.zero }))) in
  let stays b states = [ (fun ~may -> Stays { states = pick states ~may; over = pick (over b) ~may }) ] in
  let leads goal = [ (fun ~may -> Leads (pick goal ~may)) ] in
  match f with
  | State p -> (both m (fun ~may -> of_prop m ~may p), None)
  | Temporal_not f -> (negation m (eval t ~outermost f), None)
  | Temporal_and fs -> (List.fold_left (fun u f -> combined m inter u (eval t ~outermost f)) (all ()) fs, None)
  | Temporal_or fs ->
    let fails u f = combined m inter u (negation m (eval t ~outermost f)) in
    (negation m (List.fold_left fails (all ()) fs), None)
  | Next (Chance _, _) | Finally (Chance _, _, _) | Globally (Chance _, _, _) | Until (Chance _, _, _, _) ->
    not_known "a probability, over all starts and instants"
  | Next (Exists, f) -> quantified true (leads (inner f))
  | Next (All, f) -> quantified false (leads (negation m (inner f)))
  | Finally (Exists, b, f) -> quantified true (comes (inner (up_to b truth)) (within b f))
  | Finally (All, b, f) -> quantified false (stays b (negation m (within b f)))
  | Globally (All, b, f) -> quantified false (comes (inner (up_to b truth)) (within b (Temporal_not f)))
  | Globally (Exists, b, f) -> quantified true (stays b (negation m (within b (Temporal_not f))))
  | Until (Exists, b, f, g) -> quantified true (comes (inner (up_to b f)) (within b g))
  | Until (All, b, f, g) -> quantified false (breaks_until m ~over:(over b) (inner f) (within b g))

let model t = t.model

let truth t ~outermost f ~holds =
  let known = eval t ~outermost f in
  if holds then known.surely else complement t.model known.perhaps

let quantified t ~outermost f = snd (find t ~outermost f)

type answer = { decided : t; holds : Union.t; fails : Union.t }

let answer context atoms graph formula =
  let t = { model = of_graph context atoms graph; known = [] } in
  match eval t ~outermost:true formula with
  | exception Not_known reason -> Error reason
  | _ ->
    let sets holds = truth t ~outermost:true formula ~holds in
    let of_root sets (n : Zone_graph.node) =
      let values p = Polyhedron.image p n.zone.parameters in
      List.map values (Union.pieces sets.at.(n.number))
    in
    let roots = Zone_graph.roots graph in
    let parameters = match roots with n :: _ -> Array.length n.zone.parameters | [] -> 0 in
    let values sets = tidy (Union.of_polyhedra parameters (List.concat_map (of_root sets) roots)) in
    Ok { decided = t; holds = values (sets true); fails = values (sets false) }
