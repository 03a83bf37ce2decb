open Scc_exact
module Naive = Scc_naive.Naive
module Fast = Scc_naive.Fast

type pair = {
  a : Naive.solid;
  b : Naive.solid;
  fast : Fast.t;
  normals : Ivec.t array;
  centre : Vec.t;
  extent : Vec.t;
}

type case = { kind : string; r : Vec.t; w : Vec.t; known : Naive.cast option }

let mean points =
  let n = Rat.make Z.one (Z.of_int (List.length points)) in
  Vec.scale n (List.fold_left Vec.add Vec.zero points)

let pair (a : Naive.solid) (b : Naive.solid) fast =
  let points (s : Naive.solid) = Array.to_list s.points in
  let spread (s : Naive.solid) coordinate =
    let cs = List.map coordinate (points s) in
    let least = List.fold_left Rat.min (List.hd cs) cs in
    Rat.sub (List.fold_left Rat.max least cs) least
  in
  let extent coordinate = Rat.add (spread a coordinate) (spread b coordinate) in
  let extent = Vec.make (extent (fun v -> v.Vec.x)) (extent (fun v -> v.y)) (extent (fun v -> v.z)) in
  let centre = Vec.sub (mean (points a)) (mean (points b)) in
  { a; b; fast; normals = Fast.facets fast; centre; extent }

let ten k = Rat.make (Z.pow (Z.of_int 10) k) Z.one
let tenth k = Rat.div Rat.one (ten k)

let quotient g ?(under = 7) k =
  let n = Rng.positive g k in
  Rat.make n (Rng.positive g under)

(* {1 By chance} *)

(* Up to so many extents from the centre along each axis. *)
let around g p reach =
  let along extent = Rat.mul (Rat.mul extent (Rat.of_int reach)) (Rng.fraction g 97) in
  let x = along p.extent.x in
  let y = along p.extent.y in
  Vec.add p.centre (Vec.make x y (along p.extent.z))

(* A point inside, often near the boundary. *)
let inside g p =
  let difference () =
    let x = Rng.choose g p.a.points in
    Vec.sub x (Rng.choose g p.b.points)
  in
  let corner = mean (List.init (Rng.range g 1 4) (fun _ -> difference ())) in
  Vec.axpy (Rat.abs (Rng.fraction g 97)) (Vec.sub corner p.centre) p.centre

let direction g p = Vec.sub (around g p 1) p.centre

(* A factor for the velocity, which divides all times. *)
let stretch g =
  match Rng.below g 12 with
  | 0 -> ten (Rng.range g 1 40)
  | 1 -> tenth (Rng.range g 1 40)
  | 2 -> quotient g 300 ~under:300
  | 3 ->
    let k = if Rng.chance g 8 then 400 else Rng.range g 1 160 in
    if Rng.chance g 2 then ten k else tenth k
  | 4 | 5 -> quotient g 7
  | _ -> Rat.one

let far g =
  if Rng.chance g 10 then ten (if Rng.chance g 2 then 320 else Rng.range g 30 160)
  else Rng.choose g [| ten 9; ten 18; ten 40; Rat.make (Rng.positive g 62) Z.one |]

let random g p =
  let case kind r w = { kind; r; w = Vec.scale (stretch g) w; known = None } in
  (* through a place in reach, mostly inside, from [t] velocities before it *)
  let aimed kind t w =
    let target = if Rng.chance g 4 then around g p 1 else inside g p in
    case kind (Vec.axpy (Rat.neg t) w target) w
  in
  match Rng.below g 10 with
  | 0 | 1 ->
    let r = around g p 2 in
    case "random: any line" r (Vec.sub (around g p 1) r)
  | 2 | 3 | 4 ->
    let t = quotient g 7 in
    aimed "random: aimed" t (direction g p)
  | 5 ->
    let r = inside g p in
    case "random: from inside" r (direction g p)
  | 6 ->
    let t = far g in
    aimed "random: from far away" t (direction g p)
  | 7 -> case "random: at rest" (if Rng.chance g 3 then inside g p else around g p 1) Vec.zero
  | 8 ->
    let t = quotient g 7 in
    let fine = Rat.make Z.one (Rng.positive g 200) in
    aimed "random: long numbers" (Rat.div t fine) (Vec.scale fine (direction g p))
  | _ ->
    let r = around g p 1 in
    case "random: integers" r (Rng.vector g 3)

(* {1 Degenerate} *)

(* A face of the difference, by the corners of A and B whose differences span it. *)
type face = { normal : Vec.t; of_a : Vec.t list; of_b : Vec.t list }

let facet g p =
  let n = Rng.choose g p.normals in
  let ia, ib = Fast.support p.fast n in
  { normal = Ivec.to_vec n;
    of_a = List.map (Array.get p.a.points) ia;
    of_b = List.map (Array.get p.b.points) ib }

