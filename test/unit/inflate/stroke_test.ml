(* Strokes of SVG against formulas of distance. *)
open Scc_pixels
open Areas
module G = QCheck2.Gen

let pen = "fill='none' stroke='red' stroke-width='4'"
let path ?(more = "") d = Printf.sprintf "<path %s %s d='%s'/>" pen more d

let caps () =
  let line more = path ~more "M10 10L25 18" in
  let a = (10., 10.) and b = (25., 18.) in
  area "butt" (line "") (bar a b 2.);
  area "round" (line "stroke-linecap='round'") (capsule a b 2.);
  let dx = 2. *. 15. /. 17. and dy = 2. *. 8. /. 17. in
  area "square" (line "stroke-linecap='square'") (bar (10. -. dx, 10. -. dy) (25. +. dx, 18. +. dy) 2.);
  area "a line" (Printf.sprintf "<line %s x1='10' y1='10' x2='25' y2='18'/>" pen) (bar a b 2.);
  area "no length, round" (path ~more:"stroke-linecap='round'" "M10 10z") (circle 10. 10. 2.);
  area "no length, square" (path ~more:"stroke-linecap='square'" "M10 10h0") (box 8. 8. 12. 12.);
  area "no length, butt" (path "M10 10h0M20 20h1" ) (box 20. 18. 21. 22.);
  area "a move alone" (path ~more:"stroke-linecap='round'" "M10 10M20 20h1") (capsule (20., 20.) (21., 20.) 2.)

let joins () =
  let corner more = path ~more "M10 25V10H30" in
  let arms = union (box 8. 10. 12. 25.) (box 10. 8. 30. 12.) in
  area "miter" (corner "") (union arms (box 8. 8. 12. 12.));
  area "round join" (corner "stroke-linejoin='round'") (union arms (circle 10. 10. 2.));
  area "bevel" (corner "stroke-linejoin='bevel'")
    (union arms (polygon [ (10., 8.); (10., 10.); (8., 10.) ]));
  (* 1/sin(45 degrees) = 1.414. *)
  area "within the limit" (corner "stroke-miterlimit='1.415'") (union arms (box 8. 8. 12. 12.));
  area "beyond the limit" (corner "stroke-miterlimit='1.414'")
    (union arms (polygon [ (10., 8.); (10., 10.); (8., 10.) ]));
  area "the other way" (path "M30 10H10V25") (union arms (box 8. 8. 12. 12.));
  let sides = without (box 8. 8. 32. 22.) (box 12. 12. 28. 18.) in
  area "closed" (path "M10 10h20v10h-20z") sides;
  area "closed by the last line too" (path "M10 10h20v10h-20v-10z") sides;
  area "rect" (Printf.sprintf "<rect %s x='10' y='10' width='20' height='10'/>" pen) sides;
  area "polygon" (Printf.sprintf "<polygon %s points='10 10 30 10 30 20 10 20'/>" pen) sides;
  area "polyline" (Printf.sprintf "<polyline %s points='10 25 10 10 30 10'/>" pen)
    (union arms (box 8. 8. 12. 12.));
  area "fill and stroke" "<rect stroke='red' stroke-width='4' x='10' y='10' width='20' height='10'/>"
    (box 8. 8. 32. 22.);
  area "back on itself, round" (path ~more:"stroke-linejoin='round'" "M10 10h10h-10")
    (union (box 10. 8. 20. 12.) (circle 20. 10. 2.));
  area "back on itself, miter" (path "M10 10h10h-10") (box 10. 8. 20. 12.)

