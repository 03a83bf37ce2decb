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

(* {1 Arcs} *)

type circular = { map : Plane_map.t; start : Plane_map.point; stop : Plane_map.point; forward : bool }

let circular here (arc : Svg_segment.arc) =
  let rx = Rat.abs (fst arc.radii) and ry = Rat.abs (snd arc.radii) in
  if same here arc.stop || Rat.sign rx = 0 || Rat.sign ry = 0 then None
  else begin
    let c, s = Plane_map.cos_sin arc.angle in
    let x, y = Rat.half *: (here -: arc.stop) in
    let turned = (Rat.add (Rat.mul c x) (Rat.mul s y), Rat.sub (Rat.mul c y) (Rat.mul s x)) in
    let a = (Rat.div (fst turned) rx, Rat.div (snd turned) ry) in
    let size = dot a a in
    let grown = if Rat.compare size Rat.one > 0 then Rat.root size else Rat.one in
    let a = Rat.div Rat.one grown *: a in
    let size = dot a a in
    let off = Rat.max Rat.zero (Rat.div (Rat.sub Rat.one size) size) in
    let q = if Rat.sign off = 0 then Rat.zero else Rat.root off in
    let q = if arc.large = arc.sweep then Rat.neg q else q in
    let centre = q *: (snd a, Rat.neg (fst a)) in
    let radii = Plane_map.scaling (Rat.mul rx grown) (Rat.mul ry grown) in
    let mx, my = Rat.half *: (here +: arc.stop) in
    let cx, cy = centre in
    let map =
      Plane_map.(
        compose (translation mx my) (compose (rotation arc.angle) (compose radii (translation cx cy))))
    in
    Some { map; start = a -: centre; stop = (Rat.of_int (-1) *: a) -: centre; forward = arc.sweep }
  end

let short (x, y) =
  let quantum = Rat.make Z.one (Z.shift_left Z.one 36) in
  (Rat.round_to x ~quantum, Rat.round_to y ~quantum)

(* The middle of an arc is over the middle of its chord. *)
let middle ~forward u v =
  let x, y = v -: u in
  let out = if forward then (y, Rat.neg x) else (Rat.neg y, x) in
  short (Rat.div Rat.one (Rat.root (dot out out)) *: out)

let halvings ~share map =
  let enough = Rat.make Z.one (Z.of_int share) in
  let rec depth k size =
    if k >= 14 || Rat.compare size enough <= 0 then k else depth (k + 1) (Rat.div size (Rat.of_int 4))
  in
  depth 2 (Plane_map.stretch map)
