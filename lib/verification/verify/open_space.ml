open Scc_exact
open Scc_rigid
open Scc_calculus
open Scc_semantics

type box = { low : Vec.t; high : Vec.t }

let by f (a : Vec.t) (b : Vec.t) = Vec.make (f a.x b.x) (f a.y b.y) (f a.z b.z)
let union a b = { low = by Rat.min a.low b.low; high = by Rat.max a.high b.high }

let of_part (p : Part.t) =
  let around = Array.map (fun v -> { low = v; high = v }) (Placed.vertices p.placed) in
  Array.fold_left union around.(0) around

let are_apart a b =
  let below f x y = Rat.compare (f x.high) (f y.low) <= 0 in
  let beyond (f : Vec.t -> Rat.t) = below f a b || below f b a in
  beyond (fun v -> v.x) || beyond (fun v -> v.y) || beyond (fun v -> v.z)

let is_outside c (s : State.t) ~inside ~others =
  let parts = Array.to_list (Collisions.parts c s.processes) in
  let of_leaves is_so = List.filter (fun (p : Part.t) -> is_so p.leaf.leaf) parts in
  match List.map of_part (of_leaves others) with
  | [] -> true
  | first :: rest ->
    let around = List.fold_left union first rest in
    List.for_all (fun p -> are_apart (of_part p) around) (of_leaves inside)
