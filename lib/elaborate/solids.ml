open Scc_base
open Scc_exact
open Scc_geometry
open Scc_syntax

let ( let* ) = Option.bind

(* {1 Hulls} *)

let max_points = 100

let sub3 points i j = Vec.sub (snd points.(j)) (snd points.(i))
let normal points i j k = Vec.cross (sub3 points i j) (sub3 points i k)

(* The points of the plane through three of them, and the normal away from the others; nothing if others are on
   both
   sides of it. *)
let supporting points i j k =
  let n = normal points i j k in
  let height p = Rat.sign (Vec.dot n (sub3 points i p)) in
  let rec look p side inside =
    if p = Array.length points then if side > 0 then Some (Vec.neg n, inside) else Some (n, inside)
    else
      let h = height p in
      if h = 0 then look (p + 1) side (p :: inside)
      else if side * h < 0 then None
      else look (p + 1) h inside
  in
  if Vec.is_zero n then None else look 0 0 []

(* The corners of the convex polygon that coplanar points span, counter-clockwise about the normal: from each
   corner
   the next is the one that has no other on its right, the farther one of two in one line. *)
let polygon points n inside =
  let turn a b c = Rat.sign (Vec.dot n (Vec.cross (sub3 points a b) (sub3 points a c))) in
  let farther a b c = Rat.compare (Vec.norm2 (sub3 points a c)) (Vec.norm2 (sub3 points a b)) > 0 in
  let next a =
    let better b c =
      if Vec.is_zero (sub3 points a c) then b
      else
        match b with
        | None -> Some c
        | Some b ->
          let t = turn a b c in
          if t < 0 || (t = 0 && farther a b c) then Some c else Some b
    in
    List.fold_left better None inside
  in
  let start =
    let least a b = if Vec.compare (snd points.(b)) (snd points.(a)) < 0 then b else a in
    List.fold_left least (List.hd inside) inside
  in
  let rec round corners a =
    match next a with
    | Some b when b <> start -> round (b :: corners) b
    | Some _ | None -> List.rev corners
  in
  round [ start ] start

(* Each face once: by the first three of its points in order that are in no line. *)
let faces points =
  let n = Array.length points in
  let seen = Hashtbl.create 32 and found = ref [] in
  for i = 0 to n - 3 do
    for j = i + 1 to n - 2 do
      for k = j + 1 to n - 1 do
        match supporting points i j k with
        | Some (outward, inside) when not (Hashtbl.mem seen inside) ->
          Hashtbl.add seen inside ();
          found := polygon points outward inside :: !found
        | Some _ | None -> ()
      done
    done
  done;
  List.rev !found

(* Names for that many faces: f1, f2, …, without those of points. *)
let face_names points count =
  let taken name = Array.exists (fun (n, _) -> String.equal n name) points in
  let rec from i left =
    let name = Printf.sprintf "f%d" i in
    if left = 0 then []
    else if taken name then from (i + 1) left
    else name :: from (i + 1) (left - 1)
  in
  from 1 count

let distinct points =
  let add kept (n, v) = if List.exists (fun (_, w) -> Vec.equal v w) kept then kept else (n, v) :: kept in
  Array.of_list (List.rev (List.fold_left add [] points))

let is_flat points =
  let n = Array.length points in
  let rec off_plane i j k =
    if k >= n then true
    else
      let normal = normal points i j k in
      if Vec.is_zero normal then off_plane i j (k + 1)
      else not (Array.exists (fun (_, v) -> Rat.sign (Vec.dot normal (Vec.sub v (snd points.(i)))) <> 0) points)
  in
  n < 4 || off_plane 0 1 2

