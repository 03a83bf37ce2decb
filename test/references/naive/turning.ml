open Scc_exact
module Guide = Turning_guide

type body = {
  solid : Naive.solid;
  turned : Rat.t * Rat.t * Rat.t * Rat.t;
  arm : Vec.t;
  centre : Vec.t;
  velocity : Vec.t;
  spin : Vec.t;
  since : Rat.t;
}

type first = Never | Inside | Within of Rat.t * Rat.t
type answer = { doubts : (Rat.t * Rat.t) list; first : first; given_up : bool }

(* {1 Polynomials in time, over the integers; the constant first} *)

module Poly = struct
  type t = Z.t array

  let coefficient p i = if i < Array.length p then p.(i) else Z.zero

  let zip f p q =
    let n = Int.max (Array.length p) (Array.length q) in
    Array.init n (fun i -> f (coefficient p i) (coefficient q i))

  let add = zip Z.add
  let sub = zip Z.sub
  let neg = Array.map Z.neg
  let constant k = [| k |]

  let mul p q =
    let r = Array.make (Array.length p + Array.length q - 1) Z.zero in
    Array.iteri (fun i x -> Array.iteri (fun j y -> r.(i + j) <- Z.add r.(i + j) (Z.mul x y)) q) p;
    r

  let is_zero = Array.for_all (fun c -> Z.sign c = 0)

  (* 2^(j degree) times the value at k / 2^j. *)
  let value p (k, j) =
    let n = Array.length p - 1 in
    let rec go i acc =
      if i < 0 then acc else go (i - 1) (Z.add (Z.mul acc k) (Z.shift_left p.(i) (j * (n - i))))
    in
    go n Z.zero

  (* Not negative on [k, k + 1] / 2^j, for sure: with y from 0 to 1, p((k + y)/2^j) has no negative coefficient in
     the Bernstein basis. *)
  let not_negative p (k, j) =
    let n = Array.length p - 1 in
    let c = Array.mapi (fun i x -> Z.shift_left x (j * (n - i))) p in
    for i = 0 to n - 1 do
      for l = n - 1 downto i do
        c.(l) <- Z.add c.(l) (Z.mul k c.(l + 1))
      done
    done;
    (* Now in powers of y. The i-th Bernstein coefficient times (n over i) is the sum of (n-k over i-k) c_k:
       the coefficients of (1 + x)^n p(x/(1 + x)), made from the lowest c_k on by s := (1 + x) s + c_k x^k. *)
    let b = Array.make (n + 1) Z.zero in
    let rec go k =
      if k > n then true
      else begin
        for i = k downto 1 do
          b.(i) <- Z.add b.(i) b.(i - 1)
        done;
        b.(k) <- Z.add b.(k) c.(k);
        go (k + 1)
      end
    in
    go 0 && Array.for_all (fun x -> Z.sign x >= 0) b
end

module Pvec = struct
  type t = Poly.t array

  let zip = Array.map2
  let sub = zip Poly.sub
  let dot u v = Poly.(add (mul u.(0) v.(0)) (add (mul u.(1) v.(1)) (mul u.(2) v.(2))))
  let scale p = Array.map (Poly.mul p)

  let cross u v =
    let minor i j = Poly.(sub (mul u.(i) v.(j)) (mul u.(j) v.(i))) in
    [| minor 1 2; minor 2 0; minor 0 1 |]

  let value v at = Array.map (fun p -> Poly.value p at) v
end

(* {1 The bodies over integers} *)

let coordinates (v : Vec.t) = [ v.x; v.y; v.z ]
let vector = function [ x; y; z ] -> Vec.make x y z | _ -> invalid_arg "three coordinates"

