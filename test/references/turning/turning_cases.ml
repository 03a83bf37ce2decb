open Scc_exact
open Scc_geometry
open Scc_rigid
module Naive = Scc_naive.Naive
module Turning = Scc_naive.Turning
module Guide = Scc_naive.Turning_guide
module Rng = Scc_long.Rng
module Data = Scc_test_data.Test_data

(* {1 Shapes} *)

type shape = { name : string; plain : Naive.solid; solids : Solid.t * Solid.t }

let shape name plain =
  { name; plain; solids = (Data.solid ~id:0 plain Mat.identity, Data.solid ~id:1 plain Mat.identity) }

let dyadic n k = Rat.make (Z.of_int n) (Z.shift_left Z.one k)

let box name x y z =
  let sign i bit = if (i lsr bit) land 1 = 0 then -1 else 1 in
  let corner i = Vec.make (dyadic (sign i 0 * x) 4) (dyadic (sign i 1 * y) 4) (dyadic (sign i 2 * z) 4) in
  shape name (Naive.hull (List.init 8 corner))

let cube = box "cube" 8 8 8

let hull seed =
  let g = Rng.make [ 7_654; seed ] in
  let rec points n found =
    if n = 0 then found
    else
      let c () = Rng.range g (-16) 16 in
      let x = c () in
      let y = c () in
      let z = c () in
      let length2 = (x * x) + (y * y) + (z * z) in
      if length2 < 180 || length2 > 256 then points n found
      else points (n - 1) (Vec.make (dyadic x 5) (dyadic y 5) (dyadic z 5) :: found)
  in
  shape ("hull" ^ string_of_int seed) (Naive.hull (points 10 []))

let tetrahedron =
  let v x y z = Vec.make (dyadic x 2) (dyadic y 2) (dyadic z 2) in
  shape "tetrahedron" (Naive.hull [ v 2 2 2; v 2 (-2) (-2); v (-2) 2 (-2); v (-2) (-2) 2 ])

let small =
  [| cube; cube; tetrahedron; hull 1; hull 2; box "plank" 12 6 1; box "pebble" 1 1 1; box "slab" 64 48 2 |]

let read path =
  let plain = Data.shape path in
  shape (Filename.basename path)
    { plain with points = Array.map (Vec.scale (dyadic 1 10)) plain.points }

(* {1 Cases} *)

type case = {
  shape_a : shape;
  shape_b : shape;
  a : Turning.body;
  b : Turning.body;
  span : Rat.t;
  grazes : bool;
}

let motion solid (b : Turning.body) =
  let w, x, y, z = b.turned in
  { Motion.solid;
    turned = Quaternion.of_rationals w (Vec.make x y z);
    arm = b.arm;
    centre = b.centre;
    velocity = b.velocity;
    spin = b.spin;
    since = b.since }

let motions c = (motion (fst c.shape_a.solids) c.a, motion (snd c.shape_b.solids) c.b)

let show c =
  let body name (shape : shape) (b : Turning.body) =
    let w, x, y, z = b.turned in
    Printf.sprintf "%s: %s turned (%s) arm %s centre %s velocity %s spin %s since %s" name shape.name
      (String.concat ", " (List.map Rat.to_string [ w; x; y; z ]))
      (Vec.to_string b.arm) (Vec.to_string b.centre) (Vec.to_string b.velocity) (Vec.to_string b.spin)
      (Rat.to_string b.since)
  in
  String.concat "; " [ body "a" c.shape_a c.a; body "b" c.shape_b c.b; "span " ^ Rat.to_string c.span ]

let without_spin c =
  { c with a = { c.a with spin = Vec.zero }; b = { c.b with spin = Vec.zero } }

type kind = Hit | Near_miss | Far | Chance | Grazing | Aligned | Peak

(* In three statements: the order in which arguments are evaluated is not fixed. *)
let triple f =
  let x = f () in
  let y = f () in
  let z = f () in
  (x, y, z)

let vec_of f =
  let x, y, z = triple f in
  Vec.make x y z

let quaternion g =
  let rec go () =
    let w = Rng.range g (-9) 9 in
    let x, y, z = triple (fun () -> Rng.range g (-9) 9) in
    if w = 0 && x = 0 && y = 0 && z = 0 then go ()
    else (Rat.of_int w, Rat.of_int x, Rat.of_int y, Rat.of_int z)
  in
  go ()

