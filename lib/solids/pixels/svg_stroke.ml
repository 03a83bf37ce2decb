open Scc_exact
open Svg_curve

type cap = Butt | Round_cap | Square
type join = Miter of Rat.t | Round | Bevel
type t = { half : Rat.t; cap : cap; join : join; dashes : Rat.t list; offset : Rat.t }

(* Chords of curves, chords of round caps and joins, and directions of chords at the ends of curves take this
   share of a pixel each; the fourth part is left for rounding. *)
let each = 4 * 64

(* Here the units of the drawing are scaled by a power of two, so that lengths are no shorter than their images in
   pixels. [map] is the map from there to pixels, and [half] is half of the width. *)
type pen = {
  map : Plane_map.t;
  half : Rat.t;
  stroke : t;
  budget : Svg_polygon.budget;
  mutable found : Svg_polygon.polygon list;
}

let minus v = Rat.of_int (-1) *: v

(* Corners are rounded first. So triangles that have a side in common leave no slit, and each runs the same way
   round, however thin it is. *)
let triangle p a b c =
  Svg_polygon.spend p.budget 3;
  let corner q = Svg_polygon.corner (Plane_map.apply p.map q) in
  let a = corner a in
  let b = corner b in
  let c = corner c in
  let area = ((fst b - fst a) * (snd c - snd a)) - ((snd b - snd a) * (fst c - fst a)) in
  if area > 0 then p.found <- [ a; b; c ] :: p.found else if area < 0 then p.found <- [ a; c; b ] :: p.found

let quadrangle p a b c d =
  triangle p a b c;
  triangle p a c d

(* On both sides of the segment from [a] to [b], each by itself, since what comes next has the corners [a] and
   [b]. *)
let both_sides p a b u =
  quadrangle p a b (b +: u) (a +: u);
  quadrangle p a b (b -: u) (a -: u)

(* The vector of the length of half the width in a direction. *)
let forth p v = Rat.div p.half (Rat.root (dot v v)) *: v
let turned (x, y) = (Rat.neg y, x)
let normal p v = turned (forth p v)

let short (x, y) =
  let quantum = Rat.make Z.one (Z.shift_left Z.one 36) in
  (Rat.round_to x ~quantum, Rat.round_to y ~quantum)

(* {1 Round things} *)

(* The sector of the disc around [c] between two radii, at most a quarter apart. A chord of the length l is within
   l^2 / (4 r) of its arc. *)
let rec sector p c u v =
  let w = v -: u in
  if Rat.compare (Rat.mul (dot w w) (Rat.of_int each)) (Rat.mul (Rat.of_int 4) p.half) <= 0 then
    triangle p c (c +: u) (c +: v)
  else begin
    let m = short (forth p (u +: v)) in
    sector p c u m;
    sector p c m v
  end

(* The same for radii up to half a turn apart, by the middle one where they are more than a quarter apart. *)
let wide_sector p c u v ~middle =
  if Rat.sign (dot u v) >= 0 then sector p c u v
  else begin
    let m = middle () in
    sector p c u m;
    sector p c m v
  end

(* The radii to the outer side of a turn at a place, of the directions before and after it; none if there is no
   turn. *)
let outer p d e =
  let turn = Rat.sign (cross d e) in
  if turn = 0 && Rat.sign (dot d e) > 0 then None
  else
    let u = normal p d and v = normal p e in
    if turn > 0 then Some (minus u, minus v) else Some (u, v)

(* In the middle of the outer side of a sharp turn: ahead of the direction before it, and back from the one
   after it. *)
let ahead p d e () = short (forth p (forth p d -: forth p e))

(* Normals of equal directions may still be rounded to different corners. *)
let straight_on p c d e =
  let u = normal p d and v = normal p e in
  if not (same u v) then begin
    triangle p c (c +: u) (c +: v);
    triangle p c (c -: u) (c -: v)
  end

(* Within a curve, both sides of a turn are swept. *)
let bend p c d e =
  match outer p d e with
  | None -> straight_on p c d e
  | Some (u, v) ->
    let middle = ahead p d e in
    wide_sector p c u v ~middle;
    wide_sector p c (minus u) (minus v) ~middle:(fun () -> minus (middle ()))

let disc p c =
  let u = (p.half, Rat.zero) in
  let quarters = [ u; turned u; minus u; turned (minus u) ] in
  List.iter (fun u -> sector p c u (turned u)) quarters

(* {1 Joins and caps} *)

(* The length of a miter is 1/cos(a/2) of the width, for a turn by a: within the limit l if 1 + cos a >= 2/l^2.
   With c, d and e the cosine and the directions, c |d| |e| is their scalar product. *)
