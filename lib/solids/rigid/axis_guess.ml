open Scc_exact
open Scc_geometry

(* A solid in its own frame, about the centre of its motion; vectors are three floats each, one after another. *)
type body = {
  solid : Solid.t;
  points : float array;
  normals : float array;  (* of length 1 *)
  heights : float array;  (* of the planes of the faces *)
  edges : float array;  (* of length 1 *)
  turn : float array * float array;  (* the quaternion: constant and linear coefficients *)
}

(* The two at an instant s. B is seen from the frame and the centre of A, and the other way round. *)
type sample = {
  points_b : float array Lazy.t;
  points_a : float array Lazy.t;
  edges_b : float array Lazy.t;
  edges_a : float array Lazy.t;
  error : float;  (* bounds those of conditions that are lengths *)
  sign_error : float;  (* and of those between directions *)
}

type t = {
  a : body;
  b : body;
  apart : float array * float array;
  size : float;
  speed : float;  (* bounds the rate at which a condition that is a length changes with s *)
  turning : float;  (* and a condition between directions *)
  samples : sample Lazy.t array;  (* in the middle of as many equal parts of [0, 1] *)
}

(* Integers as floats, each within 2^-52 of the greatest of them in proportion: common powers of two are left
   out where they would be too great. *)
let floats zs =
  let bits = Array.fold_left (fun m z -> Int.max m (Z.numbits z)) 0 zs in
  let drop = Int.max 0 (bits - 400) in
  Array.map (fun z -> Z.to_float (Z.shift_right z drop)) zs

(* [n/d] within 2^-50, relatively, or of no use: infinite, 0 or not a number. *)
let quotients ns d =
  let bits = Array.fold_left (fun m z -> Int.max m (Z.numbits z)) (Z.numbits d) ns in
  if bits <= 900 then
    let d = Z.to_float d in
    Array.map (fun n -> Z.to_float n /. d) ns
  else Array.map (fun n -> Rat.near_float (Rat.make n d)) ns

let flat vs = Array.concat (List.map (fun (v : Ivec.t) -> [| v.x; v.y; v.z |]) (Array.to_list vs))

let unit_vectors vs =
  let one (v : Ivec.t) =
    let f = floats [| v.x; v.y; v.z |] in
    let length = sqrt ((f.(0) *. f.(0)) +. (f.(1) *. f.(1)) +. (f.(2) *. f.(2))) in
    Array.map (fun c -> c /. length) f
  in
  Array.concat (List.map one (Array.to_list vs))

let dot u i v j = (u.(i) *. v.(j)) +. (u.(i + 1) *. v.(j + 1)) +. (u.(i + 2) *. v.(j + 2))
let corner (s : Solid.t) f = (snd s.polyhedron.faces.(f)).(0)

let body (m : Motion.t) points denominator turn =
  let points = quotients (flat points) denominator in
  let normals = unit_vectors m.solid.normals in
  let height f = dot normals (3 * f) points (3 * corner m.solid f) in
  let coefficient i q = if i < Array.length q then q.(i) else Z.zero in
  let turn = floats (Array.append (Array.map (coefficient 0) turn) (Array.map (coefficient 1) turn)) in
  {
    solid = m.solid;
    points;
    normals;
    heights = Array.init (Array.length m.solid.normals) height;
    edges = unit_vectors m.solid.directions;
    turn = (Array.sub turn 0 4, Array.sub turn 4 4);
  }

(* The rotation, by rows, and how much its quaternion loses to cancellation. *)
let rotation b s =
  let c, d = b.turn in
  let q = Array.init 4 (fun i -> c.(i) +. (s *. d.(i))) in
  let all = Array.fold_left (fun sum x -> sum +. Float.abs x) in
  let w = q.(0) and x = q.(1) and y = q.(2) and z = q.(3) in
  let n = (w *. w) +. (x *. x) +. (y *. y) +. (z *. z) in
  let k = 2. /. n in
  ( [| 1. -. (k *. ((y *. y) +. (z *. z))); k *. ((x *. y) -. (w *. z)); k *. ((x *. z) +. (w *. y));
       k *. ((x *. y) +. (w *. z)); 1. -. (k *. ((x *. x) +. (z *. z))); k *. ((y *. z) -. (w *. x));
       k *. ((x *. z) -. (w *. y)); k *. ((y *. z) +. (w *. x)); 1. -. (k *. ((x *. x) +. (y *. y))) |],
    all (all 0. c) d /. sqrt n )