(* |spin| <= 1/2, of any length. *)
let rec spin g =
  let s = vec_of (fun () -> dyadic (Rng.range g (-512) 512) 10) in
  if Rat.compare (Vec.norm2 s) (dyadic 1 2) > 0 then spin g else s

let of_float bits x = Rat.make (Z.of_float (Float.round (ldexp x bits))) (Z.shift_left Z.one bits)
let vec_of_floats bits (x, y, z) = Vec.make (of_float bits x) (of_float bits y) (of_float bits z)
let unit_float g = float_of_int (Rng.below g (1 lsl 20)) /. 1048576.

let rec direction g =
  let x, y, z = triple (fun () -> (2. *. unit_float g) -. 1.) in
  let l = sqrt ((x *. x) +. (y *. y) +. (z *. z)) in
  if l < 0.1 || l > 1. then direction g else (x /. l, y /. l, z /. l)

let scaled k (x, y, z) = (k *. x, k *. y, k *. z)
let sum (x, y, z) (u, v, w) = (x +. u, y +. v, z +. w)

let across (x, y, z) (u, v, w) =
  let c = (x *. u) +. (y *. v) +. (z *. w) in
  let a, b, d = sum (u, v, w) (scaled (-.c) (x, y, z)) in
  let l = sqrt ((a *. a) +. (b *. b) +. (d *. d)) in
  if l < 1e-3 then (u, v, w) else (a /. l, b /. l, d /. l)

let radius shape =
  sqrt (Array.fold_left (fun m p -> Float.max m (Rat.to_float (Vec.norm2 p))) 0. shape.plain.points)

let coarse = 20

