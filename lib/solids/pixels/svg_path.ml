open Scc_exact
open Svg_number
open Svg_curve

let bad format = Printf.ksprintf (fun m -> raise (Bad m)) format
let origin = (Rat.zero, Rat.zero)

(* Where a path is while it is read. *)
type pen = { emit : Svg_segment.t -> unit; mutable here : Plane_map.point; mutable start : Plane_map.point }

let move p place =
  p.emit (Move place);
  p.here <- place;
  p.start <- place

let line p place =
  p.emit (Line place);
  p.here <- place

let curve p controls =
  p.emit (Curve controls);
  p.here <- List.nth controls (List.length controls - 1)

let arc p radii angle ~large ~sweep stop =
  p.emit (Arc { radii; angle; large; sweep; stop });
  p.here <- stop

let close p =
  p.emit Close;
  p.here <- p.start

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
  | 'Z' -> close p; Other
  | _ -> bad "path data with the unknown command %C" command

let path_data text emit =
  let p = { emit; here = origin; start = origin } in
  let c = cursor text in
  let letter () =
    let x = text.[c.at] in
    c.at <- c.at + 1;
    c.first <- true;
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
  next None Other

let path text emit = if not (String.equal (String.trim text) "none") then path_data text emit

(* {1 Basic shapes} *)

let points ~closed corners (emit : Svg_segment.t -> unit) =
  match corners with
  | [] -> ()
  | first :: rest ->
    emit (Move first);
    List.iter (fun place -> emit (Svg_segment.Line place)) rest;
    if closed then emit Close

let round radii stop = Svg_segment.Arc { radii; angle = Rat.zero; large = false; sweep = true; stop }

let ellipse (cx, cy) rx ry (emit : Svg_segment.t -> unit) =
  let at q = (Rat.add cx q, cy) in
  emit (Move (at rx));
  emit (round (rx, ry) (at (Rat.neg rx)));
  emit (round (rx, ry) (at rx));
  emit Close

let rectangle (x, y) (w, h) (rx, ry) (emit : Svg_segment.t -> unit) =
  let rx = Rat.min rx (Rat.mul Rat.half w) and ry = Rat.min ry (Rat.mul Rat.half h) in
  let right = Rat.add x w and bottom = Rat.add y h in
  let round = round (rx, ry) in
  List.iter emit
    [
      Move (Rat.add x rx, y); Line (Rat.sub right rx, y); round (right, Rat.add y ry);
      Line (right, Rat.sub bottom ry); round (Rat.sub right rx, bottom); Line (Rat.add x rx, bottom);
      round (x, Rat.sub bottom ry); Line (x, Rat.add y ry); round (Rat.add x rx, y); Close;
    ]