let transpose m = Array.init 9 (fun i -> m.((3 * (i mod 3)) + (i / 3)))

(* m x for all x, and an offset. *)
let image m offset xs =
  let out = Array.make (Array.length xs) 0. in
  for k = 0 to (Array.length xs / 3) - 1 do
    for i = 0 to 2 do
      out.((3 * k) + i) <- dot m (3 * i) xs (3 * k) +. offset.(i)
    done
  done;
  out

let origin = [| 0.; 0.; 0. |]

(* The errors, with e = 2^-53, G = [size] and k = k_A + k_B for what [rotation] gives. G bounds the sum of the
   greatest coordinates of vertices of A, of B, and of the way between the centres.

   A component of a quaternion q is computed within 8 e (|c| + |d|), hence q within 16 e k |q| as a vector, and
   a rotation turns by at most twice the angle between quaternions: the entries of the matrix are within 2^-47
   k, and the formulas add less than 2^-48. The product of two has entries within 2^-44 k, the way between the
   centres, turned, is within 2^-44 k G, and vertices seen from the other solid are within 2^-42 k G, with
   coordinates of at most 4 G. Unit vectors are within 2^-50 to begin with, and turned ones within 2^-43 k.
   Conditions on directions are three products: within 2^-40 k. Conditions of faces are a product of a vector
   within 2^-50 and one within 2^-42 k G, less the height: within 2^-39 k G. The product of two edges is within
   2^-41 k, and a difference of vertices of at most 5 G within 2^-41 k G: the condition 0 of edges is within
   2^-36 k G.

   Sizes that are out of the common give infinite or undefined bounds, under which nothing is proved. *)
let sample ~a ~b ~size (c, d) s =
  let ra, ka = rotation a s and rb, kb = rotation b s in
  let inverse = transpose ra in
  let turned = Array.make 9 0. in
  for i = 0 to 2 do
    for j = 0 to 2 do
      turned.((3 * i) + j) <-
        (ra.(i) *. rb.(j)) +. (ra.(3 + i) *. rb.(3 + j)) +. (ra.(6 + i) *. rb.(6 + j))
    done
  done;
  let apart = image inverse origin (Array.init 3 (fun i -> c.(i) +. (s *. d.(i)))) in
  let back = transpose turned in
  let to_a = image back origin (Array.map Float.neg apart) in
  let k = ka +. kb in
  {
    points_b = lazy (image turned apart b.points);
    points_a = lazy (image back to_a a.points);
    edges_b = lazy (image turned origin b.edges);
    edges_a = lazy (image back origin a.edges);
    error = (if size > 0x1p-500 && size < 0x1p300 then 0x1p-36 *. k *. size else infinity);
    sign_error = 0x1p-40 *. k;
  }

let at g s = sample ~a:g.a ~b:g.b ~size:g.size g.apart s
let greatest = Array.fold_left (fun m x -> Float.max m (Float.abs x)) 0.

(* At least the length. *)
let above (v : Vec.t) = Float_box.(up (Rat.abs v.x) +. up (Rat.abs v.y) +. up (Rat.abs v.z))

(* The unit normal of an axis turns with its solid at a rate of at most |spin|, and the product of two unit edges
   changes by at most the sum of both rates; a vertex of B as seen from one of A moves by at most |c'| +
   |spin_A| sqrt 3 G + |spin_B| sqrt 3 G, and is at most 2 sqrt 3 G away. *)
