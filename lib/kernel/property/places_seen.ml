open Scc_exact
open Property

type limits = Between of Rat.t * Rat.t | All
type place = Distance of int * int | Along of Vec.t * int

let compare_place a b =
  match (a, b) with
  | Distance (i, j), Distance (k, l) ->
    Int.compare i k <?> fun () -> Int.compare j l
  | Along (n, i), Along (m, j) ->
    Int.compare i j <?> fun () -> Vec.compare n m
  | Distance _, Along _ -> -1
  | Along _, Distance _ -> 1

let equal_place a b = compare_place a b = 0

module Places = Map.Make (struct
    type t = place

    let compare = compare_place
  end)

(* With the number by which each place came: they are told in that order. *)
type t = { seen : (int * limits) Places.t; everything : bool }

let nothing = { seen = Places.empty; everything = false }

let join_limits a b =
  match (a, b) with
  | All, _ | _, All -> All
  | Between (l, h), Between (k, g) -> Between (Rat.min l k, Rat.max h g)

let add seen (place, limits) =
  let order, limits =
    match Places.find_opt place seen with
    | Some (order, known) -> (order, join_limits limits known)
    | None -> (Places.cardinal seen, limits)
  in
  Places.add place (order, limits) seen

let in_order seen =
  Places.bindings seen
  |> List.sort (fun (_, (i, _)) (_, (j, _)) -> Int.compare i j)
  |> List.map (fun (place, (_, limits)) -> (place, limits))

let join a b =
  { seen = List.fold_left add a.seen (in_order b.seen); everything = a.everything || b.everything }

let join_all f list = List.fold_left (fun seen x -> join seen (f x)) nothing list

let place : quantity -> place option = function
  | Position (axis, i) -> Some (Along (Vec.unit axis, i))
  | Distance2 (i, j) -> Some (Distance (Int.min i j, Int.max i j))
  | Bonds _ | Size _ | Processes | Velocity _ | Speed2 _ | Spin _ | Spin2 _ | Momentum _ | Angular _ | Energy
  | Time | Parameter _ -> None

let is_angular : quantity -> bool = function
  | Angular _ -> true
  | Bonds _ | Size _ | Processes | Position _ | Velocity _ | Speed2 _ | Spin _ | Spin2 _ | Distance2 _ | Momentum _
  | Energy | Time | Parameter _ -> false

let whole qs =
  let seen = List.fold_left (fun seen p -> add seen (p, All)) Places.empty (List.filter_map place qs) in
  { seen; everything = List.exists is_angular qs }

(* What is told of a distance, or of all coordinates of one leaf, where nothing else is in it: by which rate each
   counts, and what a value of them together is. *)
let alone = function
  | Distance (i, j) :: rest as all when List.for_all (equal_place (List.hd all)) rest ->
    let rate p = if equal_place (Distance (i, j)) p then Some (Vec.unit X) else None in
    Some (rate, fun _ -> Distance (i, j))
  | Along (_, i) :: rest when List.for_all (function Along (_, j) -> i = j | Distance _ -> false) rest ->
    let rate = function Along (n, j) when i = j -> Some n | Along _ | Distance _ -> None in
    Some (rate, fun n -> Along (n, i))
  | [] | Distance _ :: _ | Along _ :: _ -> None

let compared m a b =
  let difference = Sub (a, b) in
  let qs = By_cases.values difference in
  match alone (List.filter_map place qs) with
  | None -> whole qs
  | Some (rate, combined) -> (
      match By_cases.cases m ~variable:(fun q -> Option.bind (place q) rate) difference with
      | None -> whole qs
      | Some cases ->
        let limits c = Option.map (fun (n, (l, h)) -> (combined n, Between (l, h))) (By_cases.zeros c) in
        { nothing with seen = List.fold_left add Places.empty (List.filter_map limits cases) })

let rec prop m = function
  | Compare (_, a, b) -> join (compared m a b) (join (conditions m a) (conditions m b))
  | p -> join_all (prop m) (Parts.of_prop p).predicates

and conditions m n = join_all (prop m) (By_cases.conditions n)

let check m (c : Property.check) =
  let value =
    match c.asked with
    | Expected (_, Value_at (n, _), _) -> join (whole (By_cases.values n)) (conditions m n)
    | Expected (_, (Time_until _ | Events_until _), _) | Whether | How_likely _ -> nothing
  in
  join value (join_all (prop m) (Formula.predicates c.formula))

let checks m list = join_all (check m) list

let distances t =
  List.filter_map (function Distance (i, j), limits -> Some (i, j, limits) | Along _, _ -> None) (in_order t.seen)

let coordinates t =
  List.filter_map (function Along (n, i), limits -> Some (n, i, limits) | Distance _, _ -> None) (in_order t.seen)

let everything t = t.everything

let for_ever t =
  t.everything || Places.exists (fun _ (_, limits) -> match limits with All -> true | Between _ -> false) t.seen
