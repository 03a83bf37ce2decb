open Scc_exact

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