let hull report at list =
  let points = distinct list in
  if List.length list > max_points then begin
    Report.error report Code.too_deep at "this hull has more than %d points" max_points;
    None
  end
  else if is_flat points then begin
    Report.error report Code.no_solid at "these points span no solid: all of them are in one plane";
    None
  end
  else
    let faces = faces points in
    let corner i = List.exists (List.exists (Int.equal i)) faces in
    let kept = List.filter corner (List.init (Array.length points) Fun.id) in
    let place i =
      let rec find at = function
        | [] -> Bug.fail __POS__ "a corner that is none"
        | k :: rest -> if k = i then at else find (at + 1) rest
      in
      find 0 kept
    in
    let names = face_names points (List.length faces) in
    Some
      {
        Polyhedron.ifs_vertices = Array.of_list (List.map (fun i -> points.(i)) kept);
        ifs_faces =
          Array.of_list
            (List.map2 (fun name face -> (name, Array.of_list (List.map place face))) names faces);
      }

(* {1 Points of the circle}

   For a rational t, ((1 - t^2)/(1 + t^2), 2t/(1 + t^2)) is a point of the unit circle, and t the tangent
   of half its
   angle. That of the angle 2 pi k/n is irrational but for quarters: t is taken to the next multiple of
   2^-10, in the
   first eighth of the circle, of which the others are images. *)

let int = Rat.of_int
let fraction a b = Rat.div (int a) (int b)
let grid = fraction 1 1024
let pi =
  let digits = Z.of_string "314159265358979323846264338327950288" in
  Rat.make digits (Z.pow (Z.of_int 10) 35)

(* By their series, whose terms are below 2^-60 from the tenth on where 0 <= x < 1/2. *)
let tangent x =
  let square = Rat.mul x x in
  let rec series term k sum =
    if k > 20 then sum
    else
      let next = Rat.neg (Rat.div (Rat.mul term square) (int ((k + 1) * (k + 2)))) in
      series next (k + 2) (Rat.add sum term)
  in
  Rat.div (series x 1 Rat.zero) (series Rat.one 0 Rat.zero)

let in_first_eighth turn =
  let t = Rat.round_to (tangent (Rat.mul pi turn)) ~quantum:grid in
  let t2 = Rat.mul t t in
  let d = Rat.add Rat.one t2 in
  (Rat.div (Rat.sub Rat.one t2) d, Rat.div (Rat.mul (int 2) t) d)

(* At k/n of a full turn. *)
let on_circle n k =
  let quarters = 4 * k / n in
  let rest = Rat.sub (fraction k n) (fraction quarters 4) in
  let x, y =
    if Rat.compare rest (fraction 1 8) <= 0 then in_first_eighth rest
    else
      let y, x = in_first_eighth (Rat.sub (fraction 1 4) rest) in
      (x, y)
  in
  match quarters with
  | 0 -> (x, y)
  | 1 -> (Rat.neg y, x)
  | 2 -> (Rat.neg x, Rat.neg y)
  | _ -> (y, Rat.neg x)

(* {1 Solids that need no import} *)

let at_height r z (x, y) = Vec.make (Rat.mul r x) (Rat.mul r y) z
let numbered letter i = Printf.sprintf "%s%d" letter (i + 1)
let half q = Rat.div q (int 2)
let ifs vertices faces = { Polyhedron.ifs_vertices = Array.of_list vertices; ifs_faces = Array.of_list faces }

let box a b c =
  let x = half a and y = half b and z = half c in
  let corner name sx sy sz =
    let signed s q = if s then q else Rat.neg q in
    (name, Vec.make (signed sx x) (signed sy y) (signed sz z))
  in
  ifs
    [
      corner "a" false false false; corner "b" true false false; corner "c" true true false;
      corner "d" false true false; corner "e" false false true; corner "f" true false true;
      corner "g" true true true; corner "h" false true true;
    ]
    [
      ("bottom", [| 0; 3; 2; 1 |]); ("top", [| 4; 5; 6; 7 |]); ("left", [| 0; 4; 7; 3 |]);
      ("right", [| 1; 2; 6; 5 |]); ("front", [| 0; 1; 5; 4 |]); ("back", [| 3; 7; 6; 2 |]);
    ]

