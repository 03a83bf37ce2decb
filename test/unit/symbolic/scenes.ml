(* Random pairs of solids whose offset depends on two parameters: small integers everywhere, so that ties and
   grazes are likely. *)

open Scc_exact
open Scc_geometry
open Scc_polyhedra
module Gen = QCheck2.Gen

let q n d = Rat.make (Z.of_int n) (Z.of_int d)
let int = Rat.of_int

let solid id linear = Solid.make ~id Scc_test_networks.Cube.polyhedron linear
let cube = solid 0 Mat.identity

let turned =
  match Mat.of_quaternion (int 2, int 1, int 0, int 1) with
  | Some r -> Mat.scale (q 1 2) r
  | None -> failwith "the zero quaternion"

let sheared = Mat.make (Vec.make (q 1 2) (q 1 2) Rat.zero) (Vec.of_ints 0 1 0) (Vec.of_ints 0 0 1)
let solids = [| cube; solid 1 (Mat.diagonal (Vec.make Rat.one (q 1 2) Rat.one)); solid 2 sheared; solid 3 turned |]

type t = { one : int; two : int; base : int * int * int; by : (int * int) array; velocity : int * int * int }

(* The coordinates of the offset are at most [far] where the parameters are 0. *)
let generate ~far =
  let open Gen in
  let small = -2 -- 2 and three g = triple g g g in
  let* one = 0 -- 3 and* two = 0 -- 3 and* base = three (-far -- far) and* velocity = three small in
  let+ by = array_size (pure 3) (pair (-1 -- 1) (-1 -- 1)) in
  { one; two; base; by; velocity }

let print { one; two; base; by; velocity } =
  let three (x, y, z) = Printf.sprintf "(%d, %d, %d)" x y z in
  let by = String.concat " " (Array.to_list (Array.map (fun (a, b) -> Printf.sprintf "%da%+db" a b) by)) in
  Printf.sprintf "solids %d, %d; offset %s + [%s]; velocity %s" one two (three base) by (three velocity)

let obstacle s = Obstacle.make solids.(s.one) solids.(s.two)

let offset { base = x, y, z; by; _ } =
  let form c (a, b) = Linear.make ~constant:(int c) [| int a; int b |] in
  (form x by.(0), form y by.(1), form z by.(2))

let offset_at s point =
  let x, y, z = offset s in
  Vec.make (Linear.eval x point) (Linear.eval y point) (Linear.eval z point)

let velocity { velocity = x, y, z; _ } = Vec.of_ints x y z

(* The facets of an obstacle that hold an offset. *)
let tight o r =
  let holds (f : Obstacle.facet) = Rat.equal (Vec.dot (Ivec.to_vec f.normal) r) (Rat.make f.num f.den) in
  let numbered = Array.to_list (Array.mapi (fun i f -> (i, f)) (Obstacle.facets o)) in
  List.filter_map (fun (i, f) -> if holds f then Some i else None) numbered

(* {1 Parameters} *)

let within = Polyhedron.box [| (int (-3), int 3); (int (-3), int 3) |]

(* In steps of a half, and some points between. *)
let points =
  let halves = List.init 13 (fun i -> q (i - 6) 2) in
  List.concat_map (fun a -> List.map (fun b -> [| a; b |]) halves) halves
  @ [ [| q 1 3; q 2 7 |]; [| q (-5) 3; q 1 9 |]; [| q 11 4; q (-13) 5 |] ]

(* Each point of the region has one answer, and the right one. *)
let all_right ~within ~answers ~expected ~same =
  let wrong p = match answers p with [ a ] -> not (same a (expected p)) | [] | _ :: _ :: _ -> true in
  match List.find_opt wrong (List.filter (Polyhedron.mem within) points) with
  | None -> true
  | Some p -> QCheck2.Test.fail_reportf "at %s, %s" (Rat.to_string p.(0)) (Rat.to_string p.(1))
