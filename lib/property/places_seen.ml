open Scc_exact
open Property

type limits = Between of Rat.t * Rat.t | All

(* Each quantity once. *)
type t = { seen : (quantity * limits) list; everything : bool }

let nothing = { seen = []; everything = false }

let join_limits a b =
  match (a, b) with
  | All, _ | _, All -> All
  | Between (l, h), Between (k, g) -> Between (Rat.min l k, Rat.max h g)

let equal_quantity a b = Atom.compare (Atom.quantity a) (Atom.quantity b) = 0

(* The two leaves of a distance in one order. *)
let in_order = function
  | Distance2 (i, j) -> Distance2 (Int.min i j, Int.max i j)
  | q -> q

let rec add (q, limits) = function
  | [] -> [ (q, limits) ]
  | (r, known) :: rest when equal_quantity q r -> (q, join_limits limits known) :: rest
  | first :: rest -> first :: add (q, limits) rest

let join a b =
  {
    seen = List.fold_left (fun seen q -> add q seen) a.seen b.seen;
    everything = a.everything || b.everything;
  }

let join_all f list = List.fold_left (fun seen x -> join seen (f x)) nothing list

let is_place : quantity -> bool = function
  | Position _ | Distance2 _ -> true
  | Bonds _ | Size _ | Processes | Velocity _ | Speed2 _ | Spin _ | Spin2 _ | Momentum _ | Angular _ | Energy
  | Time | Parameter _ -> false

let is_angular : quantity -> bool = function Angular _ -> true | _ -> false

let values n = List.map in_order (By_cases.values n)

let whole qs =
  let places = List.filter is_place qs in
  { seen = List.fold_left (fun seen q -> add (q, All) seen) [] places; everything = List.exists is_angular qs }

let compared m a b =
  let difference = Sub (a, b) in
  let qs = values difference in
  match List.filter is_place qs with
  | q :: rest when List.for_all (equal_quantity q) rest -> (
      let variable r = equal_quantity q (in_order r) in
      match By_cases.cases m ~variable difference with
      | None -> whole qs
      | Some cases ->
        let zeros = List.filter_map By_cases.zeros cases in
        { nothing with seen = List.fold_left (fun seen (l, h) -> add (q, Between (l, h)) seen) [] zeros })
  | _ -> whole qs

let rec prop m = function
  | Compare (_, a, b) -> join (compared m a b) (join (conditions m a) (conditions m b))
  | Not p -> prop m p
  | And ps | Or ps -> join_all (prop m) ps
  | Fact _ | Bool _ -> nothing

and conditions m n = join_all (prop m) (By_cases.conditions n)

let check m (c : Property.check) =
  let value =
    match c.asked with
    | Expected (_, Value_at (n, _), _) -> join (whole (values n)) (conditions m n)
    | Expected (_, (Time_until _ | Events_until _), _) | Whether | How_likely _ -> nothing
  in
  join value (join_all (prop m) (Formula.predicates c.formula))

let checks m list = join_all (check m) list

let distances t =
  List.filter_map (function Distance2 (i, j), limits -> Some (i, j, limits) | _ -> None) t.seen

let coordinates t =
  List.filter_map (function Position (axis, i), limits -> Some (axis, i, limits) | _ -> None) t.seen

let everything t = t.everything

let for_ever t =
  t.everything || List.exists (fun (_, limits) -> match limits with All -> true | Between _ -> false) t.seen