let curves () =
  area "circle" (Printf.sprintf "<circle %s cx='20' cy='15' r='10'/>" pen) (ring 20. 15. 10. 2.);
  area "a pen wider than the circle" "<circle fill='none' stroke='red' stroke-width='8' cx='20' cy='15' r='3'/>"
    (circle 20. 15. 7.);
  area "half a circle" (path "M10 15A10 10 0 0 1 30 15") (both (ring 20. 15. 10. 2.) (fun _ y -> y -. 15.));
  area "a quarter" (path "M20 5A10 10 0 0 1 30 15")
    (both (ring 20. 15. 10. 2.) (both (fun _ y -> y -. 15.) (fun x _ -> 20. -. x)));
  let round = "stroke-linecap='round'" in
  area "with round ends" (path ~more:round "M10 15A10 10 0 0 1 30 15")
    (any [ both (ring 20. 15. 10. 2.) (fun _ y -> y -. 15.); circle 10. 15. 2.; circle 30. 15. 2. ]);
  (* Straight lines as curves. *)
  area "a straight cubic" (path "M10 10C15 12.6666666667 20 15.3333333333 25 18") (bar (10., 10.) (25., 18.) 2.);
  area "a curve that waits" (path "M10 10C10 10 25 18 25 18") (bar (10., 10.) (25., 18.) 2.);
  area "scaled" "<g transform='translate(20 15) scale(2)'><circle fill='none' stroke='red' stroke-width='2' \
                 r='5'/></g>"
    (ring 0. 0. 10. 2. |> fun f x y -> f (x -. 20.) (y -. 15.));
  (* A circle of radius 1 with a pen of width 1, four times as wide as high: an ellipse without a smaller one. *)
  let stretched x y =
    let u = (x -. 20.) /. 8. and v = (y -. 15.) /. 2. in
    let h = Float.hypot u v in
    (* The distance is about the value over the length of its gradient. *)
    if h = 0. then 1. else
      let slope = Float.hypot (u /. h /. 8.) (v /. h /. 2.) in
      (Float.abs (h -. 1.) -. 0.5) /. slope /. 2.
  in
  area "stretched" "<g transform='translate(20 15) scale(8 2)'><circle fill='none' stroke='red' r='1'/></g>"
    stretched

let dashes () =
  let dashed ?(more = "") lengths d = path ~more:(Printf.sprintf "stroke-dasharray='%s' %s" lengths more) d in
  area "dashes" (dashed "4 2" "M5 10h20")
    (any [ box 5. 8. 9. 12.; box 11. 8. 15. 12.; box 17. 8. 21. 12.; box 23. 8. 25. 12. ]);
  area "an odd number" (dashed "5" "M5 10h20") (any [ box 5. 8. 10. 12.; box 15. 8. 20. 12. ]);
  area "an offset" (dashed ~more:"stroke-dashoffset='3'" "4 2" "M5 10h8")
    (any [ box 5. 8. 6. 12.; box 8. 8. 12. 12. ]);
  area "an offset back" (dashed ~more:"stroke-dashoffset='-1'" "4 2" "M5 10h8")
    (union (box 6. 8. 10. 12.) (box 12. 8. 13. 12.));
  area "around a corner" (dashed "14 100" "M5 10h10v20") (any [ box 5. 8. 17. 12.; box 13. 8. 17. 14. ]);
  area "dots" (dashed ~more:"stroke-linecap='round'" "0 8" "M5 10h18")
    (any [ circle 5. 10. 2.; circle 13. 10. 2.; circle 21. 10. 2. ]);
  area "no length" (dashed ~more:"stroke-linecap='round'" "4 2" "M5 10zM20 10h1")
    (capsule (20., 10.) (21., 10.) 2.);
  area "all lengths 0" (dashed "0 0" "M5 10h20") (box 5. 8. 25. 12.);
  (* The last dash goes on where the line began: no caps there, but a join. *)
  area "closed" (dashed ~more:"stroke-dashoffset='5'" "10 10" "M10 10h20v10h-20z")
    (any [ box 8. 8. 15. 12.; box 8. 8. 12. 15.; box 25. 8. 32. 12.; box 28. 8. 32. 15.; box 15. 18. 25. 22. ]);
  area "a ring of one dash" (dashed "100 1" "M10 10h20v10h-20z")
    (without (box 8. 8. 32. 22.) (box 12. 12. 28. 18.));
  (* A quarter of a circle is drawn, the next one not. *)
  let quarters x y = -.((x -. 20.) *. (y -. 15.)) /. Float.hypot (x -. 20.) (y -. 15.) in
  area "on a circle"
    (Printf.sprintf "<circle %s stroke-dasharray='%.9f' cx='20' cy='15' r='10'/>" pen (Float.pi *. 5.))
    (both (ring 20. 15. 10. 2.) quarters)

