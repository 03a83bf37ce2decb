open Scc_exact

type floats = { x : float; y : float; z : float }

let floats (v : Vec.t) = { x = Rat.to_float v.x; y = Rat.to_float v.y; z = Rat.to_float v.z }

type t = {
  count : int;
  xs : float array;
  ys : float array;
  zs : float array;
  compass : Compass.t;
  low : floats;
  high : floats;
  reach : float;
  cx : float;
  cy : float;
  cz : float;
  inner : float;
  outer : float;
  centre : Ivec.t;
  centre_denominator : Z.t;
  usable : bool;
}

(* Within these bounds products of three differences of coordinates neither overflow nor, unless they are 0,
   fall to where floats are sparse. *)
let sane x = x = 0. || (Float.abs x < 0x1p120 && Float.abs x > 0x1p-120)

(* The squared distance from an inner point to a face with the normal n, over the squared denominators, is
   (n . (corner - centre))^2 / n.n. Floats of positive rationals are within 2^-53, so that quotient and root are
   within 2^-50 of theirs; 2^-40 covers that. *)
let narrow x = x *. (1. -. 0x1p-40)
let widen x = x *. (1. +. 0x1p-40)

let distance gap n =
  narrow (Rat.to_float gap /. sqrt (Rat.to_float (Rat.make (Ivec.dot n n) Z.one)))

let make vertices denominator ~centroid ~normals ~corners =
  let count = Array.length vertices in
  let float x = Rat.to_float (Rat.make x denominator) in
  let xs = Array.map (fun (v : Ivec.t) -> float v.x) vertices in
  let ys = Array.map (fun (v : Ivec.t) -> float v.y) vertices in
  let zs = Array.map (fun (v : Ivec.t) -> float v.z) vertices in
  let highest dx dy dz =
    let height i = (dx *. xs.(i)) +. (dy *. ys.(i)) +. (dz *. zs.(i)) in
    let best = ref 0 in
    for i = 1 to count - 1 do
      if height i > height !best then best := i
    done;
    !best
  in
  let compass = Compass.make ~count ~highest in
  let merge choose a = Array.fold_left choose a.(0) a in
  let low = { x = merge Float.min xs; y = merge Float.min ys; z = merge Float.min zs } in
  let high = { x = merge Float.max xs; y = merge Float.max ys; z = merge Float.max zs } in
  let { x = cx; y = cy; z = cz } = floats centroid in
  let all = Array.for_all sane in
  let sane = all xs && all ys && all zs && sane cx && sane cy && sane cz in
  if not sane then
    {
      count; xs; ys; zs; compass; low; high; reach = infinity; cx; cy; cz; inner = 0.; outer = infinity; centre = Ivec.zero;
      centre_denominator = Z.one; usable = false;
    }
  else
    let exact = Vec.make (Q.of_float cx) (Q.of_float cy) (Q.of_float cz) in
    let centre, centre_denominator = Ivec.of_vec exact in
    let position v = Vec.scale (Rat.make Z.one denominator) (Ivec.to_vec v) in
    let gap i n = Vec.dot (Ivec.to_vec n) (Vec.sub (position corners.(i)) exact) in
    let gaps = Array.mapi gap normals in
    let usable = Array.for_all (fun g -> Rat.sign g > 0) gaps in
    let nearest = ref infinity in
    Array.iteri (fun i g -> nearest := Float.min !nearest (distance g normals.(i))) gaps;
    let square v = Rat.to_float (Vec.norm2 (Vec.sub (position v) exact)) in
    let farthest = Array.fold_left (fun far v -> Float.max far (square v)) 0. vertices in
    let greatest = Array.fold_left (fun m x -> Float.max m (Float.abs x)) in
    let reach = greatest (greatest (greatest (greatest 0. [| cx; cy; cz |]) xs) ys) zs in
    {
      count; xs; ys; zs; compass; low; high; reach = widen reach; cx; cy; cz;
      inner = (if usable then !nearest else 0.);
      outer = widen (sqrt farthest);
      centre; centre_denominator; usable;
    }
