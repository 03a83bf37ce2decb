open Scc_exact
open Svg_curve

type strand = { places : Plane_map.point list; leaves : Plane_map.point; arrives : Plane_map.point }
type line = { strands : strand list; start : Plane_map.point; closed : bool }

(* [here] and [start] are in units of the drawing; strands and lines are in reverse. *)
type pen = {
  map : Plane_map.t;
  share : int;
  half : Rat.t;
  check : Plane_map.point -> unit;
  budget : Svg_polygon.budget;
  mutable here : Plane_map.point;
  mutable start : Plane_map.point;
  mutable begun : bool;
  mutable strands : strand list;
  mutable lines : line list;
}

let on p place = Plane_map.apply p.map place

(* The bits by which directions count: those of the angle by which a normal may be off, twice. *)
let turning (p : pen) = 2 * Rat.log_above (Rat.mul p.half (Rat.of_int p.share))

(* Places are so near that chords which [first] cuts keep their directions. *)
let fine p (x, y) =
  let quantum = Rat.power_of_two (-(20 + turning p)) in
  (Rat.round_to x ~quantum, Rat.round_to y ~quantum)

(* A normal of the length [half] turns by half |d x c| / (|d| |c|) at most, between the directions d and c. *)
let near (p : pen) d c =
  let turn = Rat.mul (Rat.mul p.half (Rat.of_int p.share)) (cross d c) in
  Rat.sign (dot d c) > 0 && Rat.compare (Rat.mul turn turn) (Rat.mul (dot d d) (dot c c)) <= 0

(* The first chord of a curve is halved until its direction is near that of the curve. *)
let first p ~place ~middle direction parameters =
  let rec go k = function
    | a :: b :: rest when k > 0 && not (near p direction (place b -: place a)) ->
      go (k - 1) (a :: middle a b :: b :: rest)
    | all -> all
  in
  go 30 parameters

let put p ~leaves ~arrives places =
  let add found q = match found with p :: _ when same p q -> found | _ -> q :: found in
  match List.rev (List.fold_left add [] places) with
  | [] | [ _ ] -> ()
  | places -> p.strands <- { places; leaves; arrives } :: p.strands

(* [place] makes points of parameters, of which the first and the last are those of [here] and [stop]. *)
let curve p ~place ~middle ~leaves ~arrives parameters stop =
  let there = first p ~place ~middle leaves parameters in
  let last = first p ~place ~middle:(fun a b -> middle b a) (Rat.of_int (-1) *: arrives) (List.rev there) in
  let inner = match last with [] -> [] | _ :: before -> List.rev_map (fun t -> fine p (place t)) before in
  let inner = match inner with [] -> [] | _ :: after -> after in
  Svg_polygon.spend p.budget (List.length inner);
  put p ~leaves ~arrives ((on p p.here :: inner) @ [ on p stop ])

let bezier_curve p controls stop =
  let points = List.map (on p) (p.here :: controls) in
  let away points = List.find_map (fun q -> if same q (List.hd points) then None else Some (q -: List.hd
                                                                                              points)) points in
  match (away points, away (List.rev points)) with
  | Some leaves, Some back ->
    check_places ~check:p.check points;
    let n = pieces ~share:p.share points in
    Svg_polygon.spend p.budget n;
    let parameters = List.init (n + 1) (fun i -> Rat.make (Z.of_int i) (Z.of_int n)) in
    curve p ~place:(fun t -> bezier t points) ~middle:Rat.middle ~leaves ~arrives:(Rat.of_int (-1) *: back)
      parameters stop
  | _ -> ()

(* By how much a map changes angles at most, in bits. *)
let skew (m : Plane_map.t) =
  let area = Rat.sub (Rat.mul m.a m.d) (Rat.mul m.b m.c) and most = Plane_map.stretch m in
  if Rat.sign area = 0 then 0 else Rat.log_above (Rat.div (Rat.mul most most) area)

let arc_curve p (c : circular) stop =
  let map = Plane_map.compose p.map c.map in
  let points = arc_points ~share:p.share ~check:p.check map c in
  Svg_polygon.spend p.budget (List.length points);
  let along (x, y) = if c.forward then (Rat.neg y, x) else (y, Rat.neg x) in
  let direction u = Plane_map.apply map (along u) -: Plane_map.apply map (Rat.zero, Rat.zero) in
  curve p ~place:(Plane_map.apply map) ~middle:(middle c) ~leaves:(direction c.start) ~arrives:(direction c.stop)
    points stop

let arc p (arc : Svg_segment.arc) stop ~straight =
  let extra = turning p + (2 * skew p.map) in
  match circular ~stretch:(Plane_map.stretch p.map) ~extra p.here arc with
  | None -> straight stop
  | Some c -> arc_curve p c stop

let straight p place =
  Svg_polygon.spend p.budget 1;
  let a = on p p.here and b = on p place in
  let along = b -: a in
  put p ~leaves:along ~arrives:along [ a; b ]

let finish p ~closed =
  if p.begun then p.lines <- { strands = List.rev p.strands; start = on p p.start; closed } :: p.lines;
  p.strands <- [];
  p.begun <- false

let segment p (segment : Svg_segment.t) =
  let goes draw stop =
    p.begun <- true;
    draw stop;
    p.here <- stop
  in
  match segment with
  | Move place ->
    finish p ~closed:false;
    p.here <- place;
    p.start <- place
  | Line place -> goes (straight p) place
  | Curve controls -> goes (bezier_curve p controls) (List.nth controls (List.length controls - 1))
  | Arc a ->
    goes (arc p a ~straight:(straight p)) a.stop
  | Close ->
    goes (straight p) p.start;
    finish p ~closed:true

let lines ~budget ~check ~share ~half map outline =
  let origin = (Rat.zero, Rat.zero) in
  let p =
    {
      map; share; half; check; budget; here = origin; start = origin; begun = false; strands = []; lines = [];
    }
  in
  outline (segment p);
  finish p ~closed:false;
  List.rev p.lines
