open Scc_base
open Scc_exact
open Scc_geometry

module type Number = sig
  type t

  val add : t -> t -> t
  val sub : t -> t -> t
  val mul : t -> t -> t
  val div : t -> t -> t
  val sign : t -> int
end

(* The point of a triangle that is nearest to another one, by the regions of corners, edges and the inside
   (Ericson, Real-Time Collision Detection, 5.1.5). *)
module Nearest (N : Number) = struct
  type point = { x : N.t; y : N.t; z : N.t }

  let sub a b = { x = N.sub a.x b.x; y = N.sub a.y b.y; z = N.sub a.z b.z }
  let dot a b = N.add (N.mul a.x b.x) (N.add (N.mul a.y b.y) (N.mul a.z b.z))

  let along a k v = { x = N.add a.x (N.mul k v.x); y = N.add a.y (N.mul k v.y); z = N.add a.z (N.mul k v.z) }

  let on_triangle a b c p =
    let ab = sub b a and ac = sub c a in
    let of_corner q =
      let v = sub p q in
      (dot ab v, dot ac v)
    in
    let d1, d2 = of_corner a and d3, d4 = of_corner b and d5, d6 = of_corner c in
    let at_most x y = N.sign (N.sub x y) <= 0 and low x = N.sign x <= 0 and high x = N.sign x >= 0 in
    let times a b c d = N.sub (N.mul a b) (N.mul c d) in
    let vc = times d1 d4 d3 d2 and vb = times d5 d2 d1 d6 and va = times d3 d6 d5 d4 in
    if low d1 && low d2 then a
    else if high d3 && at_most d4 d3 then b
    else if high d6 && at_most d5 d6 then c
    else if low vc && high d1 && low d3 then along a (N.div d1 (N.sub d1 d3)) ab
    else if low vb && high d2 && low d6 then along a (N.div d2 (N.sub d2 d6)) ac
    else if low va && at_most d3 d4 && at_most d6 d5 then
      let up = N.sub d4 d3 in
      along b (N.div up (N.add up (N.sub d5 d6))) (sub c b)
    else
      let all = N.add va (N.add vb vc) in
      along (along a (N.div vb all) ab) (N.div vc all) ac

  let distance2 a b c p =
    let v = sub (on_triangle a b c p) p in
    dot v v
end

(* A processor that multiplies and adds in one step would only guess another triangle. *)
module Guess = Nearest (struct
    include Float

    let sign x = if x > 0. then 1 else if x < 0. then -1 else 0
  end)

module Exact = Nearest (Rat)

let triangles (set : Polyhedron.ifs) =
  let fan (_, f) = List.init (Array.length f - 2) (fun k -> (f.(0), f.(k + 1), f.(k + 2))) in
  Array.of_list (List.concat_map fan (Array.to_list set.ifs_faces))

(* Balls around triangles, so that the triangles far away are passed over. *)
type balls = { xs : float array; ys : float array; zs : float array; radii : float array }

let balls near triangles =
  let third f = Array.map (fun (a, b, c) -> (f near.(a) +. f near.(b) +. f near.(c)) /. 3.) triangles in
  let xs = third (fun p -> p.Guess.x) and ys = third (fun p -> p.Guess.y) and zs = third (fun p -> p.Guess.z) in
  let radius k (a, b, c) =
    let middle = { Guess.x = xs.(k); y = ys.(k); z = zs.(k) } in
    let to_corner v = let w = Guess.sub near.(v) middle in sqrt (Guess.dot w w) in
    Float.max (to_corner a) (Float.max (to_corner b) (to_corner c))
  in
  { xs; ys; zs; radii = Array.mapi radius triangles }

(* The number for which [far], a squared distance, is the least, as near as floats tell. *)
let nearest balls (p : Guess.point) far =
  let px = p.x and py = p.y and pz = p.z in
  let found = ref 0 and squared = ref (far 0) in
  let least = ref (sqrt !squared) in
  for k = 1 to Array.length balls.radii - 1 do
    let x = balls.xs.(k) -. px and y = balls.ys.(k) -. py and z = balls.zs.(k) -. pz in
    if sqrt ((x *. x) +. (y *. y) +. (z *. z)) -. balls.radii.(k) < !least then begin
      let d = far k in
      if d < !squared then begin
        found := k;
        squared := d;
        least := sqrt d
      end
    end
  done;
  !found

let distance2 ~(hull : Polyhedron.ifs) (outer : Polyhedron.ifs) =
  let positions = Array.map snd hull.ifs_vertices in
  let whole, denominator = Ivec.of_vecs positions in
  let middle = positions.(0) in
  let guess v =
    let v = Vec.sub v middle in
    { Guess.x = Rat.to_float v.Vec.x; y = Rat.to_float v.y; z = Rat.to_float v.z }
  in
  let exact (v : Vec.t) = { Exact.x = v.x; y = v.y; z = v.z } in
  let near = Array.map guess positions and exactly = Array.map exact positions in
  let triangles = triangles hull in
  let balls = balls near triangles in
  let is_nearest x (y : Vec.t) =
    let w, _ = Ivec.of_vec (Vec.sub x y) in
    let limit = Rat.mul (Vec.dot (Ivec.to_vec w) y) (Rat.make denominator Z.one) in
    let limit = Rat.floor limit in
    Array.for_all (fun v -> Z.compare (Ivec.dot w v) limit <= 0) whole
  in
  let on (a, b, c) x =
    let y = Exact.on_triangle exactly.(a) exactly.(b) exactly.(c) (exact x) in
    Vec.make y.x y.y y.z
  in
  let of_corner x =
    let there = guess x in
    let far (a, b, c) = Guess.distance2 near.(a) near.(b) near.(c) there in
    let try_one t =
      let y = on t x in
      if is_nearest x y then Some (Vec.norm2 (Vec.sub x y)) else None
    in
    let by_distance = List.stable_sort (fun (a, _) (b, _) -> Float.compare a b) in
    match try_one triangles.(nearest balls there (fun k -> far triangles.(k))) with
    | Some d -> d
    | None -> (
        let all = by_distance (Array.to_list (Array.map (fun t -> (far t, t)) triangles)) in
        match List.find_map (fun (_, t) -> try_one t) all with
        | Some d -> d
        | None -> Bug.fail __POS__ "no point of a convex solid is nearest")
  in
  Array.fold_left (fun most (_, x) -> Rat.max most (of_corner x)) Rat.zero outer.ifs_vertices
