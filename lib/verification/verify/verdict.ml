open Scc_base
open Scc_exact
open Scc_calculus
open Scc_explain

type limit =
  | Depth of int
  | Time of Rat.t
  | Instant of int
  | States of int
  | Draws of { states : int; bodies : int }
  | Bits of int
  | Seconds of float
  | Memory of int
  | Interrupted
  | Omission of float

type origin = By_default | By_user | By_share | By_property | By_system
type truncation = { limit : limit; origin : origin }

type reason =
  | Truncated of truncation
  | Unevaluated of truncation
  | Unexplored of { count : int; nearest : Witness.t }
  | Undefined of string
  | Fault of string

type inexact = Cut of truncation | Too_long | Too_much

type point = {
  moment : Scc_ctl.Timeline.moment;
  answer : (Scc_property.Property.side * Scc_ctl.Eval.measured) list;
}

type dependence = {
  parameter : Ranges.range;
  values : Depending.values;
  holds : Scc_chance.Dependence.set option;
}

type t =
  | Holds of { bounds : truncation list; witness : Witness.t option }
  | Violated of { witness : Witness.t option }
  | Measured of { values : (Scc_property.Property.side * Scc_ctl.Eval.measured) list; reasons : reason list;
                  inexact : inexact option; witness : Witness.t option; curve : point list;
                  starts : (Scc_property.Property.side * Scc_regions.Chances.t) list }
  | Depends of dependence
  | Undecided of reason list

type over = { instants : bool; ranges : Ranges.t; example : (string * Rat.t) list; everywhere : bool;
              by_invariant : bool }
type scale = { resolution : Rat.t option; split_step : Rat.t option; over : over option }
type rest = By of Witness.halt | Among of Witness.halt
type convergence = Named of Slowing.t | Proved of Quickening.t

type outcome = {
  check : Scc_property.Property.check;
  verdict : t;
  scale : scale;
  rests : rest list;
  converges : convergence option;
  lost : string list;
  left_out : truncation option;
}

let by_invariant o = match o.scale.over with Some over -> over.by_invariant | None -> false
let over_zones o = Option.is_some o.scale.over
let everywhere d =
  let low = d.parameter.low.value and high = d.parameter.high.value in
  let fails set = Scc_chance.Dependence.(intervals ~low ~high (complement set)) in
  Option.map (fun set -> fails set = []) d.holds

let is_open = function
  | Undecided _ | Holds { bounds = _ :: _; _ } -> true
  | Holds _ | Violated _ | Measured _ | Depends _ -> false

let exhaustive = function
  | Holds { bounds = []; _ } -> true
  | Depends d -> Option.equal Bool.equal (everywhere d) (Some true)
  | Holds _ | Violated _ | Measured _ | Undecided _ -> false

let rank = function
  | Depth _ -> 0
  | Time _ -> 1
  | Instant _ -> 2
  | States _ | Draws _ -> 3
  | Seconds _ -> 4
  | Memory _ -> 5
  | Interrupted -> 6
  | Omission _ -> 7
  | Bits _ -> 8

let same_limit a b = Int.equal (rank a.limit) (rank b.limit)

let union a b = a @ List.filter (fun x -> not (List.exists (same_limit x) a)) b

let distinct list =
  List.rev
    (List.fold_left
       (fun kept t -> if List.exists (same_limit t) kept then kept else t :: kept)
       [] list)

let together a b =
  let chance = List.fold_left (fun sum t -> match t.limit with Omission p -> sum +. p | _ -> sum) 0. in
  let both = Omission (Float.min 1. (chance a +. chance b)) in
  let sum t = match t.limit with Omission _ -> { t with limit = both } | _ -> t in
  List.map sum (distinct (a @ b))

(* As good as the worst of them. *)
let both a b =
  match (a, b) with
  | (Measured _ | Depends _), _ | _, (Measured _ | Depends _) ->
    Scc_base.Bug.fail __POS__ "a number among truth values"
  | (Violated _ as v), _ | _, (Violated _ as v) -> v
  | Undecided r, Undecided s -> Undecided (r @ s)
  | (Undecided _ as u), _ | _, (Undecided _ as u) -> u
  | Holds x, Holds y ->
    let witness = match x.witness with Some _ -> x.witness | None -> y.witness in
    Holds { bounds = union x.bounds y.bounds; witness }

(* As good as the best of them. *)
let either a b =
  match (a, b) with
  | (Measured _ | Depends _), _ | _, (Measured _ | Depends _) ->
    Scc_base.Bug.fail __POS__ "a number among truth values"
  | (Holds { bounds = []; _ } as v), _ | _, (Holds { bounds = []; _ } as v) -> v
  | (Holds _ as v), _ | _, (Holds _ as v) -> v
  | Undecided r, Undecided s -> Undecided (r @ s)
  | (Undecided _ as u), _ | _, (Undecided _ as u) -> u
  | Violated x, Violated y ->
    Violated { witness = (match x.witness with Some _ -> x.witness | None -> y.witness) }

