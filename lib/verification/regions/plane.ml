open Scc_exact
open Scc_polyhedra
open Scc_calculus

type view = { across : int; up : int option; fixed : (int * Rat.t) list }

(* {1 What is shown} *)

let number ranges name =
  match Ranges.find ranges name with
  | Some i -> Ok i
  | None -> Error (Printf.sprintf "there is no parameter '%s' that has a range" name)

let rec all f = function
  | [] -> Ok []
  | x :: rest ->
    let* y = f x in
    let* ys = all f rest in
    Ok (y :: ys)

let value (ranges : Ranges.t) (name, x) =
  let* i = number ranges name in
  if Ranges.mem ranges.(i) x then Ok (i, x)
  else
    let range = Ranges.range_to_string ranges.(i) in
    Error (Printf.sprintf "%s = %s is not in its range: %s" name (Rat.to_string x) range)

let rec repeated = function
  | [] -> None
  | (i : int) :: rest -> if List.mem i rest then Some i else repeated rest

let view ranges ~axes ~fixed =
  let* fixed = all (value ranges) fixed in
  let* named = all (number ranges) axes in
  let is_fixed i = List.mem_assoc i fixed in
  let free = List.filter (fun i -> not (is_fixed i)) (List.init (Array.length ranges) Fun.id) in
  match (repeated (named @ List.map fst fixed), named, free) with
  | Some i, _, _ -> Error (Printf.sprintf "the parameter '%s' is named twice" (Ranges.name ranges i))
  | None, [], [] -> Error "no parameter has a range to be drawn"
  | None, [], [ across ] | None, [ across ], _ -> Ok { across; up = None; fixed }
  | None, [], across :: up :: _ | None, [ across; up ], _ -> Ok { across; up = Some up; fixed }
  | None, _, _ -> Error "one or two parameters can be drawn"

let hidden ranges view =
  let shown i = i = view.across || Some i = view.up || List.mem_assoc i view.fixed in
  List.filter (fun i -> not (shown i)) (List.init (Array.length ranges) Fun.id)

(* {1 What is seen} *)

(* Of a line: between 0 and 1. *)
let raised p =
  let y = Linear.variable 2 1 and at = Linear.constant 2 in
  Polyhedron.add_all (Polyhedron.embed p ~dimension:2 [| 0 |])
    [ Constraint.at_least y (at Rat.zero); Constraint.at_most y (at Rat.one) ]

let seen ranges view u =
  let n = Array.length ranges in
  let fix p (i, x) = Polyhedron.substitute p i (Linear.constant n x) in
  let one p =
    let p = List.fold_left fix p view.fixed in
    match view.up with
    | Some up -> Polyhedron.project p [| view.across; up |]
    | None -> raised (Polyhedron.project p [| view.across |])
  in
  Union.map ~dimension:2 one u

type outcome = Holds | Varies | Unknown | Fails | Value of int

let outcomes ranges view ~box (w : Where.t) =
  let holds = seen ranges view w.holds and fails = seen ranges view w.fails in
  let unknown = seen ranges view w.unknown in
  if hidden ranges view = [] then [ (Holds, holds); (Unknown, unknown); (Fails, fails) ]
  else
    let varies = Union.inter holds fails in
    let only u v = Union.difference (Union.difference u v) unknown in
    let decided = [ (Holds, only holds fails); (Varies, varies); (Fails, only fails holds) ] in
    let rest = List.fold_left (fun left (_, u) -> Union.difference left u) box decided in
    decided @ [ (Unknown, rest) ]

(* Where one number alone is seen, and where several are. *)
let of_values ranges view ~box (c : Chances.t) =
  let sets = List.map (fun (p : Chances.part) -> seen ranges view p.set) c.parts in
  let others i = List.filteri (fun j _ -> j <> i) sets in
  let unknown = seen ranges view c.unknown in
  let only i set = (Value i, List.fold_left Union.difference set (unknown :: others i)) in
  if hidden ranges view = [] then List.mapi (fun i set -> (Value i, set)) sets @ [ (Unknown, unknown) ]
  else
    let single = List.mapi only sets @ [ (Unknown, List.fold_left Union.difference unknown sets) ] in
    single @ [ (Varies, List.fold_left (fun left (_, set) -> Union.difference left set) box single) ]

type region = { outcomes : outcome list; set : Union.t; share : Rat.t }

let area u =
  match Where.measure u with
  | Some area -> area
  | None -> Scc_base.Bug.fail __POS__ "an area takes few corners"

let regions ?(values = []) ranges view checks =
  let box = seen ranges view (Union.of_polyhedron (Ranges.box ranges)) in
  let whole = area box in
  let part (before, set) (outcome, u) = (outcome :: before, Union.inter set u) in
  let further parts sets =
    let parted = List.concat_map (fun p -> List.map (part p) sets) parts in
    List.filter (fun (_, set) -> not (Union.is_empty set)) parted
  in
  let region (outcomes, set) =
    let set = Where.tidy set in
    { outcomes = List.rev outcomes; set; share = Rat.div (area set) whole }
  in
  let all = List.map (outcomes ranges view ~box) checks @ List.map (of_values ranges view ~box) values in
  let order a b = compare a.outcomes b.outcomes in
  List.sort order (List.map region (List.fold_left further [ ([], box) ] all))