let ring letter n r z angle = List.init n (fun i -> (numbered letter i, at_height r z (angle i)))
let bottom n = ("bottom", Array.init n (fun i -> n - 1 - i))

let prism n r h =
  let z = half h in
  let side i =
    let j = (i + 1) mod n in
    (numbered "side" i, [| i; j; n + j; n + i |])
  in
  ifs
    (ring "b" n r (Rat.neg z) (on_circle n) @ ring "t" n r z (on_circle n))
    (bottom n :: ("top", Array.init n (fun i -> n + i)) :: List.init n side)

(* The corners of the top are between those of the bottom. *)
let antiprism n r h =
  let z = half h in
  let even i = on_circle (2 * n) (2 * i) and odd i = on_circle (2 * n) ((2 * i) + 1) in
  let up i = (numbered "up" i, [| i; (i + 1) mod n; n + i |]) in
  let down i =
    let j = (i + 1) mod n in
    (numbered "down" i, [| j; n + j; n + i |])
  in
  ifs
    (ring "b" n r (Rat.neg z) even @ ring "t" n r z odd)
    ((bottom n :: ("top", Array.init n (fun i -> n + i)) :: List.init n up) @ List.init n down)

(* Its centroid is a quarter of the height above the base, where the origin is. *)
let pyramid n r h =
  let base = Rat.neg (Rat.div h (int 4)) in
  let side i = (numbered "side" i, [| i; (i + 1) mod n; n |]) in
  ifs
    (ring "b" n r base (on_circle n) @ [ ("apex", Vec.make Rat.zero Rat.zero (Rat.add base h)) ])
    (bottom n :: List.init n side)

let names = [ "antiprism(_,_,_)"; "box(_,_,_)"; "prism(_,_,_)"; "pyramid(_,_,_)" ]
let max_corners = 256

let wrong report (r : Ast.reference) takes =
  Report.error report Code.bad_arity r.target.at "`%s` takes %s" r.target.it takes;
  None

let positive report (r : Ast.reference) numbers =
  if List.for_all (fun q -> Rat.sign q > 0) numbers then Some ()
  else begin
    Report.error report Code.bad_value r.target.at "the lengths of `%s` must be positive" r.target.it;
    None
  end

let made_box report r (arguments : Env.value list) =
  match arguments with
  | [ Number a; Number b; Number c ] | [ Vector { x = a; y = b; z = c } ] ->
    let* () = positive report r [ a; b; c ] in
    Some (box a b c)
  | _ -> wrong report r "three lengths, as in `box(2, 1, 1)`, or a vector of them"

let round report (r : Ast.reference) make (arguments : Env.value list) =
  match arguments with
  | [ Number n; Number radius; Number height ] ->
    let corners = if Rat.is_integer n && Rat.bits n < 40 then Z.to_int (Rat.floor n) else 0 in
    if corners < 3 || corners > max_corners then begin
      Report.error report Code.bad_value r.target.at "`%s` has from 3 to %d corners, and not %s" r.target.it
        max_corners (Rat.to_string n);
      None
    end
    else
      let* () = positive report r [ radius; height ] in
      Some (make corners radius height)
  | _ -> wrong report r (Printf.sprintf "the number of corners, the radius and the height, as in `%s(6, 1, \
                                         2)`" r.target.it)

let find report (r : Ast.reference) (reference : Family.reference) =
  match (r.qualifier, r.indices, r.arguments, r.target.it) with
  | Some _, _, _, _ | _, _ :: _, _, _ | _, _, [], _ -> None
  | None, [], _ :: _, "box" -> Some (made_box report r reference.arguments)
  | None, [], _ :: _, "prism" -> Some (round report r prism reference.arguments)
  | None, [], _ :: _, "antiprism" -> Some (round report r antiprism reference.arguments)
  | None, [], _ :: _, "pyramid" -> Some (round report r pyramid reference.arguments)
  | None, [], _ :: _, _ -> None