let make (p : Axis.pair) =
  let a = body p.a p.points_a p.denominator p.turn_a in
  let b = body p.b p.points_b p.denominator p.turn_b in
  let start, way = p.apart in
  let apart = quotients (flat [| start; way |]) p.denominator in
  let apart = (Array.sub apart 0 3, Array.sub apart 3 3) in
  let size = greatest a.points +. greatest b.points +. greatest (fst apart) +. greatest (snd apart) in
  let size = size *. (1. +. 0x1p-40) in
  let rate v = above (Vec.scale p.length v) *. (1. +. 0x1p-40) in
  let turning = (rate p.a.spin +. rate p.b.spin) *. (1. +. 0x1p-40) in
  let speed = (rate (Vec.sub p.b.velocity p.a.velocity) +. (6. *. size *. turning)) *. (1. +. 0x1p-40) in
  let count = if turning < 0x1p-10 then 1 else 8 in
  let middle i = (float_of_int i +. 0.5) /. float_of_int count in
  let samples = Array.init count (fun i -> lazy (sample ~a ~b ~size apart (middle i))) in
  { a; b; apart; size; speed; turning; samples }

(* A condition, its vectors of length 1; between edges, the cross product is left as it is. *)
let value g st axis k =
  match (axis : Axis.t) with
  | Face_a f -> dot g.a.normals (3 * f) (Lazy.force st.points_b) (3 * k) -. g.a.heights.(f)
  | Face_b f -> dot g.b.normals (3 * f) (Lazy.force st.points_a) (3 * k) -. g.b.heights.(f)
  | Edges x ->
    let ea = g.a.solid.topology.edges.(x.a) and eb = g.b.solid.topology.edges.(x.b) in
    let v =
      match k with
      | 0 ->
        let e = g.a.edges and f = Lazy.force st.edges_b and i = 3 * x.a and j = 3 * x.b in
        let p = Lazy.force st.points_b and q = g.a.points and m = 3 * eb.tail and n = 3 * ea.tail in
        (((e.(i + 1) *. f.(j + 2)) -. (e.(i + 2) *. f.(j + 1))) *. (p.(m) -. q.(n)))
        +. (((e.(i + 2) *. f.(j)) -. (e.(i) *. f.(j + 2))) *. (p.(m + 1) -. q.(n + 1)))
        +. (((e.(i) *. f.(j + 1)) -. (e.(i + 1) *. f.(j))) *. (p.(m + 2) -. q.(n + 2)))
      | 1 -> dot g.a.normals (3 * ea.left) (Lazy.force st.edges_b) (3 * x.b)
      | 2 -> -.dot g.a.normals (3 * ea.right) (Lazy.force st.edges_b) (3 * x.b)
      | 3 -> dot g.b.normals (3 * eb.left) (Lazy.force st.edges_a) (3 * x.a)
      | _ -> -.dot g.b.normals (3 * eb.right) (Lazy.force st.edges_a) (3 * x.a)
    in
    if x.positive then v else -.v

let is_length (axis : Axis.t) k = match axis with Face_a _ | Face_b _ -> true | Edges _ -> k = 0

(* What a condition may differ by from its value in a sample at most [radius] away. *)
let doubt g st axis k radius =
  if is_length axis k then (st.error +. (g.speed *. radius)) *. (1. +. 0x1p-40)
  else (st.sign_error +. (g.turning *. radius)) *. (1. +. 0x1p-40)

let conditions g (axis : Axis.t) =
  match axis with
  | Face_a _ -> Array.length g.b.points / 3
  | Face_b _ -> Array.length g.a.points / 3
  | Edges _ -> 5

(* The part of [0, 1] that an instant is in, or the one before. *)
let part g low =
  let n = Array.length g.samples in
  Int.max 0 (Int.min (n - 1) (int_of_float (Float.floor ((Rat.near_float low -. 0x1p-40) *. float_of_int n))))