let extreme choose d points =
  let heights = List.map (Vec.dot d) points in
  let top = List.fold_left choose (List.hd heights) heights in
  List.filter (fun x -> Rat.equal (Vec.dot d x) top) points

(* The face of a face that is highest in a direction. *)
let sub_face d f = { f with of_a = extreme Rat.max d f.of_a; of_b = extreme Rat.min d f.of_b }
let pick g list = List.nth list (Rng.below g (List.length list))

(* A side of one of the two faces or a chord of it, with a sign; zero if both are points. *)
let side g f =
  let longer = match f.of_a with [ _ ] -> f.of_b | _ -> if Rng.chance g 2 then f.of_a else f.of_b in
  let x = pick g longer in
  Vec.sub (pick g longer) x

let tangent g f = Vec.cross f.normal (Rng.vector g 5)

(* Dimension 2, 1 or 0, as far as the corners met by chance allow. *)
let face g p =
  let f = facet g p in
  match Rng.below g 3 with
  | 0 -> f
  | 1 -> sub_face (Vec.cross f.normal (side g f)) f
  | _ -> sub_face (tangent g f) f

(* In the relative interior of the hull of points. *)
let within g points =
  let weights = List.map (fun x -> (x, Rat.of_int (if Rng.chance g 2 then 1 else Rng.range g 1 7))) points in
  let total = List.fold_left (fun s (_, k) -> Rat.add s k) Rat.zero weights in
  List.fold_left (fun s (x, k) -> Vec.axpy (Rat.div k total) x s) Vec.zero weights

let on g f =
  let a = within g f.of_a in
  Vec.sub a (within g f.of_b)

(* The velocities of lines through a point of the boundary. *)
type course = Entering | Leaving | In_plane | Along_side | Chord | Any | Still

let name = function
  | Entering -> "entering"
  | Leaving -> "leaving"
  | In_plane -> "in a facet's plane"
  | Along_side -> "along an edge"
  | Chord -> "through two faces"
  | Any -> "any line"
  | Still -> "at rest"

let courses = [| Entering; Entering; Leaving; In_plane; In_plane; Along_side; Chord; Chord; Any; Still |]

let velocity g p f point = function
  | Entering -> Vec.sub p.centre point
  | Leaving -> Vec.sub point p.centre
  | In_plane -> tangent g f
  | Along_side -> side g f
  | Chord -> Vec.sub (on g (face g p)) point
  | Any -> direction g p
  | Still -> Vec.zero

(* How long before the point the line starts. *)
let lead g =
  match Rng.below g 8 with
  | 0 | 1 -> Rat.zero
  | 2 -> Rat.neg (quotient g 5)
  | 3 -> far g
  | 4 -> Rat.one
  | _ -> quotient g 7

(* The cast where no perturbation follows. *)
let known course t : Naive.cast option =
  match course with
  | Entering when Rat.sign t >= 0 -> Some (At t)
  | Leaving when Rat.sign t <= 0 -> Some Never
  | Leaving when Rat.compare t Rat.one < 0 -> Some Inside
  | In_plane | Along_side | Still -> Some Never
  | Entering | Leaving | Chord | Any -> None

let hair g =
  if Rng.chance g 20 then tenth (if Rng.chance g 2 then 330 else Rng.range g 30 160)
  else tenth (Rng.range g 1 36)

(* A step off the exact place: the offset along the normal, the offset anywhere, or the velocity. *)
let perturb g p f r w =
  let e = hair g in
  let e = if Rng.chance g 2 then Rat.neg e else e in
  let largest (n : Vec.t) = Rat.max (Rat.abs n.x) (Rat.max (Rat.abs n.y) (Rat.abs n.z)) in
  match Rng.below g 4 with
  | 0 -> (Vec.axpy (Rat.div e (largest f.normal)) f.normal r, w)
  | 1 -> (Vec.axpy e (direction g p) r, w)
  | 2 -> (r, Vec.axpy e (direction g p) w)
  | _ ->
    let r = Vec.axpy e (direction g p) r in
    let e = hair g in
    (r, Vec.axpy e (Rng.vector g 3) w)

let degenerate g p =
  let f = face g p in
  let point = on g f in
  let course = Rng.choose g courses in
  let w = velocity g p f point course in
  let t = lead g in
  let r = Vec.axpy (Rat.neg t) w point in
  let factor = stretch g in
  let scaled : Naive.cast -> Naive.cast = function At t -> At (Rat.div t factor) | (Never | Inside) as c -> c in
  if Rng.chance g 3 then
    let r, w = perturb g p f r w in
    { kind = name course ^ ", off by a hair"; r; w = Vec.scale factor w; known = None }
  else { kind = name course; r; w = Vec.scale factor w; known = Option.map scaled (known course t) }