let conjunction = List.fold_left both (Holds { bounds = []; witness = None })

let disjunction = function
  | [] -> Violated { witness = None }
  | v :: rest -> List.fold_left either v rest

let truncated = function
  | Holds { bounds; _ } -> bounds
  | Violated _ | Depends _ -> []
  | Measured { reasons; _ } | Undecided reasons ->
    List.filter_map
      (function Truncated t | Unevaluated t -> Some t | Unexplored _ | Undefined _ | Fault _ -> None)
      reasons

let had_share v =
  let is_share = function By_share -> true | By_default | By_user | By_property | By_system -> false in
  List.exists (fun t -> is_share t.origin) (truncated v)

let resources v =
  List.exists
    (fun t ->
       match t.limit with
       | Seconds _ | Memory _ | Interrupted -> true
       | Depth _ | Time _ | Instant _ | States _ | Draws _ | Bits _ | Omission _ -> false)
    (truncated v)

let by_default = function
  | Holds { bounds; _ } ->
    let is_default = function By_default -> true | By_user | By_share | By_property | By_system -> false in
    List.exists (fun t -> is_default t.origin) bounds
  | Violated _ | Measured _ | Depends _ | Undecided _ -> false

(* Rounded up to one digit. *)
let at_most p =
  let rec digit p e =
    if p > 9. then Printf.sprintf "1e-%02d" (e - 1)
    else if p >= 1. then Printf.sprintf "%.0fe-%02d" (Float.ceil p) e
    else digit (10. *. p) (e + 1)
  in
  if p <= 0. then "0" else if p >= 1. then "1" else digit p 0

let plural n = if n = 1 then "" else "s"

let limit_to_string = function
  | Depth n -> Printf.sprintf "the depth bound %d" n
  | Time t -> Printf.sprintf "the time bound %s" (Rat.to_string t)
  | Instant n -> Printf.sprintf "the bound of %d transition%s within one instant" n (plural n)
  | States n | Draws { states = n; bodies = _ } -> Printf.sprintf "the bound of %d state%s" n (plural n)
  | Bits n -> Printf.sprintf "the bound of %d bit%s for a number" n (plural n)
  | Seconds s -> Printf.sprintf "the limit of %g second%s" s (if s = 1. then "" else "s")
  | Memory w -> Printf.sprintf "the memory limit of %d MiB" (Memory.bytes_of_words w / Memory.mib)
  | Interrupted -> "the interruption"
  | Omission p ->
    Printf.sprintf "hash compaction, by which some state was left out with a probability of at most %s"
      (at_most p)

let truncation_to_string t =
  let whose =
    match t.origin with
    | By_default -> " (a default)"
    | By_user -> ""
    | By_share -> ", of which it had its share"
    | By_property -> " (of the properties)"
    | By_system -> " that the system sets this process (ulimit -v or -d)"
  in
  let why =
    match t.limit with
    | Draws { bodies; _ } -> Printf.sprintf ", which the draws of %d bodies at one instant exceed" bodies
    | Depth _ | Time _ | Instant _ | States _ | Bits _ | Seconds _ | Memory _ | Interrupted | Omission _ -> ""
  in
  limit_to_string t.limit ^ whose ^ why

let reason_to_string = function
  | Truncated t -> "the exploration ended at " ^ truncation_to_string t
  | Unevaluated t -> "its evaluation on what was explored ended at " ^ truncation_to_string t
  | Unexplored { count = 1; _ } -> "one unexplored state matters"
  | Unexplored { count; _ } -> Printf.sprintf "%d unexplored states matter" count
  | Undefined reason -> reason
  | Fault fault -> fault

let rest_to_string = function
  | By Dead_end -> " by a run that ends in a dead end"
  | By One_instant -> " by a run that goes round within one instant"
  | Among Dead_end -> ", of runs some of which end in a dead end"
  | Among One_instant -> ", of runs some of which go round within one instant"

let scale_to_string s =
  let at what = Option.fold ~none:"" ~some:(fun r -> Printf.sprintf ", at %s %s" what (Rat.to_string r)) in
  at "resolution" s.resolution ^ at "split step" s.split_step

let over_to_string { instants; ranges; _ } =
  (if instants then ", all instants" else "")
  ^ if Array.length ranges = 0 then "" else ", all " ^ Ranges.to_string ranges

let values_to_string values =
  String.concat ", " (List.map (fun (name, v) -> Printf.sprintf "%s = %s" name (Rat.to_string v)) values)

(* A number that depends on the start is told by its extremes and its mean. *)
let number values = function
  | [] -> Likelihoods.values values
  | (_, first) :: rest when List.for_all (fun (_, c) -> Scc_regions.Chances.equal first c) rest ->
    Scc_regions.Words.chances first
  | starts ->
    let told (s, c) = Likelihoods.side s ^ " " ^ Scc_regions.Words.chances c in
    String.concat "; " (List.map told starts)