(* B passes A at the distance, mostly to the side of its way, at some time of the span; half of the velocity
   is A's. *)
let passing g shape_a shape_b ~distance ~finely =
  let way = direction g in
  let side = across way (direction g) in
  let travel = 0.25 +. (2.5 *. unit_float g) in
  let at = if Rng.chance g 4 then (1.2 *. unit_float g) -. 0.1 else 0.15 +. (0.7 *. unit_float g) in
  let velocity = vec_of_floats coarse (scaled (travel /. 2.) way) in
  let base = vec_of (fun () -> dyadic (Rng.range g (-64) 64) 4) in
  let from = sum (scaled (-.at *. travel) way) (scaled distance side) in
  let body turned centre velocity spin =
    { Turning.solid = shape_a.plain; turned; arm = Vec.zero; centre; velocity; spin; since = Rat.zero }
  in
  let drift = vec_of (fun () -> dyadic (Rng.range g (-16) 16) 6) in
  let turned_a = quaternion g in
  let spin_a = spin g in
  let turned_b = quaternion g in
  let spin_b = spin g in
  let a = body turned_a base (Vec.sub drift velocity) spin_a in
  let b = body turned_b (Vec.add base (vec_of_floats coarse from)) (Vec.add drift velocity) spin_b in
  let c = { shape_a; shape_b; a; b = { b with solid = shape_b.plain }; span = Rat.one; grazes = false } in
  if not finely then c
  else
    (* Turned for a while already, about another point; a part of the span. *)
    let since = dyadic (Rng.below g 17) 5 in
    let reach = Rng.choose g [| 8; 40 |] in
    let arm () = vec_of (fun () -> dyadic (Rng.range g (-reach) reach) 5) in
    let arm_a = arm () in
    let arm_b = arm () in
    { c with
      a =
        { c.a with
          since = (if Rng.chance g 2 then since else Rat.zero);
          arm = arm_a;
          centre = Vec.sub c.a.centre arm_a };
      b = { c.b with since; arm = arm_b; centre = Vec.sub c.b.centre arm_b };
      span = Rat.sub Rat.one (dyadic (Rng.choose g [| 0; 16; 16; 24 |]) 5) }

(* The same seen from elsewhere, or with thirds in the velocities: longer numbers, less from floats. *)
let disguised g c =
  let both f = { c with a = f c.a; b = f c.b } in
  match Rng.below g 6 with
  | 0 ->
    let far = Vec.of_ints (1 lsl Rng.range g 10 60) (1 lsl Rng.range g 10 60) 12_345_679 in
    both (fun b -> { b with centre = Vec.add b.centre far })
  | 1 ->
    let third = vec_of (fun () -> Rat.make (Z.of_int (Rng.range g (-3) 3)) (Z.of_int 3)) in
    both (fun b -> { b with velocity = Vec.add b.velocity third })
  | 2 ->
    let much = Vec.of_ints (1 lsl Rng.range g 1 40) (-7) 5 in
    both (fun b -> { b with velocity = Vec.add b.velocity much })
  | _ -> c

let displaced c v = { c with b = { c.b with centre = Vec.add c.b.centre v } }
let guide c = Turning.guide c.a c.b ~span:c.span

let rec sorted_out g kind shape_a shape_b =
  let r = radius shape_a +. radius shape_b in
  let again () = sorted_out g kind shape_a shape_b in
  let try_at distance accept =
    let c = passing g shape_a shape_b ~distance ~finely:false in
    let f = guide c in
    let gap = Guide.faces_gap f in
    if gap 0. > 0.01 && accept (lazy (snd (Guide.least gap))) then c else again ()
  in
  match kind with
  | Hit -> try_at (0.7 *. r *. unit_float g) (fun least -> Lazy.force least < -0.01)
  | Near_miss ->
    try_at (r *. (0.5 +. (0.6 *. unit_float g))) (fun least ->
        let least = Lazy.force least in
        least > 0. && least < 1. /. 6.)
  | _ -> try_at (r *. (1.2 +. (3. *. unit_float g))) (fun least -> Lazy.force least > 0.25)

(* The distance to the side is set so that the widest gap is zero when they are closest, and then a little more or
   less. *)
let rec grazing g shape_a shape_b =
  let finely = Rng.chance g 3 in
  let c = passing g shape_a shape_b ~distance:0. ~finely in
  let dx, dy, dz = direction g in
  let at l = displaced c (vec_of_floats 50 (scaled l (dx, dy, dz))) in
  let least l = snd (Guide.least (Guide.gap (guide (at l)))) in
  let far = 2. *. (radius shape_a +. radius shape_b) +. 1. in
  let rec bisect lo hi n =
    if n = 0 then (lo, hi)
    else
      let l = (lo +. hi) /. 2. in
      if least l < 0. then bisect l hi (n - 1) else bisect lo l (n - 1)
  in
  (* The least gap grows with the distance where they touch, about linearly: secants, from a rough bracket. *)
  let lo, hi = bisect 0. far 12 in
  let rec secant l0 f0 l1 f1 n =
    if n = 0 || Float.abs f1 < 1e-15 || f1 = f0 then (l1, (f1 -. f0) /. (l1 -. l0))
    else
      let l2 = l1 -. (f1 *. (l1 -. l0) /. (f1 -. f0)) in
      let l2 = Float.max lo (Float.min hi l2) in
      if l2 = l1 then (l1, (f1 -. f0) /. (l1 -. l0)) else secant l1 f1 l2 (least l2) (n - 1)
  in
  let l, slope = secant lo (least lo) hi (least hi) 8 in
  if not (Float.abs (least l) < 1e-12 && slope > 0.05 && slope < 2.) then grazing g shape_a shape_b
  else
    let nearer = if Rng.chance g 2 then Rng.range g 4 12 else Rng.range g 12 40 in
    let depth = ldexp (if Rng.chance g 3 then 1. else -1.) (-nearer) in
    at (l +. (depth /. slope))

let aligned g shape_a shape_b =
  let turns =
    [| (1, 0, 0, 0); (1, 0, 0, 0); (1, 1, 0, 0); (1, 0, 0, 1); (0, 1, 1, 0); (3, 0, 0, 1); (2, 1, 0, 0) |]
  in
  let q = Rng.choose g turns in
  let exact (w, x, y, z) = (Rat.of_int w, Rat.of_int x, Rat.of_int y, Rat.of_int z) in
  let along () =
    let s = dyadic (Rng.choose g [| 0; 1; -1; 2; -2 |]) 2 in
    Rng.choose g
      [| Vec.make s Rat.zero Rat.zero; Vec.make Rat.zero s Rat.zero; Vec.make Rat.zero Rat.zero s; Vec.zero |]
  in
  let spin_a = along () in
  let spin_b = if Rng.chance g 3 then spin_a else along () in
  let steps = Rng.choose g [| 0; 0; 1; 2 |] in
  let small k = vec_of (fun () -> dyadic (Rng.range g (-k) k) 2) in
  let velocity = if steps = 0 then Vec.zero else small steps in
  (* Face to face, edge to edge, corner to corner, for a cube; a step of 1/4 apart, or none. *)
  let offset =
    let c = dyadic (Rng.choose g [| 4; 4; 4; 5; 6 |]) 2 in
    let slide () = dyadic (Rng.choose g [| 0; 1; 2; 4; -3 |]) 2 in
    let x, y, z = triple slide in
    Rng.choose g [| Vec.make c y z; Vec.make x c z; Vec.make x y (Rat.neg c) |]
  in
  let turned_b =
    if Rng.chance g 3 then quaternion g else exact (Rng.choose g [| q; q; (1, 0, 0, 0); (1, 0, 1, 0) |])
  in
  let body solid turned centre velocity spin =
    { Turning.solid; turned; arm = Vec.zero; centre; velocity; spin; since = Rat.zero }
  in
  let b = body shape_b.plain turned_b offset velocity spin_b in
  (* Half of the time about a corner or so, which may be what touches. *)
  let b = if Rng.chance g 2 then b else { b with arm = small 2; since = dyadic (Rng.below g 2) 1 } in
  let a = body shape_a.plain (exact q) Vec.zero (if Rng.chance g 4 then velocity else Vec.zero) spin_a in
  { shape_a; shape_b; a; b; span = (if Rat.sign b.since = 0 then Rat.one else dyadic 1 1); grazes = false }

(* At an instant [at] a corner of B is straight below the centre that B turns about, and so as low as it can be,
   over the top of A, which is level and stays so. *)
let rec peak g shape_b =
  let w, x, y, z = quaternion g in
  let then_turned = Quaternion.of_rationals w (Vec.make x y z) in
  let corners = Array.map (Quaternion.apply then_turned) shape_b.plain.points in
  let by_height (p : Vec.t) (q : Vec.t) = Rat.compare p.z q.z in
  let sorted = List.sort by_height (Array.to_list corners) in
  let spin_b = spin g in
  let level = Rat.sign spin_b.x = 0 && Rat.sign spin_b.y = 0 in
  match sorted with
  | lowest :: next :: _ when by_height lowest next < 0 && not level ->
    let ratio p q = Rat.make (Z.of_int p) (Z.of_int q) in
    let at = Rng.choose g [| ratio 1 2; ratio 1 3; ratio 2 5; ratio 5 8 |] in
    let height = dyadic (Rng.range g 1 16) 3 in
    let off =
      match Rng.below g 3 with
      | 0 -> Rat.zero
      | 1 -> dyadic 1 (Rng.range g 8 50)
      | _ -> Rat.neg (dyadic 1 (Rng.range g 8 50))
    in
    let back = Quaternion.inverse (Quaternion.cayley (Vec.scale (Rat.mul at (dyadic 1 1)) spin_b)) in
    let arm = Quaternion.apply back (Vec.sub (Vec.make Rat.zero Rat.zero (Rat.neg height)) lowest) in
    let start = Quaternion.mul back then_turned in
    let over () = dyadic (Rng.range g (-4) 4) 4 in
    let over_x = over () in
    let over_y = over () in
    let common = vec_of (fun () -> dyadic (Rng.range g (-8) 8) 3) in
    let along_x = over () in
    let along_y = over () in
    let velocity = Vec.add common (Vec.make along_x along_y Rat.zero) in
    let top = Vec.add (Vec.scale at common) (Vec.make over_x over_y (Rat.add (dyadic 1 1) (Rat.add height off))) in
    let rat z = Rat.make z Z.one in
    let b =
      { Turning.solid = shape_b.plain;
        turned = (rat start.w, rat start.x, rat start.y, rat start.z);
        arm;
        centre = Vec.sub top (Vec.scale at velocity);
        velocity;
        spin = spin_b;
        since = Rat.zero }
    in
    let turn = Rng.range g (-3) 3 in
    let spin_a = Vec.make Rat.zero Rat.zero (dyadic (Rng.range g (-4) 4) 3) in
    let a =
      { Turning.solid = cube.plain;
        turned = (Rat.of_int 3, Rat.zero, Rat.zero, Rat.of_int turn);
        arm = Vec.zero;
        centre = Vec.zero;
        velocity = common;
        spin = spin_a;
        since = Rat.zero }
    in
    { shape_a = cube; shape_b; a; b; span = Rat.one; grazes = Rat.sign off = 0 }
  | _ -> peak g shape_b

let make kind shape_a shape_b g =
  match kind with
  | Hit | Near_miss | Far -> sorted_out g kind shape_a shape_b
  | Chance ->
    let distance = 1.3 *. (radius shape_a +. radius shape_b) *. unit_float g in
    disguised g (passing g shape_a shape_b ~distance ~finely:(Rng.chance g 2))
  | Grazing -> disguised g (grazing g shape_a shape_b)
  | Aligned -> disguised g (aligned g shape_a shape_b)
  | Peak -> disguised g (peak g shape_b)
