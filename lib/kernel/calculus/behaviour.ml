open Scc_exact
open Scc_polyhedra

type channel = { name : string; sites : Site.t list; only : Site.t list; surface : Site.t list }

let channel ?(only = []) ~name ~sites ~closure () =
  let sites = List.sort_uniq Site.compare sites and closure = List.sort_uniq Site.compare closure in
  let within list site = List.exists (Site.equal site) list in
  let only = List.filter (fun site -> not (within closure site)) (List.sort_uniq Site.compare only) in
  if sites = [] && only = [] then Scc_base.Bug.fail __POS__ "a channel without features"
  else { name; sites; only; surface = List.merge Site.compare closure only }

let active c site = List.exists (Site.equal site) c.surface

type polarity = Name | Co_name

type loosening = { push : Rat.t; odds : Odds.t option }

type t =
  | Nil
  | Open of polarity * channel * t
  | Weak of channel * loosening * t
  | Strong of channel list * Rat.t * t
  | Delay of Rat.t * t
  | Wait of Linear.t * t
  | Sum of t * t
  | Call of int

(* Canonical terms. A redundant list of features means the same: what tells channels apart is the surface. *)

let compare_channel (a : channel) (b : channel) =
  String.compare a.name b.name <?> fun () -> List.compare Site.compare a.surface b.surface

let polarity_rank = function Name -> 0 | Co_name -> 1

let rank = function
  | Nil -> 0
  | Open _ -> 1
  | Weak _ -> 2
  | Strong _ -> 3
  | Delay _ -> 4
  | Wait _ -> 5
  | Sum _ -> 6
  | Call _ -> 7

let compare_loosening i j =
  Rat.compare i.push j.push <?> fun () -> Option.compare Odds.compare i.odds j.odds

let rec compare a b =
  if a == b then 0
  else
    match (a, b) with
    | Open (p, c, x), Open (q, d, y) ->
      Stdlib.compare (p : polarity) q <?> fun () ->
        compare_channel c d <?> fun () -> compare x y
    | Weak (c, i, x), Weak (d, j, y) ->
      compare_channel c d <?> fun () -> compare_loosening i j <?> fun () -> compare x y
    | Strong (l, i, x), Strong (m, j, y) ->
      List.compare compare_channel l m <?> fun () -> Rat.compare i j <?> fun () -> compare x y
    | Delay (s, x), Delay (t, y) -> Rat.compare s t <?> fun () -> compare x y
    | Wait (s, x), Wait (t, y) -> Linear.compare s t <?> fun () -> compare x y
    | Sum (x, x'), Sum (y, y') -> compare x y <?> fun () -> compare x' y'
    | Call i, Call j -> Int.compare i j
    | _ -> Int.compare (rank a) (rank b)

let equal a b = compare a b = 0

(* Only the top of a term is hashed, and how much is below: terms of one model that differ do so near the top,
   mostly, or some are what is left of others. *)
let hash_depth = 4

let hash_channel (c : channel) =
  List.fold_left (fun h s -> (h * 31) + Site.hash s) (Hashtbl.hash c.name) c.surface

let hash_loosening j =
  match j.odds with None -> Rat.hash j.push | Some odds -> Rat.hash j.push + (47 * Odds.hash odds)

let rec length n = function
  | Nil | Call _ -> n
  | Open (_, _, b) | Weak (_, _, b) | Strong (_, _, b) | Delay (_, b) | Wait (_, b) | Sum (b, _) ->
    length (n + 1) b

let rec hash_to depth b =
  if depth = 0 then length 17 b
  else
    let below = hash_to (depth - 1) in
    match b with
    | Nil -> 1
    | Open (p, c, b) -> (((polarity_rank p * 31) + hash_channel c) * 31) + below b
    | Weak (c, j, b) -> (hash_channel c * 37) + (hash_loosening j * 43) + below b
    | Strong (l, j, b) -> List.fold_left (fun h c -> (h * 41) + hash_channel c) ((Rat.hash j * 43) + below b) l
    | Delay (t, b) -> (Rat.hash t * 43) + below b
    | Wait (t, b) -> (Linear.hash t * 43) + below b
    | Sum (a, b) -> (below a * 47) + below b
    | Call i -> (i * 53) + 7

let hash = hash_to hash_depth
let nil = Nil
let open_ polarity channel b = Open (polarity, channel, b)
let weak ?(push = Rat.zero) ?odds channel b = Weak (channel, { push; odds }, b)

let strong ?(push = Rat.zero) channels b =
  match channels with
  | [] -> Scc_base.Bug.fail __POS__ "a strong split without entries"
  | _ :: _ -> Strong (List.sort_uniq compare_channel channels, push, b)

let delay t b =
  match Rat.sign t with
  | 0 -> b
  | s when s < 0 -> Scc_base.Bug.fail __POS__ "a negative delay"
  | _ -> Delay (t, b)

