open Scc_exact
open Svg_curve

type strand = { places : Plane_map.point list; leaves : Plane_map.point; arrives : Plane_map.point }
type line = { strands : strand list; start : Plane_map.point; closed : bool }

let fine (x, y) =
  let quantum = Rat.make Z.one (Z.of_int (1 lsl 20)) in
  (Rat.round_to x ~quantum, Rat.round_to y ~quantum)

(* [here] and [start] are in units of the drawing; strands and lines are in reverse. *)
type pen = {
  map : Plane_map.t;
  share : int;
  half : Rat.t;
  budget : Svg_polygon.budget;
  mutable here : Plane_map.point;
  mutable start : Plane_map.point;
  mutable begun : bool;
  mutable strands : strand list;
  mutable lines : line list;
}

let on p place = Plane_map.apply p.map place

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
  let inner = match last with [] -> [] | _ :: before -> List.rev_map (fun t -> fine (place t)) before in
  let inner = match inner with [] -> [] | _ :: after -> after in
  Svg_polygon.spend p.budget (List.length inner);
  put p ~leaves ~arrives ((on p p.here :: inner) @ [ on p stop ])

let bezier_curve p controls stop =
  let points = List.map (on p) (p.here :: controls) in
  let away points = List.find_map (fun q -> if same q (List.hd points) then None else Some (q -: List.hd
                                                                                              points)) points in
  match (away points, away (List.rev points)) with
  | Some leaves, Some back ->
    let n = pieces ~share:p.share points in
    Svg_polygon.spend p.budget n;
    let parameters = List.init (n + 1) (fun i -> Rat.make (Z.of_int i) (Z.of_int n)) in
    curve p ~place:(fun t -> bezier t points) ~middle:Rat.middle ~leaves ~arrives:(Rat.of_int (-1) *: back)
      parameters stop
  | _ -> ()

let arc_curve p ({ map; start; stop = last; forward } : circular) stop =
  let map = Plane_map.compose p.map map in
  let halvings = halvings ~share:p.share map in
  Svg_polygon.spend p.budget (1 lsl halvings);
  let middle u v = middle ~forward u v in
  let halve parameters =
    let add found v = match found with [] -> [ v ] | u :: _ -> v :: middle u v :: found in
    List.rev (List.fold_left add [] parameters)
  in
  let rec halved k parameters = if k = 0 then parameters else halved (k - 1) (halve parameters) in
  let along (x, y) = if forward then (Rat.neg y, x) else (y, Rat.neg x) in
  let direction u = Plane_map.apply map (along u) -: Plane_map.apply map (Rat.zero, Rat.zero) in
  curve p ~place:(Plane_map.apply map) ~middle ~leaves:(direction start) ~arrives:(direction last)
    (halved halvings [ start; last ])
    stop

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
    goes (fun stop -> match circular p.here a with None -> straight p stop | Some c -> arc_curve p c stop) a.stop
  | Close ->
    goes (straight p) p.start;
    finish p ~closed:true

let lines ~budget ~share ~half map outline =
  let origin = (Rat.zero, Rat.zero) in
  let p = { map; share; half; budget; here = origin; start = origin; begun = false; strands = []; lines = [] } in
  outline (segment p);
  finish p ~closed:false;
  List.rev p.lines
