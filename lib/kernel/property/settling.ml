open Scc_exact
open Scc_calculus
open Property

type t = { after : Rat.t; truth : bool }

let negated = Option.map (fun s -> { s with truth = not s.truth })

(* The sign that all cases of a number have for good, and since when. *)
let sign (cases : By_cases.case list) =
  let of_case c =
    match By_cases.zeros c with
    | None -> None
    | Some (_, (_, last)) -> Some (Rat.max Rat.zero last, Rat.sign c.By_cases.rate.x)
  in
  let together found c =
    match (found, of_case c) with
    | Some (after, sign), Some (t, same) when Int.equal sign same -> Some (Rat.max after t, sign)
    | _, _ -> None
  in
  match cases with [] -> None | first :: rest -> List.fold_left together (of_case first) rest

let compares (c : Law.comparison) sign =
  match c with
  | Lt | Le -> sign < 0
  | Gt | Ge -> sign > 0
  | Eq -> false
  | Ne -> true

let of_time : quantity -> Vec.t option = function Time -> Some (Vec.of_ints 1 0 0) | _ -> None

(* One part that settles on [truth] is enough for the whole to do so; else all have to settle. *)
let joined ~enough parts =
  let settled truth = List.filter_map (function Some s when s.truth = truth -> Some s.after | _ -> None) parts in
  let least = List.fold_left Rat.min and greatest = List.fold_left Rat.max in
  match (settled enough, settled (not enough)) with
  | first :: rest, _ -> Some { after = least first rest; truth = enough }
  | [], first :: rest when List.compare_lengths (first :: rest) parts = 0 ->
    Some { after = greatest first rest; truth = not enough }
  | [], _ -> None

let rec prop m : prop -> t option = function
  | Compare (c, a, b) when By_cases.conditions (Sub (a, b)) = [] ->
    Option.bind (By_cases.cases m ~variable:of_time (Sub (a, b))) sign
    |> Option.map (fun (after, sign) -> { after; truth = compares c sign })
  | Compare _ | Bool _ | Fact _ -> None
  | Not p -> negated (prop m p)
  | And ps -> joined ~enough:false (List.map (prop m) ps)
  | Or ps -> joined ~enough:true (List.map (prop m) ps)

let certain (q : path_quantifier) truth =
  match q with
  | All | Exists -> Some truth
  | Chance { test; _ } -> Scc_chance.Answer.(holds (Exact (if truth then Rat.one else Rat.zero)) test)

let rec temporal m : temporal -> t option = function
  | State p -> prop m p
  | Temporal_not f -> negated (temporal m f)
  | Temporal_and fs -> joined ~enough:false (List.map (temporal m) fs)
  | Temporal_or fs -> joined ~enough:true (List.map (temporal m) fs)
  | Next _ -> None
  | Finally (q, b, g) | Until (q, b, _, g) -> until m q b g
  | Globally (q, b, f) -> negated (until m (Scc_ctl.Timed_formula.dual q) b (Temporal_not f))

(* Where g is so, f U g is; where it never is again, nor is f U g. *)
and until m q b g =
  match temporal m g with
  | Some { after; truth } when (not truth) || Rat.sign b.low = 0 ->
    Option.map (fun truth -> { after; truth }) (certain q truth)
  | Some _ | None -> None

(* {1 How far a formula looks} *)

(* [None] is at all times. *)
let latest = function
  | [] -> Some Rat.zero
  | first :: rest -> List.fold_left (Option.map2 Rat.max) first rest

(* Of a formula that is evaluated at times up to [until]. The next event of X may be however late. *)
let rec reach m ~until f =
  let until = Option.merge Rat.min until (Option.map (fun s -> s.after) (temporal m f)) in
  match f with
  | State _ -> until
  | Temporal_not f -> reach m ~until f
  | Temporal_and fs | Temporal_or fs -> latest (List.map (reach m ~until) fs)
  | Next _ -> None
  | Finally (_, b, g) -> reach_of_until m ~until b [] g
  | Globally (_, b, f) -> reach_of_until m ~until b [] (Temporal_not f)
  | Until (_, b, f, g) -> reach_of_until m ~until b [ f ] g

(* The bound ends f U g, and so does g once it is settled, and f once it is so for false. *)
and reach_of_until m ~until b left g =
  let after t = Option.map (Rat.add t) until in
  let by_bound = Option.bind b.high after in
  let by_goal =
    match temporal m g with
    | Some { after; truth = false } -> Some after
    | Some { after = t; truth = true } -> Option.map (Rat.max t) (after b.low)
    | None -> None
  in
  let by_left f =
    match temporal m f with
    | Some { after; truth = false } -> Option.map (Rat.max after) until
    | Some { truth = true; _ } | None -> None
  in
  match List.fold_left (Option.merge Rat.min) by_bound (by_goal :: List.map by_left left) with
  | None -> None
  | Some _ as until -> latest (List.map (reach m ~until) (g :: left))

let of_formula m ~from f = reach m ~until:(Some from) f
let always = { low = Rat.zero; high = None }

let of_check m ~from (c : check) =
  match c.asked with
  | Whether | How_likely _ | Expected (_, Time_until _, _) -> of_formula m ~from c.formula
  | Expected (_, Events_until (_, g), _) -> of_formula m ~from (Finally (All, always, g))
  | Expected (_, Value_at (_, time), _) -> Some (Rat.add from time)

let of_checks m ~from checks = latest (List.map (of_check m ~from) checks)

(* {1 Until when a goal may be met} *)

let rec last_goals m = function
  | State _ -> []
  | Temporal_not f | Next (_, f) -> last_goals m f
  | Temporal_and fs | Temporal_or fs -> List.concat_map (last_goals m) fs
  | Finally (_, _, g) -> last_goal m g @ last_goals m g
  | Globally (_, _, f) -> last_goal m (Temporal_not f) @ last_goals m f
  | Until (_, _, f, g) -> last_goal m g @ last_goals m f @ last_goals m g

and last_goal m g = match temporal m g with Some { after; truth = false } -> [ after ] | Some _ | None -> []
