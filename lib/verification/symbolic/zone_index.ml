open Scc_data
open Scc_exact
open Scc_polyhedra
open Scc_state_sets

module Kinds = Hashtbl.Make (struct
    type t = Zone.t

    let equal = Zone_form.same_kind
    let hash = Zone_form.hash_kind
  end)

let hash_array hash = Array.fold_left (fun h x -> (h * 31) + hash x) 0

(* Coordinates but for their constants, and which of them are the variables. *)
type directions = { basis : int array; linear : Linear.t array }

module Directions = Hashtbl.Make (struct
    type t = directions

    let equal a b = Arrays.equal Int.equal a.basis b.basis && Arrays.equal Linear.equal a.linear b.linear
    let hash d = hash_array Linear.hash d.linear
  end)

module Constants = Hashtbl.Make (struct
    type t = Rat.t array

    let equal = Arrays.equal Rat.equal
    let hash = hash_array Rat.hash
  end)

(* The last ones first. *)
type 'a entry = { order : int; it : 'a }
type 'a by_constants = 'a entry list Constants.t
type 'a kind = { by_directions : 'a by_constants Directions.t; mutable all : (directions * 'a by_constants) list }
type 'a t = { kinds : 'a kind Kinds.t; mutable count : int }

let create () = { kinds = Kinds.create 64; count = 0 }
let constant_of (f : Linear.t) = f.constant

let parted (zone : Zone.t) =
  let coordinates = Zone.coordinates zone in
  let linear = Array.map (fun f -> Linear.make ~constant:Rat.zero f.Linear.coefficients) coordinates in
  ({ basis = zone.basis; linear }, Array.map constant_of coordinates)

let entries by_constants constants = Option.value (Constants.find_opt by_constants constants) ~default:[]

let add t zone it =
  let kind =
    match Kinds.find_opt t.kinds zone with
    | Some kind -> kind
    | None ->
      let kind = { by_directions = Directions.create 8; all = [] } in
      Kinds.add t.kinds zone kind;
      kind
  in
  let directions, constants = parted zone in
  let by_constants =
    match Directions.find_opt kind.by_directions directions with
    | Some by_constants -> by_constants
    | None ->
      let by_constants = Constants.create 8 in
      Directions.add kind.by_directions directions by_constants;
      kind.all <- (directions, by_constants) :: kind.all;
      by_constants
  in
  Constants.replace by_constants constants ({ order = t.count; it } :: entries by_constants constants);
  t.count <- t.count + 1

let entries_alike kind zone =
  let directions, constants = parted zone in
  match Directions.find_opt kind.by_directions directions with
  | Some by_constants -> entries by_constants constants
  | None -> []

let alike t zone =
  match Kinds.find_opt t.kinds zone with
  | Some kind -> List.map (fun e -> e.it) (entries_alike kind zone)
  | None -> []

(* {1 What may be around a zone}

   A coordinate that does not depend on earlier ones in a part of a zone does not do so in the zone. So the basis
   of what is included is part of the basis of what includes it; where they are the same, so are the forms. Where
   that is wider, its directions leave one choice of constants. *)

let is_wider basis ~than =
  Array.length basis > Array.length than && Array.for_all (fun i -> Array.exists (Int.equal i) basis) than

exception No_constant

let constants_around zone { basis; linear } =
  let coordinates = Zone.coordinates zone and dimension = Zone.dimension zone in
  let forms = Array.map (fun i -> coordinates.(i)) basis in
  let left coordinate f =
    let rest = Linear.sub coordinate (Linear.compose f ~dimension forms) in
    if Linear.is_constant rest then rest.constant else raise No_constant
  in
  match Array.map2 left coordinates linear with constants -> Some constants | exception No_constant -> None

let last_around t (zone : Zone.t) answer =
  let rec last best = function
    | { order; it } :: rest when Option.fold ~none:true ~some:(fun (best, _) -> order > best) best -> (
        match answer it with Some found -> Some (order, found) | None -> last best rest)
    | _ -> best
  in
  let of_wider best (directions, by_constants) =
    if not (is_wider directions.basis ~than:zone.basis) then best
    else
      match constants_around zone directions with
      | Some constants -> last best (entries by_constants constants)
      | None -> best
  in
  match Kinds.find_opt t.kinds zone with
  | None -> None
  | Some kind -> Option.map snd (List.fold_left of_wider (last None (entries_alike kind zone)) kind.all)