let within_limit limit d e =
  let least = Rat.sub (Rat.div (Rat.of_int 2) (Rat.mul limit limit)) Rat.one in
  let product = dot d e in
  let squares = Rat.compare (Rat.mul product product) (Rat.mul (Rat.mul least least) (Rat.mul (dot d d) (dot e
                                                                                                           e))) in
  if Rat.sign product >= 0 then Rat.sign least <= 0 || squares >= 0 else Rat.sign least < 0 && squares <= 0

let join p c d e =
  match outer p d e with
  | None -> straight_on p c d e
  | Some (u, v) -> (
      match p.stroke.join with
      | Round -> wide_sector p c u v ~middle:(ahead p d e)
      | Miter limit when Rat.sign (cross d e) <> 0 && within_limit limit d e ->
        (* The tip is at the multiple of u + v whose projection on u is u. *)
        let r = dot u u in
        let tip = Rat.div r (Rat.add r (dot u v)) *: (u +: v) in
        quadrangle p c (c +: u) (c +: tip) (c +: v)
      | Miter _ | Bevel -> triangle p c (c +: u) (c +: v))

(* At the end of a line that arrives in a direction. *)
let cap p c d =
  let ahead = forth p d in
  let u = turned ahead in
  match p.stroke.cap with
  | Butt -> ()
  | Square -> both_sides p c (c +: ahead) u
  | Round_cap ->
    sector p c u ahead;
    sector p c ahead (minus u)

(* {1 Lines} *)

let chord p a b = both_sides p a b (normal p (b -: a))

let strand p (s : Svg_chain.strand) =
  let rec along d = function
    | a :: (b :: _ as rest) ->
      let e = b -: a in
      bend p a d e;
      chord p a b;
      along e rest
    | [ last ] -> bend p last d s.arrives
    | [] -> ()
  in
  along s.leaves s.places

let first_place (s : Svg_chain.strand) = List.hd s.places
let last_place (s : Svg_chain.strand) = List.nth s.places (List.length s.places - 1)

let rec joined p = function
  | (s : Svg_chain.strand) :: (t :: _ as rest) ->
    join p (first_place t) s.arrives t.leaves;
    joined p rest
  | [ _ ] | [] -> ()

(* Strands that follow each other, closed to a ring or with two ends. *)
let run p ~closed = function
  | [] -> ()
  | first :: _ as strands ->
    let last = List.nth strands (List.length strands - 1) in
    List.iter (strand p) strands;
    joined p strands;
    if closed then join p (first_place first) last.Svg_chain.arrives first.leaves
    else begin
      cap p (first_place first) (minus first.leaves);
      cap p (last_place last) last.arrives
    end

let dot_at p c =
  match p.stroke.cap with
  | Butt -> ()
  | Round_cap -> disc p c
  | Square ->
    let u = (p.half, Rat.zero) in
    cap p c u;
    cap p c (minus u)

let put p = function
  | Svg_dash.Ring strands -> run p ~closed:true strands
  | Open strands -> run p ~closed:false strands
  | Dot (place, along) ->
    cap p place along;
    cap p place (minus along)

let triangles ~budget map (stroke : t) outline =
  let rec power k size = if Rat.compare size Rat.one <= 0 then k else power (k + 1) (Rat.mul Rat.half size) in
  let scale = Rat.power_of_two (power 0 (Plane_map.stretch map)) in
  let scaled = Plane_map.scaling scale scale and back = Rat.div Rat.one scale in
  let half = Rat.mul scale stroke.half in
  let p : pen = { map = Plane_map.compose map (Plane_map.scaling back back); half; stroke; budget; found = [] } in
  let dashed = stroke.dashes <> [] in
  (* With dashes, the lengths of chords count, so that they are half as long. *)
  let check place = Svg_polygon.check (Plane_map.apply p.map place) in
  let lines = Svg_chain.lines ~budget ~check ~share:(if dashed then 4 * each else each) ~half scaled outline in
  let runs =
    if not dashed then fun (line : Svg_chain.line) ->
      [ (if line.closed then Svg_dash.Ring line.strands else Open line.strands) ]
    else
      let times = Rat.mul scale in
      Svg_dash.(cut ~budget (pattern (List.map times stroke.dashes) ~offset:(times stroke.offset)))
  in
  let one (line : Svg_chain.line) =
    if line.strands <> [] then List.iter (put p) (runs line) else if not dashed then dot_at p line.start
  in
  List.iter one lines;
  p.found