let holds g axis k ~low =
  let n = Array.length g.samples in
  let radius = 0.5 /. float_of_int n in
  let rec all i =
    i = n
    ||
    let st = Lazy.force g.samples.(i) in
    value g st axis k > doubt g st axis k radius && all (i + 1)
  in
  all (part g low)

(* Whether no condition is proved to fail within the radius of the sample. *)
let possible g st radius axis =
  let n = conditions g axis in
  let rec all k = k = n || ((not (value g st axis k < -.doubt g st axis k radius)) && all (k + 1)) in
  all 0

let least g st axis =
  let rec fold k m = if k < 0 then m else fold (k - 1) (Float.min m (value g st axis k)) in
  fold (conditions g axis - 1) infinity

(* Bits 1 and 2 of entry (i, f): whether normal f may be at 0 or above, or at 0 or below, along edge i. *)
let signs edges normals doubt =
  let m = Array.length edges / 3 and n = Array.length normals / 3 in
  let out = Array.init m (fun _ -> Bytes.create n) in
  for i = 0 to m - 1 do
    for f = 0 to n - 1 do
      let d = dot edges (3 * i) normals (3 * f) in
      let code = (if d < -.doubt then 0 else 1) lor if d > doubt then 0 else 2 in
      Bytes.unsafe_set out.(i) f (Char.unsafe_chr code)
    done
  done;
  out

let possible_edges g st radius =
  let doubt_of_signs = (st.sign_error +. (g.turning *. radius)) *. (1. +. 0x1p-40) in
  let along_b = signs (Lazy.force st.edges_b) g.a.normals doubt_of_signs in
  let along_a = signs (Lazy.force st.edges_a) g.b.normals doubt_of_signs in
  let code row f = Char.code (Bytes.get row f) in
  let swap c = ((c land 1) lsl 1) lor (c lsr 1) in
  let found = ref [] in
  Array.iteri
    (fun i (ea : Topology.edge) ->
       let row = along_a.(i) in
       Array.iteri
         (fun j (eb : Topology.edge) ->
            let other = along_b.(j) in
            let both =
              code other ea.left land swap (code other ea.right)
              land code row eb.left land swap (code row eb.right)
            in
            if both <> 0 then begin
              let add positive =
                let axis = Axis.Edges { a = i; b = j; positive } in
                if not (value g st axis 0 < -.doubt g st axis 0 radius) then found := axis :: !found
              in
              if both land 1 <> 0 then add true;
              if both land 2 <> 0 then add false
            end)
         g.b.solid.topology.edges)
    g.a.solid.topology.edges;
  !found

(* In how many parts from the start on an axis seems to separate, and how clearly it does now. *)
let promise g st start axis =
  let n = Array.length g.samples in
  let rec lasting i = if i < n && least g (Lazy.force g.samples.(i)) axis >= 0. then lasting (i + 1) else i in
  (lasting start, least g st axis, axis)

let better (n, x, _) (m, y, _) = match Int.compare m n with 0 -> Float.compare y x | c -> c
let axes ranked = List.to_seq (List.map (fun (_, _, axis) -> axis) ranked)

let candidates g ~low ~high =
  let two = Rat.of_int 2 in
  let st = at g (Rat.near_float (Rat.div (Rat.add low high) two)) in
  let radius = (Float_box.up (Rat.div (Rat.sub high low) two) *. (1. +. 0x1p-40)) +. 0x1p-50 in
  let start = part g low in
  let rank axes = List.map (promise g st start) axes in
  let faces =
    List.init (Array.length g.a.heights) (fun f -> Axis.Face_a f)
    @ List.init (Array.length g.b.heights) (fun f -> Axis.Face_b f)
    |> List.filter (possible g st radius)
    |> rank |> List.stable_sort better
  in
  let rest faces () = axes (List.stable_sort better (faces @ rank (possible_edges g st radius))) () in
  match faces with
  | ((n, _, _) as best) :: others when n = Array.length g.samples -> Seq.append (axes [ best ]) (rest others)
  | _ -> rest faces
