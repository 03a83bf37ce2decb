open Scc_exact

type floats = { x : float; y : float; z : float }

(* What is too small for a float is not to pass for 0. *)
let[@inline] float q =
  let x = Rat.near_float q in
  if x = 0. && Rat.sign q <> 0 then Float.nan else x

let floats (v : Vec.t) = { x = float v.x; y = float v.y; z = float v.z }

(* Of two sizes, without the calls by which Float.max tells zeros apart; the sum is for what is no number. *)
let[@inline] greater (x : float) y = if x > y then x else if y >= x then y else x +. y

let[@inline] greatest v = greater (Float.abs v.x) (greater (Float.abs v.y) (Float.abs v.z))

let[@inline] sane x = x = 0. || (Float.abs x < 0x1p120 && Float.abs x > 0x1p-120)

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

(* Floats of integers are within 2^-52 of them, a few operations add as much each; 2^-40 covers that. *)
let narrow x = x *. (1. -. 0x1p-40)
let widen x = x *. (1. +. 0x1p-40)

(* From an inner point to a face with the normal n: [gap] is n.(corner - point) times [scale]. What floats cannot
   hold gets the distance 0, or less than the true one. *)
let distance gap n scale =
  let gap = Z.to_float gap and length = sqrt (Z.to_float (Ivec.dot n n)) in
  if gap < infinity then narrow (gap /. (length *. Z.to_float scale)) else 0.

(* The highest vertex in a direction, up to rounding. *)
let highest (xs : float array) (ys : float array) (zs : float array) x y z =
  let best = ref 0 and height = ref neg_infinity in
  for i = 0 to Array.length xs - 1 do
    let h = (xs.(i) *. x) +. (ys.(i) *. y) +. (zs.(i) *. z) in
    if h > !height then begin
      best := i;
      height := h
    end
  done;
  !best

let make vertices denominator ~centroid ~normals ~corners =
  let count = Array.length vertices in
  let float x = float (Rat.make x denominator) in
  let xs = Array.map (fun (v : Ivec.t) -> float v.x) vertices in
  let ys = Array.map (fun (v : Ivec.t) -> float v.y) vertices in
  let zs = Array.map (fun (v : Ivec.t) -> float v.z) vertices in
  let compass = Compass.make ~count ~highest:(highest xs ys zs) in
  let merge choose a = Array.fold_left choose a.(0) a in
  let low = { x = merge Float.min xs; y = merge Float.min ys; z = merge Float.min zs } in
  let high = { x = merge Float.max xs; y = merge Float.max ys; z = merge Float.max zs } in
  let { x = cx; y = cy; z = cz } = floats centroid in
  let all = Array.for_all sane in
  if not (all xs && all ys && all zs && sane cx && sane cy && sane cz) then
    {
      count; xs; ys; zs; compass; low; high; reach = infinity; cx; cy; cz; inner = neg_infinity; outer = infinity;
      centre = Ivec.zero; centre_denominator = Z.one; usable = false;
    }
  else
    let exact = Vec.make (Q.of_float cx) (Q.of_float cy) (Q.of_float cz) in
    let centre, centre_denominator = Ivec.of_vec exact in
    let from_centre v = Ivec.sub (Ivec.scale centre_denominator v) (Ivec.scale denominator centre) in
    let scale = Z.mul denominator centre_denominator in
    let gaps = Array.mapi (fun i n -> Ivec.dot n (from_centre corners.(i))) normals in
    let usable = Array.for_all (fun g -> Z.sign g > 0) gaps in
    let inner = ref infinity in
    Array.iteri (fun i g -> inner := Float.min !inner (distance g normals.(i) scale)) gaps;
    let square v = Ivec.dot (from_centre v) (from_centre v) in
    let farthest = Array.fold_left (fun far v -> Z.max far (square v)) Z.zero vertices in
    let outer = widen (sqrt (Rat.to_float (Rat.make farthest (Z.mul scale scale)))) in
    let greatest = Array.fold_left (fun m x -> Float.max m (Float.abs x)) in
    let reach = greatest (greatest (greatest (greatest 0. [| cx; cy; cz |]) xs) ys) zs in
    {
      count; xs; ys; zs; compass; low; high; reach = widen reach; cx; cy; cz;
      inner = (if usable then !inner else neg_infinity); outer;
      centre; centre_denominator; usable;
    }