(* The matrix of a quaternion times the square of its length, by rows; in any ring. *)
let rows ~add ~sub ~mul (w, x, y, z) =
  let twice a = add a a in
  let sq a = mul a a in
  [| [| sub (add (sq w) (sq x)) (add (sq y) (sq z)); twice (sub (mul x y) (mul w z));
        twice (add (mul x z) (mul w y)) |];
     [| twice (add (mul x y) (mul w z)); sub (add (sq w) (sq y)) (add (sq x) (sq z));
        twice (sub (mul y z) (mul w x)) |];
     [| twice (sub (mul x z) (mul w y)); twice (add (mul y z) (mul w x));
        sub (add (sq w) (sq z)) (add (sq x) (sq y)) |] |]

let turned (w, x, y, z) v =
  let m = rows ~add:Rat.add ~sub:Rat.sub ~mul:Rat.mul (w, x, y, z) in
  let length2 = List.fold_left (fun s q -> Rat.add s (Rat.mul q q)) Rat.zero [ w; x; y; z ] in
  let row r = Rat.div (Vec.dot (Vec.make r.(0) r.(1) r.(2)) v) length2 in
  vector (List.map row (Array.to_list m))

(* Corners from the centre, normals of faces and directions of edges, at the start of the turn. *)
type shape = { corners : Vec.t array; normals : Vec.t array; directions : Vec.t array; faces : int array array }

let shape b =
  let corners = Array.map (fun p -> Vec.add b.arm (turned b.turned p)) b.solid.points in
  let faces = Array.of_list (List.map Array.of_list b.solid.faces) in
  let from i j = Vec.sub corners.(j) corners.(i) in
  let normal f = Vec.cross (from f.(0) f.(1)) (from f.(0) f.(2)) in
  let directions = Array.map (fun (v, w, _, _) -> from v w) (Guide.edges faces) in
  { corners; normals = Array.map normal faces; directions; faces }

let half = Rat.make Z.one (Z.of_int 2)

(* Seen from the centre of A, so that floats are as good as they can be. *)
let guide ?law (a : body) (b : body) ~span =
  let floats v = Array.of_list (List.map Rat.to_float (coordinates v)) in
  let body (b : body) =
    let s = shape b in
    { Guide.corners = Array.map floats s.corners;
      faces = s.faces;
      centre = floats (Vec.sub b.centre a.centre);
      travel = floats (Vec.scale span (Vec.sub b.velocity a.velocity));
      half_spin = floats (Vec.scale half b.spin);
      since = Rat.to_float b.since;
      span = Rat.to_float span }
  in
  Guide.make ?law (body a) (body b)

(* The place of a corner at time s (in units of the span) is [x] / (D norm): what is in D-ths is the same for both.
*)
type moving = {
  norm : Poly.t;  (* positive *)
  x : Pvec.t array;
  from_centre : Pvec.t array;  (* the same without the centre *)
  n : Pvec.t array;  (* normals of faces, of any length *)
  d : Pvec.t array;  (* directions of edges *)
}

let over scale r =
  let q = Rat.mul (Q.of_bigint scale) r in
  assert (Rat.is_integer q);
  q.Q.num

let common rationals = List.fold_left (fun d (r : Rat.t) -> Z.lcm d r.Q.den) Z.one rationals

let moving b s ~span ~scale =
  let linear c0 c1 = [| c0; c1 |] in
  (* The quaternion 1 + (spin/2) (since + span s), times what makes it integral. *)
  let u0 = coordinates (Vec.scale (Rat.mul half b.since) b.spin) in
  let u1 = coordinates (Vec.scale (Rat.mul half span) b.spin) in
  let k = common (u0 @ u1) in
  let u = List.map2 (fun c0 c1 -> linear (over k c0) (over k c1)) u0 u1 in
  let w = Poly.constant k in
  let x, y, z = match u with [ x; y; z ] -> (x, y, z) | _ -> assert false in
  let m = rows ~add:Poly.add ~sub:Poly.sub ~mul:Poly.mul (w, x, y, z) in
  let norm = List.fold_left (fun s q -> Poly.add s (Poly.mul q q)) (Poly.constant Z.zero) [ w; x; y; z ] in
  let image scale v =
    let v = Array.of_list (List.map (fun r -> Poly.constant (over scale r)) (coordinates v)) in
    Array.map (fun row -> Pvec.dot row v) m
  in
  let centre =
    List.map2 (fun c0 c1 -> linear (over scale c0) (over scale c1)) (coordinates b.centre)
      (coordinates (Vec.scale span b.velocity))
  in
  let centre = Pvec.scale norm (Array.of_list centre) in
  let from_centre = Array.map (image scale) s.corners in
  let direction v = image (common (coordinates v)) v in
  { norm;
    from_centre;
    x = Array.map (Pvec.zip Poly.add centre) from_centre;
    n = Array.map direction s.normals;
    d = Array.map direction s.directions }

