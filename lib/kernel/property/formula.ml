open Scc_calculus
open Property

let equal_event a b = Order.event a b = 0
let equal_num a b = Order.num a b = 0
let equal_prop a b = Order.prop a b = 0
let equal a b = Order.temporal a b = 0

let complement : Law.comparison -> Law.comparison = function
  | Lt -> Ge
  | Le -> Gt
  | Gt -> Le
  | Ge -> Lt
  | Eq -> Ne
  | Ne -> Eq

let rec negate = function
  | Bool b -> Bool (not b)
  | Compare (c, a, b) -> Compare (complement c, a, b)
  | Not p -> p
  | And ps -> Or (List.map negate ps)
  | Or ps -> And (List.map negate ps)
  | Fact _ as p -> Not p

let dual = Scc_ctl.Timed_formula.dual

let rec negation_normal_form = function
  | Temporal_not f -> refuse f
  | f -> Parts.map_temporal negation_normal_form f

(* The normal form of the negation. *)
and refuse = function
  | State p -> State (negate p)
  | Temporal_not f -> negation_normal_form f
  | Temporal_and fs -> Temporal_or (List.map refuse fs)
  | Temporal_or fs -> Temporal_and (List.map refuse fs)
  | Next (q, f) -> Next (dual q, refuse f)
  | Finally (q, b, f) -> Globally (dual q, b, refuse f)
  | Globally (q, b, f) -> Finally (dual q, b, refuse f)
  | Until _ as f -> Temporal_not (negation_normal_form f)

let rec quantifies kind f =
  let is q =
    match (q, kind) with
    | All, All | Exists, Exists | Chance _, _ -> true
    | All, _ | Exists, _ -> false
  in
  match f with
  | State _ -> false
  | Temporal_not f -> quantifies (dual kind) f
  | Temporal_and fs | Temporal_or fs -> List.exists (quantifies kind) fs
  | Next (q, f) | Finally (q, _, f) | Globally (q, _, f) -> is q || quantifies kind f
  | Until (q, _, f, g) -> is q || quantifies kind f || quantifies kind g

(* {1 What formulas look at} *)

(* Whether some atom passes a test: all are visited as long as none does. *)
let rec exists_num test = function
  | Quantity q -> test (Atom.quantity q)
  | n -> exists_parts test (Parts.of_num n)

and exists_prop test = function
  | Fact f -> test (Atom.fact f)
  | p -> exists_parts test (Parts.of_prop p)

and exists_parts test { Parts.numbers; predicates } =
  List.exists (exists_prop test) predicates || List.exists (exists_num test) numbers

let rec exists test = function
  | State p -> exists_prop test p
  | f -> List.exists (exists test) (Parts.of_temporal f)

let atoms f =
  let found = ref [] in
  let note a = found := a :: !found; false in
  ignore (exists note f);
  List.rev !found

let rec by_one_run ~holds = function
  | State _ -> false
  | Temporal_not f -> by_one_run ~holds:(not holds) f
  | Temporal_and fs -> (not holds) && List.exists (by_one_run ~holds) fs
  | Temporal_or fs -> holds && List.exists (by_one_run ~holds) fs
  | Next (q, _) | Finally (q, _, _) | Globally (q, _, _) | Until (q, _, _, _) -> (
      match q with Exists -> holds | All -> not holds | Chance _ -> false)

let always = { low = Scc_exact.Rat.zero; high = None }

let rec asks_probability = function
  | Next (Chance _, _) | Finally (Chance _, _, _) | Globally (Chance _, _, _) | Until (Chance _, _, _, _) -> true
  | f -> List.exists asks_probability (Parts.of_temporal f)

let mentions_time f = exists (Atom.depends_on Absolute_time) f
let mentions_position f = exists (Atom.depends_on Absolute_place) f
let has_events f = exists (fun a -> Option.is_some a.event) f
let steady ~rigid p = not (exists_prop (fun a -> not (Atom.steady ~rigid a)) p)

let global f =
  let is_whole (a : Atom.t) =
    match a.scope with
    | Whole -> true
    | Named -> false
  in
  exists is_whole f

module Leaves = Set.Make (Int)

let leaves f =
  let add found a = List.fold_left (fun found i -> Leaves.add i found) found (Atom.leaves a) in
  Leaves.elements (List.fold_left add Leaves.empty (atoms f))

let rec predicates = function
  | State p -> [ p ]
  | f -> List.concat_map predicates (Parts.of_temporal f)

let rec state_formula = function
  | State p -> Some p
  | Temporal_not f -> Option.map negate (state_formula f)
  | Temporal_and fs -> Option.map (fun ps -> And ps) (Option.all state_formula fs)
  | Temporal_or fs -> Option.map (fun ps -> Or ps) (Option.all state_formula fs)
  | Next _ | Finally _ | Globally _ | Until _ -> None

let events f =
  Scc_data.Lists.distinct equal_event (List.filter_map (fun (a : Atom.t) -> a.event) (atoms f))

let leaves_of_events f = List.concat_map (fun e -> Atom.leaves (Atom.fact (Event e))) (events f)
