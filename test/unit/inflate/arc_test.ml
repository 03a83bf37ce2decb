(* Arcs whose radii are large against their chords, as a share of a greater sweep: they are nearly straight,
   however large the quotient is. *)
open Scc_pixels
open Areas

let picture name body =
  let r = ok ~resolution:64 name (svg ~box:"0 0 64 64" body) in
  List.init (64 * 64) (fun k -> inside r (k mod 64) (k / 64))

let line = "24.37 24.71"
let text = Printf.sprintf "%.9f"

(* Chords of 1e-6 to 30, radii of 1e5 to 1e13 chords (and at most 10^9), circles and ellipses in any direction. *)
let nearly_straight () =
  let random = Random.State.make [| 25 |] in
  let float a b = a +. Random.State.float random (b -. a) in
  for k = 1 to 60 do
    let chord = 10. ** float (-6.) 1.4 and turn = float 0. 6.28 in
    let rx = Float.min 1e9 (chord *. (10. ** float 5. 13.)) in
    let ry = rx *. List.nth [ 1.; 1.; 0.7; 0.01 ] (k land 3) in
    let x = text (24.37 +. (chord *. cos turn)) and y = text (24.71 +. (chord *. sin turn)) in
    let angle = List.nth [ "0"; "30"; "-123.456"; "90"; "359.999" ] (k mod 5) in
    let shape = Printf.sprintf "A%s %s %s 0 %d %s %s" (text rx) (text ry) angle (k land 1) x y in
    let check what body =
      let name = Printf.sprintf "%s %d: %s" what k shape in
      let put part = picture name (body part) in
      if put shape <> put (Printf.sprintf "L%s %s" x y) then Alcotest.failf "%s is not straight" name
    in
    check "filled" (fun part -> Printf.sprintf "<path d='M%s%sL50.3 50.1L8.2 50.4z'/>" line part);
    if chord > 0.01 then
      check "stroke" (fun part ->
          Printf.sprintf "<path fill='none' stroke='red' stroke-width='%d' d='M%s%s'/>" (2 + (k mod 9)) line part)
  done

(* What the radii and flags make of an arc that is not nearly straight. *)
let others () =
  let d name path shape = area name (Printf.sprintf "<path d='%s'/>" path) shape in
  let disc = circle 20. 15. 12. in
  d "nearly a whole circle" "M32 15A12 12 0 1 1 32 14.999999z" disc;
  d "nearly a whole circle, the other way" "M32 15A12 12 0 1 0 32 15.000001z" disc;
  d "radii that are too small" "M8 15A.000001 .000001 45 0 1 32 15A1e-9 1e-9 45 1 1 8 15z" disc;
  d "a radius that fits, and one that is too small by little"
    "M8 15A12 12 0 0 1 32 15A11.999999999 11.999999999 0 0 1 8 15z" disc;
  d "ends where it starts, and a radius 0" "M8 15A5 5 0 1 1 8 15L28 15A0 9 30 1 0 28 25A9 0 0 0 1 8 25z"
    (box 8. 15. 28. 25.)

(* Far control points, too: they are refused soon. *)
let far () =
  let refused name path =
    let start = Sys.time () in
    (match Result.map fst @@ Svg_icon.read ~resolution:64 ~path:"t.svg" (svg ~box:"0 0 64 64" path) with
     | Ok _ -> Alcotest.failf "%s is read" name
     | Error d -> Alcotest.(check string) name "SC0340" d.code);
    if Sys.time () -. start > 1. then Alcotest.failf "%s takes %.1f s" name (Sys.time () -. start)
  in
  let both name d =
    refused name (Printf.sprintf "<path d='%s'/>" d);
    refused name (Printf.sprintf "<path fill='none' stroke='red' d='%s'/>" d)
  in
  both "a curve" "M8 8C1e9 1e9 -1e9 1e9 50 50"; both "a curve that begins slowly" "M8 8C8 8 8 1e9 1e9 1e9";
  both "a parabola" "M8 8Q1e9 0 50 50"; both "an ellipse" "M8 8A1e9 1e9 0 1 0 50 50";
  both "a thin ellipse" "M8 8A1e9 1 45 0 0 1e8 50"; both "a half of one" "M8 8A1 1 0 0 0 1e9 1e9"

let () =
  let case name f = Alcotest.test_case name `Quick f in
  Alcotest.run "arcs"
    [ ("arcs", [ case "nearly straight" nearly_straight; case "others" others; case "far" far ]) ]