type pair = { a : moving; b : moving }

let pair a b ~span =
  let sa = shape a and sb = shape b in
  let numbers (b : body) s =
    List.concat_map coordinates (b.centre :: Vec.scale span b.velocity :: Array.to_list s.corners)
  in
  let scale = common (numbers a sa @ numbers b sb) in
  { a = moving a sa ~span ~scale; b = moving b sb ~span ~scale }

(* {1 Separated over a piece of time} *)

(* What must not be negative for a candidate to separate the bodies: A is behind the plane through its corner, B
   in front of it; or, when the axis is of a face of B, the other way round. Nothing when the axis is zero all
   the time. Where it is zero for an instant only, the bodies are separated just before and after, and so they
   are then. *)
let conditions { a; b } (c : Guide.candidate) =
  let n =
    match c.axis with
    | Face_a i -> a.n.(i)
    | Face_b i -> b.n.(i)
    | Edges (i, j) -> Pvec.cross a.d.(i) b.d.(j)
  in
  let n = if c.reversed then Array.map Poly.neg n else n in
  if Array.for_all Poly.is_zero n then None
  else
    let corners m = List.init (Array.length m.x) Fun.id in
    let ahead m i j = Pvec.dot n (Pvec.sub m.from_centre.(i) m.from_centre.(j)) in
    let gap i j = Pvec.dot n (Pvec.sub (Pvec.scale a.norm b.x.(j)) (Pvec.scale b.norm a.x.(i))) in
    let first, last = (c.corner_a, c.corner_b) in
    Some
      (match c.axis with
       | Face_b _ -> List.map (fun j -> ahead b j last) (corners b) @ List.map (fun i -> gap i last) (corners a)
       | Face_a _ | Edges _ -> List.map (ahead a first) (corners a) @ List.map (gap first) (corners b))

let separated conditions at = List.for_all (fun p -> Poly.not_negative p at) conditions

(* {1 Interpenetrating at an instant} *)

let zdot u v = Z.add (Z.mul u.(0) v.(0)) (Z.add (Z.mul u.(1) v.(1)) (Z.mul u.(2) v.(2)))

let zcross u v =
  let minor i j = Z.sub (Z.mul u.(i) v.(j)) (Z.mul u.(j) v.(i)) in
  [| minor 1 2; minor 2 0; minor 0 1 |]

let extent dot points n =
  Array.fold_left
    (fun (lo, hi) p ->
       let h = dot p n in
       ((if h < lo then h else lo), if h > hi then h else hi))
    (let h = dot points.(0) n in (h, h))
    points

let zextent points n =
  Array.fold_left
    (fun (lo, hi) p -> let h = zdot p n in (Z.min lo h, Z.max hi h))
    (let h = zdot points.(0) n in (h, h))
    points

let fdot u v = (u.(0) *. v.(0)) +. (u.(1) *. v.(1)) +. (u.(2) *. v.(2))

let fcross u v =
  [| (u.(1) *. v.(2)) -. (u.(2) *. v.(1)); (u.(2) *. v.(0)) -. (u.(0) *. v.(2));
     (u.(0) *. v.(1)) -. (u.(1) *. v.(0)) |]

let greatest v = Array.fold_left (fun m x -> Float.max m (Float.abs x)) 0. v

