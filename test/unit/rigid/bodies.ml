(* Solids in the world that the tests of rigid bodies draw from. *)

open Scc_exact
open Scc_geometry
open Scc_rigid
module Gen = QCheck2.Gen

let v = Vec.of_ints
let ratio p q = Rat.make (Z.of_int p) (Z.of_int q)
let quaternion (w, x, y, z) = Quaternion.make (Z.of_int w) (Z.of_int x) (Z.of_int y) (Z.of_int z)

let solids =
  lazy
    (List.mapi (fun id (_, plain) -> Scc_test_data.Test_data.solid ~id plain Mat.identity) Solids.named
     |> Array.of_list)

let solid = Gen.map (fun i -> (Lazy.force solids).(i)) Gen.(0 -- (List.length Solids.named - 1))

let named name =
  let rec index i = function
    | [] -> invalid_arg name
    | (n, _) :: rest -> if String.equal n name then i else index (i + 1) rest
  in
  (Lazy.force solids).(index 0 Solids.named)

(* The rotations of a cube onto itself. *)
let square_turns =
  let c = [ -1; 0; 1 ] in
  let all = List.concat_map (fun w -> List.concat_map (fun x -> List.map (fun y -> (w, x, y)) c) c) c in
  List.concat_map (fun (w, x, y) -> List.map (fun z -> (w, x, y, z)) c) all
  |> List.filter (fun (w, x, y, z) -> List.mem (abs w + abs x + abs y + abs z) [ 1; 2; 4 ])
  |> List.map quaternion

let square_turn = Gen.oneofl square_turns

let turn_of top =
  let c = Gen.(-top -- top) in
  Gen.map (function 0, 0, 0, 0 -> Quaternion.identity | q -> quaternion q) (Gen.quad c c c c)

let any_turn = turn_of 4
let slight_turn = Gen.map (fun (x, y, z) -> quaternion (1000, x, y, z)) Gen.(triple (-3 -- 3) (-3 -- 3) (-3 -- 3))
let turn = Gen.frequency [ (3, square_turn); (2, any_turn); (1, slight_turn) ]
let halves = Gen.map Solids.halves Gen.(triple (-9 -- 9) (-9 -- 9) (-9 -- 9))

let placed turn at =
  Gen.map3 (fun solid turned at -> { Placed.solid; turned; at }) solid turn at

let plain (b : Placed.t) : Solids.Naive.solid =
  let faces = Array.to_list b.solid.polyhedron.faces in
  { points = Placed.vertices b; faces = List.map (fun (_, f) -> Array.to_list f) faces }

let show (b : Placed.t) =
  let name, _ = List.nth Solids.named b.solid.id in
  Printf.sprintf "%s turned %s at %s" name (Quaternion.to_string b.turned) (Vec.to_string b.at)

let show_pair (a, b) = show a ^ "; " ^ show b

(* A motion of the whole world. *)
type motion = { by : Quaternion.t; to_ : Vec.t }

let motion = Gen.map2 (fun by to_ -> { by; to_ }) any_turn halves
let move_point m p = Vec.add m.to_ (Quaternion.apply m.by p)

let move m (b : Placed.t) =
  { b with turned = Quaternion.mul m.by b.turned; at = move_point m b.at }

(* Pairs that touch exactly: aligned bodies, of which the second falls onto the first; and any two that are shifted
   along a line through both. *)
let fallen (a, b, towards) =
  let solid_a = Placed.fixed_solid a and solid_b = Placed.fixed_solid b in
  let o = Obstacle.make solid_a solid_b in
  let far = Vec.scale (Rat.of_int 40) towards in
  let r = Vec.sub b.Placed.at a.Placed.at in
  if Vec.is_zero towards then None
  else
    match Obstacle.first_time_of_contact o (Vec.add r far) (Vec.neg towards) with
    | At t -> Some (a, { b with at = Vec.add b.at (Vec.axpy (Rat.neg t) towards far) })
    | Never | Inside -> None

let touching_pair =
  let pair turn at =
    let towards = Gen.map (fun (x, y, z) -> v x y z) Gen.(triple (-2 -- 2) (-2 -- 2) (-2 -- 2)) in
    Gen.map fallen (Gen.triple (placed turn (Gen.return Vec.zero)) (placed turn at) towards)
  in
  let near = Gen.map Solids.halves Gen.(triple (-3 -- 3) (-3 -- 3) (-3 -- 3)) in
  Gen.frequency [ (2, pair square_turn near); (1, pair any_turn near) ]