let wait t b = if Linear.is_constant t then delay t.constant b else Wait (t, b)

let written t b =
  if not (Linear.is_constant t) then Wait (t, b)
  else if Rat.sign t.constant = 0 then Delay (Rat.zero, b)
  else delay t.constant b

let parts = function
  | Nil | Call _ -> []
  | Open (_, _, b) | Weak (_, _, b) | Strong (_, _, b) | Delay (_, b) | Wait (_, b) -> [ b ]
  | Sum (a, b) -> [ a; b ]

let rec sum a = function
  | Sum (b, c) -> Sum (sum a b, c)
  | (Nil | Open _ | Weak _ | Strong _ | Delay _ | Wait _ | Call _) as b -> Sum (a, b)

let call k = Call k

type definition = { name : string; body : t }
type definitions = definition array

(* The last name that an eps(0) brings up as one unfolds, if any does. *)
let brought_up (defs : definitions) k =
  let rec unfold found ~expired = function
    | Delay (t, rest) when Rat.sign t = 0 -> unfold found ~expired:true rest
    | Call z -> unfold (if expired then z else found) ~expired:false defs.(z).body
    | Nil | Open _ | Weak _ | Strong _ | Delay _ | Wait _ | Sum _ -> found
  in
  unfold k ~expired:false defs.(k).body

let canonical defs =
  let names = Array.init (Array.length defs) (fun k -> lazy (brought_up defs k)) in
  let rec canonical = function
    | Nil -> Nil
    | Open (p, c, b) -> Open (p, c, canonical b)
    | Weak (c, j, b) -> Weak (c, j, canonical b)
    | Strong (l, j, b) -> Strong (l, j, canonical b)
    | Delay (t, b) -> delay t (canonical b)
    | Wait (t, b) -> Wait (t, canonical b)
    | Sum (a, b) -> sum (canonical a) (canonical b)
    | Call k -> Call (Lazy.force names.(k))
  in
  canonical

let canonical_definitions defs =
  let canonical = canonical defs in
  Array.map (fun d -> { d with body = canonical d.body }) defs
type aged = { origin : int option; term : t }

let aged origin term = { origin; term }

let reached ~before term =
  match term with
  | Call k -> aged (Some k) term
  | Nil | Open _ | Weak _ | Strong _ | Delay _ | Wait _ | Sum _ -> aged before term

let fresh term = reached ~before:None term
let compare_aged a b = Option.compare Int.compare a.origin b.origin <?> fun () -> compare a.term b.term
let equal_aged a b = compare_aged a b = 0
let hash_aged a = (hash a.term * 31) + match a.origin with None -> 0 | Some k -> k + 1

let channels = function
  | Open (_, c, _) | Weak (c, _, _) -> [ c ]
  | Strong (list, _, _) -> list
  | Nil | Delay _ | Wait _ | Sum _ | Call _ -> []

let is_delay = function
  | Delay _ | Wait _ -> true
  | Nil | Open _ | Weak _ | Strong _ | Sum _ | Call _ -> false

(* Each definition is looked at once, however many ways lead to it. *)
let some_prefix (defs : definitions) ~behind is b =
  let seen = Hashtbl.create 8 in
  let rec search = function
    | [] -> false
    | b :: rest -> (
        match b with
        | Nil -> search rest
        | Sum (x, y) -> search (x :: y :: rest)
        | Call k when Hashtbl.mem seen k -> search rest
        | Call k ->
          Hashtbl.add seen k ();
          search (defs.(k).body :: rest)
        | Open (_, _, next) | Weak (_, _, next) | Strong (_, _, next) | Delay (_, next) | Wait (_, next) ->
          is b || search (if behind b then next :: rest else rest))
  in
  search [ b ]

(* The names exposed in a body: those that it may unfold without anything happening. *)
let rec exposed ~may_be_zero found = function
  | Wait (t, b) when may_be_zero t -> exposed ~may_be_zero found b
  | Delay (t, b) when Rat.sign t = 0 -> exposed ~may_be_zero found b
  | Nil | Open _ | Weak _ | Strong _ | Delay _ | Wait _ -> found
  | Sum (a, b) -> exposed ~may_be_zero (exposed ~may_be_zero found a) b
  | Call k -> k :: found

let unguarded ~may_be_zero defs =
  let next = Array.map (fun d -> exposed ~may_be_zero [] d.body) defs in
  let reaches_itself start =
    let seen = Hashtbl.create 8 in
    let rec search = function
      | [] -> false
      | k :: _ when k = start -> true
      | k :: rest when Hashtbl.mem seen k -> search rest
      | k :: rest ->
        Hashtbl.add seen k ();
        search (List.rev_append next.(k) rest)
    in
    search next.(start)
  in
  List.filter reaches_itself (List.init (Array.length defs) Fun.id)
