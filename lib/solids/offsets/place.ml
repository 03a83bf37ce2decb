open Scc_exact
open Scc_polyhedra

type t = Linear.t * Linear.t * Linear.t

let constant n (v : Vec.t) = Linear.(constant n v.x, constant n v.y, constant n v.z)
let map2 f (x, y, z) (x', y', z') = (f x x', f y y', f z z')
let add = map2 Linear.add
let sub = map2 Linear.sub

let moved (x, y, z) (v : Vec.t) t =
  let along c speed = if Rat.sign speed = 0 then c else Linear.add c (Linear.scale speed t) in
  (along x v.x, along y v.y, along z v.z)

let within set (x, y, z) =
  let at c = Constraint.substitute c ~dimension:(Linear.dimension x) [| x; y; z |] in
  List.map at (Polyhedron.constraints set)

let is_constant (x, y, z) = Linear.(is_constant x && is_constant y && is_constant z)
let eval (x, y, z) point = Vec.make (Linear.eval x point) (Linear.eval y point) (Linear.eval z point)
let map f (x, y, z) = (f x, f y, f z)
let coordinates (x, y, z) = [ x; y; z ]
let compose p ~dimension forms = map (fun f -> Linear.compose f ~dimension forms) p
