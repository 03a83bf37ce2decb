open Scc_exact
open Svg_number

type polygon = (int * int) list

let unit = 1024
let farthest = (1 lsl 14) * unit
let bad format = Printf.ksprintf (fun m -> raise (Bad m)) format
let ( +: ) (a, b) (c, d) = (Rat.add a c, Rat.add b d)
let ( -: ) (a, b) (c, d) = (Rat.sub a c, Rat.sub b d)
let ( *: ) q (a, b) = (Rat.mul q a, Rat.mul q b)

(* The polygon that is being drawn has its corners in reverse. [here] and [start] are in the drawing's units. *)
type pen = {
  map : Plane_map.t;
  budget : int ref;
  mutable here : Plane_map.point;
  mutable start : Plane_map.point;
  mutable corners : (int * int) list;
  mutable polygons : polygon list;
}

let origin = (Rat.zero, Rat.zero)
let pen ~budget map = { map; budget; here = origin; start = origin; corners = []; polygons = [] }

let corner p place =
  decr p.budget;
  if !(p.budget) < 0 then bad "more corners than are read of one drawing";
  let grid q =
    let z = (Rat.round_to (Rat.mul q (Rat.of_int unit)) ~quantum:Rat.one).num in
    if Z.gt (Z.abs z) (Z.of_int farthest) then bad "something is drawn too far outside of the picture"
    else Z.to_int z
  in
  let x, y = place in
  p.corners <- (grid x, grid y) :: p.corners

let close p =
  if p.corners <> [] then p.polygons <- p.corners :: p.polygons;
  p.corners <- []

let move p place =
  close p;
  p.here <- place;
  p.start <- place

let begun p = if p.corners = [] then corner p (Plane_map.apply p.map p.here)

let line p place =
  begun p;
  p.here <- place;
  corner p (Plane_map.apply p.map place)

(* Of control points in pixels, evaluated after de Casteljau. *)
let rec bezier t = function
  | [ point ] -> point
  | points ->
    let rec pairs = function a :: (b :: _ as rest) -> (a +: (t *: (b -: a))) :: pairs rest | _ -> [] in
    bezier t (pairs points)

(* Control points are taken to a fine grid, so that numbers stay short. *)
let fine (x, y) =
  let quantum = Rat.make Z.one (Z.of_int (1 lsl 20)) in
  (Rat.round_to x ~quantum, Rat.round_to y ~quantum)

(* A piece of 1/n of a Bezier curve of degree k is within k (k - 1) / (8 n^2) times the longest second
   difference of its control points of its chord. *)
let curve p controls =
  begun p;
  let points = List.map (fun q -> fine (Plane_map.apply p.map q)) (p.here :: controls) in
  let rec bends = function
    | a :: (b :: c :: _ as rest) ->
      let x, y = a -: (Rat.of_int 2 *: b) +: c in
      Rat.max (Rat.add (Rat.abs x) (Rat.abs y)) (bends rest)
    | _ -> Rat.zero
  in
  let k = List.length controls in
  (* Half of 1/64 pixel is left for rounding. *)
  let squared = Rat.mul (bends points) (Rat.of_int (16 * k * (k - 1))) in
  let n = Z.to_int (Z.min (Z.of_int 1_000_000) (Z.succ (Z.sqrt (Rat.floor squared)))) in
  for i = 1 to n do
    corner p (bezier (Rat.make (Z.of_int i) (Z.of_int n)) points)
  done;
  p.here <- List.nth controls (k - 1)

(* {1 Arcs} *)

let norm2 (x, y) = Rat.add (Rat.mul x x) (Rat.mul y y)

let short (x, y) =
  let quantum = Rat.make Z.one (Z.shift_left Z.one 36) in
  (Rat.round_to x ~quantum, Rat.round_to y ~quantum)

(* The image of the arc of the unit circle from u to v, by [map], into pixels; [forward] is towards growing angles,
   as x and y have them. The middle of an arc is over the middle of its chord. *)
let arc_of_circle p map ~forward u v =
  let rec depth k size = if k >= 14 || Rat.compare size (Rat.make Z.one (Z.of_int 128)) <= 0 then k
    else depth (k + 1) (Rat.mul size (Rat.make Z.one (Z.of_int 4))) in
  let levels = depth 2 (Plane_map.stretch map) in
  let rec go k u v =
    if k = 0 then corner p (Plane_map.apply map v)
    else begin
      let x, y = v -: u in
      let out = if forward then (y, Rat.neg x) else (Rat.neg y, x) in
      let middle = short (Rat.div Rat.one (Rat.root (norm2 out)) *: out) in
      go (k - 1) u middle;
      go (k - 1) middle v
    end
  in
  begun p;
  go levels u v

(* The centre of the ellipse, as SVG's notes on implementation have it, where the ellipse is the unit circle. *)
let arc p (rx, ry) angle ~large ~sweep place =
  let rx = Rat.abs rx and ry = Rat.abs ry in
  if Rat.equal (fst p.here) (fst place) && Rat.equal (snd p.here) (snd place) then ()
  else if Rat.sign rx = 0 || Rat.sign ry = 0 then line p place
  else begin
    let c, s = Plane_map.cos_sin angle in
    let x, y = Rat.half *: (p.here -: place) in
    let turned = (Rat.add (Rat.mul c x) (Rat.mul s y), Rat.sub (Rat.mul c y) (Rat.mul s x)) in
    let a = (Rat.div (fst turned) rx, Rat.div (snd turned) ry) in
    let size = norm2 a in
    let grown = if Rat.compare size Rat.one > 0 then Rat.root size else Rat.one in
    let a = Rat.div Rat.one grown *: a in
    let size = norm2 a in
    let off = Rat.max Rat.zero (Rat.div (Rat.sub Rat.one size) size) in
    let q = if Rat.sign off = 0 then Rat.zero else Rat.root off in
    let q = if large = sweep then Rat.neg q else q in
    let centre = q *: (snd a, Rat.neg (fst a)) in
    let radii = Plane_map.scaling (Rat.mul rx grown) (Rat.mul ry grown) in
    let mx, my = Rat.half *: (p.here +: place) in
    let cx, cy = centre in
    let map =
      Plane_map.(
        compose (translation mx my) (compose (rotation angle) (compose radii (translation cx cy))))
    in
    arc_of_circle p (Plane_map.compose p.map map) ~forward:sweep (a -: centre) ((Rat.of_int (-1) *: a) -: centre);
    p.here <- place
  end

(* {1 Path data} *)

(* What S and T continue: the last control point of the curve before. *)
type last = Cubic of Plane_map.point | Quadratic of Plane_map.point | Other

let mirrored p control = (Rat.of_int 2 *: p.here) -: control

(* One command with its numbers: [x] and [y] read coordinates, [c] has the text. What later commands continue. *)
let draw p c command ~x ~y last =
  let point () =
    let x = x () in
    (x, y ())
  in
  let cubic a =
    let b = point () in
    curve p [ a; b; point () ];
    Cubic b
  in
  let quadratic a =
    curve p [ a; point () ];
    Quadratic a
  in
  match Char.uppercase_ascii command with
  | 'M' -> move p (point ()); Other
  | 'L' -> line p (point ()); Other
  | 'H' -> line p (x (), snd p.here); Other
  | 'V' -> line p (fst p.here, y ()); Other
  | 'C' -> cubic (point ())
  | 'S' -> cubic (match last with Cubic b -> mirrored p b | Quadratic _ | Other -> p.here)
  | 'Q' -> quadratic (point ())
  | 'T' -> quadratic (match last with Quadratic b -> mirrored p b | Cubic _ | Other -> p.here)
  | 'A' ->
    let rx = number c in
    let ry = number c in
    let angle = number c in
    let large = flag c in
    let sweep = flag c in
    arc p (rx, ry) angle ~large ~sweep (point ());
    Other
  | 'Z' ->
    close p;
    p.here <- p.start;
    Other
  | _ -> bad "path data with the unknown command %C" command

let path p text =
  let c = { text; at = 0 } in
  let letter () =
    let x = text.[c.at] in
    c.at <- c.at + 1;
    x
  in
  let rec next command last =
    if not (ended c) then
      match text.[c.at] with
      | ('A' .. 'Z' | 'a' .. 'z') as first when Option.is_none command && first <> 'M' && first <> 'm' ->
        bad "path data that begin with %C, and not with a move (M)" first
      | 'A' .. 'Z' | 'a' .. 'z' -> run (letter ()) last
      | _ -> (
          match command with
          | None | Some ('Z' | 'z') -> bad "path data with a number where a command is needed"
          | Some 'M' -> run 'L' last
          | Some 'm' -> run 'l' last
          | Some command -> run command last)
  and run command last =
    let base = if Char.lowercase_ascii command = command then p.here else origin in
    let x () = Rat.add (number c) (fst base) and y () = Rat.add (number c) (snd base) in
    next (Some command) (draw p c command ~x ~y last)
  in
  next None Other;
  close p;
  p.polygons

let points p = function
  | [] -> []
  | first :: rest ->
    move p first;
    List.iter (line p) rest;
    close p;
    p.polygons

let ellipse p (cx, cy) rx ry =
  let at q = (Rat.add cx q, cy) in
  move p (at rx);
  let half place = arc p (rx, ry) Rat.zero ~large:false ~sweep:true place in
  half (at (Rat.neg rx));
  half (at rx);
  close p;
  p.polygons

let rectangle p (x, y) (w, h) (rx, ry) =
  let rx = Rat.min rx (Rat.mul Rat.half w) and ry = Rat.min ry (Rat.mul Rat.half h) in
  let right = Rat.add x w and bottom = Rat.add y h in
  let round place = arc p (rx, ry) Rat.zero ~large:false ~sweep:true place in
  move p (Rat.add x rx, y);
  line p (Rat.sub right rx, y);
  round (right, Rat.add y ry);
  line p (right, Rat.sub bottom ry);
  round (Rat.sub right rx, bottom);
  line p (Rat.add x rx, bottom);
  round (x, Rat.sub bottom ry);
  line p (x, Rat.add y ry);
  round (Rat.add x rx, y);
  close p;
  p.polygons
