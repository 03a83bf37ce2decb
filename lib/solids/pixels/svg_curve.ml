open Scc_exact

let ( +: ) (a, b) (c, d) = (Rat.add a c, Rat.add b d)
let ( -: ) (a, b) (c, d) = (Rat.sub a c, Rat.sub b d)
let ( *: ) q (a, b) = (Rat.mul q a, Rat.mul q b)
let cross (a, b) (c, d) = Rat.sub (Rat.mul a d) (Rat.mul b c)
let dot (a, b) (c, d) = Rat.add (Rat.mul a c) (Rat.mul b d)
let same (a, b) (c, d) = Rat.equal a c && Rat.equal b d

let rec bezier t = function
  | [ point ] -> point
  | points ->
    let rec pairs = function a :: (b :: _ as rest) -> (a +: (t *: (b -: a))) :: pairs rest | _ -> [] in
    bezier t (pairs points)

(* A piece of 1/n of a Bezier curve of degree k is within k (k - 1) / (8 n^2) times the longest second
   difference of its control points of its chord. *)
let pieces ~share points =
  let rec bends = function
    | a :: (b :: c :: _ as rest) ->
      let x, y = a -: (Rat.of_int 2 *: b) +: c in
      Rat.max (Rat.add (Rat.abs x) (Rat.abs y)) (bends rest)
    | _ -> Rat.zero
  in
  let k = List.length points - 1 in
  let squared = Rat.mul (bends points) (Rat.make (Z.of_int (share * k * (k - 1))) (Z.of_int 8)) in
  Z.to_int (Z.min (Z.of_int 1_000_000) (Z.succ (Z.sqrt (Rat.floor squared))))

(* A curve within a square has its control points within ten such squares. So there are few pieces if four of its
   points are near. *)
let check_places ~check points =
  List.iter (fun quarters -> check (bezier (Rat.make (Z.of_int quarters) (Z.of_int 4)) points)) [ 0; 1; 2; 3; 4 ]

(* {1 Arcs} *)

type circular = {
  map : Plane_map.t;
  start : Plane_map.point;
  middle : Plane_map.point;
  stop : Plane_map.point;
  forward : bool;
  wide : bool;
  bits : int;
}

let max_bits = 2_000

(* With s pixels for the greater radius and k for the quotient of the radii:

   - Unit vectors with an error of 2^-b are off by s 2^-b pixels.
   - If cosine and sine of the angle are off by d, half of the chord in units of the radii is off by d k of its
     length, and the centre in these units by no more than root (2 d k) + 2 d k. So a point is off by
     s (root (2 d k) + 2 d k + 2 d) pixels.

   Both are below 2^-16 by the following numbers of bits, of which [extra] are left for directions. *)
let circular ~stretch ~extra here (arc : Svg_segment.arc) =
  let rx = Rat.abs (fst arc.radii) and ry = Rat.abs (snd arc.radii) in
  if same here arc.stop || Rat.sign rx = 0 || Rat.sign ry = 0 then None
  else begin
    let x, y = Rat.half *: (here -: arc.stop) in
    let least = Rat.min rx ry and most = Rat.max rx ry in
    let growth = Rat.add Rat.one (Rat.div (Rat.add (Rat.abs x) (Rat.abs y)) least) in
    let size = Rat.log_above (Rat.mul stretch (Rat.mul most growth)) in
    let flat = Rat.log_above (Rat.div most least) in
    let bits = 44 + size + (2 * flat) + extra in
    let turning = 40 + (2 * size) + flat in
    if bits + turning > max_bits then raise (Svg_number.Bad "an arc whose radii are too large or too different");
    let c, s = if Rat.equal rx ry then (Rat.one, Rat.zero) else Angle.cos_sin_to ~bits:turning arc.angle in
    (* The inverse of the rotation is exact, so that the ends of the arc are. *)
    let norm = Rat.add (Rat.mul c c) (Rat.mul s s) in
    let turned =
      Rat.div Rat.one norm *: (Rat.add (Rat.mul c x) (Rat.mul s y), Rat.sub (Rat.mul c y) (Rat.mul s x))
    in
    let a = (Rat.div (fst turned) rx, Rat.div (snd turned) ry) in
    let size = dot a a in
    let root q = Rat.root_to ~bits q in
    let length = root size in
    let small = Rat.compare size Rat.one < 0 in
    let grown = if small then Rat.one else length in
    let a = Rat.div Rat.one grown *: a in
    let unit = Rat.div grown length *: a in
    let q = if small then root (Rat.div (Rat.sub Rat.one size) size) else Rat.zero in
    let wide = small && arc.large in
    let q = if arc.large = arc.sweep then Rat.neg q else q in
    let centre = q *: (snd a, Rat.neg (fst a)) in
    let mx, my = Rat.half *: (here +: arc.stop) in
    let cx, cy = centre in
    let turn = { Plane_map.identity with a = c; b = s; c = Rat.neg s; d = c } in
    let radii = Plane_map.scaling (Rat.mul rx grown) (Rat.mul ry grown) in
    let map =
      Plane_map.(compose (translation mx my) (compose turn (compose radii (translation cx cy))))
    in
    let out = if arc.sweep then (Rat.neg (snd unit), fst unit) else (snd unit, Rat.neg (fst unit)) in
    Some
      {
        map; start = a -: centre; middle = out; stop = (Rat.of_int (-1) *: a) -: centre; forward = arc.sweep;
        wide; bits;
      }
  end

let short ~bits (x, y) =
  let quantum = Rat.power_of_two (-bits) in
  (Rat.round_to x ~quantum, Rat.round_to y ~quantum)

(* The middle is in the direction of the sum of both, or, of more than a quarter, square to their difference: the
   longer one of the two, so that errors do not grow. *)
let middle { forward; bits; _ } u v =
  let x, y = v -: u in
  let out =
    if Rat.sign (dot u v) >= 0 then u +: v else if forward then (y, Rat.neg x) else (Rat.neg y, x)
  in
  short ~bits (Rat.div Rat.one (Rat.root_to ~bits (dot out out)) *: out)

let max_halvings = 17

(* The chord of at most half of an ellipse is within the distance of both their middles of its arc. *)
let arc_points ~share ~check map c =
  let place = Plane_map.apply map in
  let near u m v =
    let w = Rat.of_int share *: (place m -: place (Rat.half *: (u +: v))) in
    Rat.compare (dot w w) Rat.one <= 0
  in
  let rec go k u m v found =
    check (place m);
    if k = 0 || (near u m v && not (k = max_halvings && c.wide)) then v :: found
    else go (k - 1) m (middle c m v) v (go (k - 1) u (middle c u m) m found)
  in
  List.rev (go max_halvings c.start c.middle c.stop [ c.start ])
