open Scc_exact
open Svg_curve

type polygon = (int * int) list
type budget = int ref

let unit = 1024
let farthest = (1 lsl 14) * unit
let bad what = raise (Svg_number.Bad what)

let max_corners = 1_000_000

let spend budget n =
  budget := !budget - n;
  if !budget < 0 then
    raise (Svg_number.Beyond (Printf.sprintf "%d corners, those of curves and dashes included" max_corners))

let corner (x, y) =
  let grid q =
    let z = (Rat.round_to (Rat.mul q (Rat.of_int unit)) ~quantum:Rat.one).num in
    if Z.gt (Z.abs z) (Z.of_int farthest) then bad "something is drawn too far outside of the picture"
    else Z.to_int z
  in
  let x = grid x in
  (x, grid y)

(* The line that is being drawn has its corners in reverse. [here] and [start] are in the drawing's units. *)
type pen = {
  map : Plane_map.t;
  budget : budget;
  check : Plane_map.point -> unit;
  mutable here : Plane_map.point;
  mutable start : Plane_map.point;
  mutable corners : Plane_map.point list;
  mutable lines : Plane_map.point list list;
}

let draw p place =
  spend p.budget 1;
  p.corners <- place :: p.corners

let close p =
  if p.corners <> [] then p.lines <- p.corners :: p.lines;
  p.corners <- []

let begun p = if p.corners = [] then draw p (Plane_map.apply p.map p.here)

let line p place =
  begun p;
  draw p (Plane_map.apply p.map place);
  p.here <- place

(* Control points are taken to a fine grid, so that numbers stay short. *)
let fine (x, y) =
  let quantum = Rat.make Z.one (Z.of_int (1 lsl 20)) in
  (Rat.round_to x ~quantum, Rat.round_to y ~quantum)

(* Half of 1/64 pixel is left for rounding. *)
let share = 128

let curve p controls =
  begun p;
  let points = List.map (fun q -> fine (Plane_map.apply p.map q)) (p.here :: controls) in
  check_places ~check:p.check points;
  let n = pieces ~share points in
  for i = 1 to n do
    draw p (bezier (Rat.make (Z.of_int i) (Z.of_int n)) points)
  done;
  p.here <- List.nth controls (List.length controls - 1)

let arc p (arc : Svg_segment.arc) =
  match circular ~stretch:(Plane_map.stretch p.map) ~extra:0 p.here arc with
  | None -> if not (same p.here arc.stop) then line p arc.stop
  | Some c ->
    let map = Plane_map.compose p.map c.map in
    begun p;
    List.iter (fun u -> draw p (Plane_map.apply map u)) (List.tl (arc_points ~share ~check:p.check map c));
    p.here <- arc.stop

let drawn ~budget ~check map outline =
  let origin = (Rat.zero, Rat.zero) in
  let p = { map; budget; check; here = origin; start = origin; corners = []; lines = [] } in
  outline (function
      | Svg_segment.Move place ->
        close p;
        p.here <- place;
        p.start <- place
      | Line place -> line p place
      | Curve controls -> curve p controls
      | Arc a -> arc p a
      | Close ->
        begun p;
        close p;
        p.here <- p.start);
  close p;
  p.lines

let lines ~budget map outline = drawn ~budget ~check:ignore map outline
let check place = ignore (corner place)
let filled ~budget map outline = List.map (List.map corner) (drawn ~budget ~check map outline)