let reasons_to_string reasons =
  let add texts reason =
    let text = reason_to_string reason in
    if List.mem text texts then texts else text :: texts
  in
  String.concat "; " (List.rev (List.fold_left add [] reasons))

let inexact_to_string = function
  | Cut t ->
    "no fraction was found within its part of " ^ truncation_to_string t ^ ": more --seconds may give it"
  | Too_long -> "its fraction has longer numbers than are worked with"
  | Too_much -> "its fraction takes more work than was allowed: --seconds allows more"

let inexact = function
  | Measured { inexact; _ } -> Option.map inexact_to_string inexact
  | Undecided _ | Holds _ | Violated _ | Depends _ -> None

let to_string = function
  | Holds { bounds = []; _ } -> "holds (exhaustive)"
  | Holds { bounds; _ } ->
    "holds up to the bound: " ^ String.concat ", " (List.map truncation_to_string bounds)
  | Violated _ -> "violated"
  | Measured ({ reasons = []; _ } as m) ->
    number m.values m.starts ^ Option.fold ~none:"" ~some:(fun why -> "; " ^ inexact_to_string why) m.inexact
  | Measured ({ reasons; _ } as m) ->
    Printf.sprintf "%s, as far as is known: %s" (number m.values m.starts)
      (reasons_to_string reasons)
  | Depends d -> Depending.to_string d.parameter ~values:d.values ~holds:d.holds
  | Undecided reasons -> "undecided: " ^ reasons_to_string reasons

(* Of what is violated for some values alone, for which. *)
let values_of o =
  let values =
    match (o.verdict, o.scale.over) with
    | Violated { witness = Some { fixed = Some { values; _ }; _ } }, _ -> values
    | _, Some over -> over.example
    | _, None -> []
  in
  values_to_string values

let for_values o = match values_of o with "" -> "" | values -> " for " ^ values

(* What is proved to be violated, for which values. *)
let proved_for o =
  let instants (over : over) = over_to_string { over with ranges = [||] } in
  match o.scale.over with
  | Some ({ ranges; everywhere; _ } as over) when Array.length ranges > 0 ->
    let which =
      if everywhere then "all " ^ Ranges.to_string ranges
      else
        let such = values_of o in
        "some " ^ Ranges.to_string ranges ^ if such = "" then "" else ", such as " ^ such
    in
    Printf.sprintf " for %s (proved by an invariant%s)" which (instants over)
  | over ->
    let instants = Option.fold ~none:"" ~some:instants over in
    Printf.sprintf "%s (proved by an invariant%s)" (for_values o) instants

let unshown o =
  let run =
    match o.verdict with
    | Undecided _ | Measured { reasons = _ :: _; _ } -> "the run to what was not explored"
    | Holds _ | Violated _ | Depends _ | Measured { reasons = []; _ } -> "its run"
  in
  let left_out t = Printf.sprintf "; %s is left out: making it ended at %s" run (truncation_to_string t) in
  (match o.lost with [] -> "" | _ :: _ -> "; its run could not be rebuilt: this is a fault of scc")
  ^ Option.fold ~none:"" ~some:left_out o.left_out

let asks_number (c : Scc_property.Property.check) =
  match c.asked with
  | How_likely _ | Expected (_, _, None) -> true
  | Whether | Expected (_, _, Some _) -> false

let outcome_to_string o =
  let everywhere = Option.fold ~none:"" ~some:over_to_string o.scale.over in
  let verdict =
    match o.verdict with
    | Undecided _ -> to_string o.verdict
    | Measured _ | Depends _ -> to_string o.verdict ^ scale_to_string o.scale
    | Holds { bounds = []; _ } when by_invariant o ->
      Printf.sprintf "holds (proved by an invariant%s)%s" everywhere (scale_to_string o.scale)
    | Holds { bounds = []; _ } when everywhere <> "" ->
      Printf.sprintf "holds (exhaustive%s)%s" everywhere (scale_to_string o.scale)
    | Violated { witness = None } when by_invariant o ->
      "violated" ^ proved_for o ^ scale_to_string o.scale
    | Holds _ when everywhere <> "" -> to_string o.verdict ^ everywhere ^ scale_to_string o.scale
    | Violated _ when everywhere <> "" -> to_string o.verdict ^ for_values o ^ scale_to_string o.scale
    | Holds _ | Violated _ ->
      to_string o.verdict ^ String.concat "" (List.map rest_to_string o.rests) ^ scale_to_string o.scale
  in
  let told = function Named s -> Slowing.to_string s | Proved q -> Quickening.to_string q in
  verdict ^ Option.fold ~none:"" ~some:(fun c -> "; " ^ told c) o.converges ^ unshown o

let shown = function
  | Holds { witness; _ } | Violated { witness } | Measured { witness; _ } -> witness
  | Depends _ -> None
  | Undecided reasons ->
    List.find_map
      (function
        | Unexplored { nearest = w; _ } -> Some w
        | Truncated _ | Unevaluated _ | Undefined _ | Fault _ -> None)
      reasons

let if_unshown v left_out = match shown v with Some _ -> None | None -> left_out