(* At s = k / 2^j. Floats that are within 2^-53 of the integers, relatively, say that the bodies overlap along an
   axis when they do by more than the errors can be: a product of two edges is off by less than 2^-50 times the
   product of their greatest coordinates, a height by less than 2^-48 times that and the greatest coordinate; the
   bound below is wider by far. *)
let overlap { a; b } at =
  let corners own other =
    let factor = Poly.value other.norm at in
    Array.map (fun x -> Array.map (Z.mul factor) (Pvec.value x at)) own.x
  in
  let xa = corners a b and xb = corners b a in
  let normals m = Array.map (fun n -> Pvec.value n at) m.n in
  let directions m = Array.map (fun d -> Pvec.value d at) m.d in
  let floats = Array.map (Array.map Z.to_float) in
  let fa = floats xa and fb = floats xb in
  let size = Array.fold_left (fun m x -> Float.max m (greatest x)) 0. (Array.append fa fb) in
  let surely f bound =
    let bound = bound *. size *. 0x1p-40 in
    bound < 1e300
    &&
    let la, ha = extent fdot fa f and lb, hb = extent fdot fb f in
    ha -. lb > bound && hb -. la > bound
  in
  let exactly n =
    Array.for_all (fun c -> Z.sign c = 0) n
    ||
    let la, ha = zextent xa n and lb, hb = zextent xb n in
    Z.gt ha lb && Z.gt hb la
  in
  let along_normal n =
    let f = Array.map Z.to_float n in
    surely f (greatest f) || exactly n
  in
  let da = directions a and db = directions b in
  let along_edges d e =
    let f = Array.map Z.to_float d and g = Array.map Z.to_float e in
    surely (fcross f g) (greatest f *. greatest g) || exactly (zcross d e)
  in
  Array.for_all along_normal (normals a)
  && Array.for_all along_normal (normals b)
  && Array.for_all (fun d -> Array.for_all (along_edges d) db) da

let interpenetrate a b t =
  let rest body =
    { body with
      centre = Vec.axpy t body.velocity body.centre;
      velocity = Vec.zero;
      since = Rat.add t body.since }
  in
  overlap (pair (rest a) (rest b) ~span:Rat.zero) (Z.zero, 0)

(* {1 Subdivision} *)

let most_doubts = 64
let most_pieces = 20_000

exception Decided

let first ?(finest = 42) a b ~span =
  let guide = guide a b ~span in
  let p = pair a b ~span in
  let known = Hashtbl.create 16 in
  let conditions (c : Guide.candidate) =
    let key = (c.axis, c.reversed, c.corner_a, c.corner_b) in
    match Hashtbl.find_opt known key with
    | Some found -> found
    | None ->
      let found = conditions p c in
      Hashtbl.add known key found;
      found
  in
  let apart k j =
    let middle = ldexp (float_of_int k +. 0.5) (-j) in
    let at = (Z.of_int k, j) in
    let proves (c : Guide.candidate) =
      c.gap >= -1e-9 && match conditions c with None -> false | Some all -> separated all at
    in
    List.exists proves (Guide.best guide middle 3)
  in
  let time k j = Rat.mul span (Rat.make (Z.of_int k) (Z.shift_left Z.one j)) in
  let doubts = ref [] and count = ref 0 and pieces = ref 0 in
  let found = ref Never and given_up = ref false in
  let rec go k j =
    incr pieces;
    if !pieces > most_pieces || !count > most_doubts then (given_up := true; raise Decided);
    if not (apart k j) then
      if j < finest then (go (2 * k) (j + 1); go ((2 * k) + 1) (j + 1))
      else if overlap p (Z.of_int (k + 1), j) then (found := Within (time k j, time (k + 1) j); raise Decided)
      else (incr count; doubts := (time k j, time (k + 1) j) :: !doubts)
  in
  if overlap p (Z.zero, 0) then { doubts = []; first = Inside; given_up = false }
  else begin
    (try go 0 0 with Decided -> ());
    { doubts = List.rev !doubts; first = !found; given_up = !given_up }
  end