(* {1 Random things} *)

(* A stroke of segments with round caps and joins is what is near to them. *)
let round_strokes =
  let open G in
  let coordinate = int_range 4 36 in
  let* corners = list_size (int_range 2 6) (pair coordinate (int_range 4 26)) and* width = int_range 1 6 and*
    closed = bool in
  return (corners, width, closed)

let show (corners, width, closed) =
  let d = String.concat " L" (List.map (fun (x, y) -> Printf.sprintf "%d %d" x y) corners) in
  Printf.sprintf "<path fill='none' stroke='red' stroke-linecap='round' stroke-linejoin='round' \
                  stroke-width='%d' d='M%s%s'/>" width d (if closed then "Z" else "")

let near_segments ((corners, width, closed) as drawn) =
  let point (x, y) = (float_of_int x, float_of_int y) in
  let rec pairs = function
    | a :: (b :: _ as rest) -> (a, b) :: pairs rest
    | [ last ] -> if closed then [ (last, List.hd corners) ] else []
    | [] -> []
  in
  let half = float_of_int width /. 2. in
  let one (a, b) = if a = b then circle (fst (point a)) (snd (point a)) half else capsule (point a) (point b)
        half in
  area "random" (show drawn) (any (List.map one (pairs corners)));
  true

(* All strokes of a line lie within that with round ends and joins grown by the miter limit; and a bevel within
   the miter. *)
let nested_joins (corners, width, closed) =
  let drawn join =
    let d = String.concat " L" (List.map (fun (x, y) -> Printf.sprintf "%d %d" x y) corners) in
    ok "joins" (svg (Printf.sprintf "<path fill='none' stroke='red' stroke-linejoin='%s' stroke-width='%d' \
                                     d='M%s%s'/>" join width d (if closed then "Z" else "")))
  in
  let bevel = drawn "bevel" and round = drawn "round" and miter = drawn "miter" in
  let within (a : Raster.t) (b : Raster.t) =
    let painted (r : Raster.t) i = Bytes.get r.alphas i <> '\000' in
    List.for_all (fun i -> (not (painted a i)) || painted b i) (List.init (Bytes.length a.alphas) Fun.id)
  in
  within bevel round && within bevel miter

(* Thick arcs of many chords, whose pieces leave no slit between them, away from the ends. *)
let thick_arc (r, width) =
  let r = float_of_int r /. 7. and half = float_of_int width /. 2. in
  let centre = 18. +. sqrt ((r *. r) -. 256.) in
  let d = Printf.sprintf "M4 18A%.9f %.9f 0 0 1 36 18" r r in
  area "arc" (Printf.sprintf "<path fill='none' stroke='red' stroke-width='%d' d='%s'/>" width d) (fun x y ->
      if Float.abs (x -. 20.) < 12. then ring 20. centre r half x y else nan);
  true

let () =
  let case name f = Alcotest.test_case name `Quick f in
  let property ?print name gen law = Scc_test_support.Property.case
      (QCheck2.Test.make ?print ~name ~count:10 gen law) in
  Alcotest.run "stroke"
    [
      ("strokes", [ case "caps" caps; case "joins" joins; case "curves" curves; case "dashes" dashes ]);
      ( "random",
        [
          property "thick arcs" G.(pair (int_range 140 2000) (int_range 2 8)) thick_arc;
          property ~print:show "near to segments" round_strokes near_segments;
          property ~print:show "bevels are within round joins and miters" round_strokes nested_joins;
        ] );
    ]
