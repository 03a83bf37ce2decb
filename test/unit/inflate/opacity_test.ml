(* SVG: paints that are not opaque, one over the other. *)
open Scc_exact
open Scc_pixels
open Areas

(* {1 Random groups} *)

(* What lets through the share 1 - a of the light behind it where something of it is; areas are in units. *)
type tree =
  | Rect of { x : int; y : int; side : int; opacity : int; how : int }
  | Group of int * tree list

let generator =
  let open QCheck2.Gen in
  (* Of fifths and eighths, so that products may be exactly a half. *)
  let opacity = oneofl [ 200; 375; 400; 500; 600; 625; 800; 1000 ] in
  let rect =
    map (fun ((x, y, side), (opacity, how)) -> Rect { x; y; side; opacity; how })
      (pair (triple (int_bound 5) (int_bound 5) (int_range 1 5)) (pair opacity (int_bound 5)))
  in
  let trees =
    fix (fun self depth ->
        if depth = 0 then rect
        else begin
          let inner = list_size (int_range 0 4) (self (depth - 1)) in
          frequency [ (2, rect); (1, map2 (fun a trees -> Group (a, trees)) opacity inner) ]
        end)
  in
  list_size (int_range 1 6) (trees 3)

let share n = Rat.make (Z.of_int n) (Z.of_int 1000)
let decimal n = Printf.sprintf "%d.%03d" (n / 1000) (n mod 1000)

let rec written = function
  | Group (a, trees) ->
    Printf.sprintf "<g opacity='%s'>%s</g>" (decimal a) (String.concat "" (List.map written trees))
  | Rect { x; y; side; opacity; how } ->
    let a = decimal opacity in
    let paint =
      match how with
      | 0 -> Printf.sprintf "opacity='%s'" a
      | 1 -> Printf.sprintf "fill-opacity='%s'" a
      | 2 -> Printf.sprintf "style='fill:rgb(1 2 3 / %s)'" a
      | 3 -> Printf.sprintf "fill='url(#g%d)'" opacity
      | 4 -> Printf.sprintf "style='opacity:%s;fill:red'" a
      (* The stroke covers the same pixels as the fill: one layer. *)
      | _ -> Printf.sprintf "opacity='%s' stroke='red' stroke-width='.5'" a
    in
    Printf.sprintf "<rect x='%d' y='%d' width='%d' height='%d' %s/>" x y side side paint

let gradients =
  List.map
    (fun n ->
       Printf.sprintf "<linearGradient id='g%d'><stop stop-opacity='%s'/><stop offset='1' stop-color='red' \
                       stop-opacity='%s'/></linearGradient>" n (decimal n) (decimal n))
    [ 200; 375; 400; 500; 600; 625; 800; 1000 ]
  |> String.concat ""

let rec through x y tree =
  match tree with
  | Rect r ->
    let inside = x >= r.x && x < r.x + r.side && y >= r.y && y < r.y + r.side in
    if inside then Rat.sub Rat.one (share r.opacity) else Rat.one
  | Group (a, trees) -> Rat.sub Rat.one (Rat.mul (share a) (Rat.sub Rat.one (behind x y trees)))

and behind x y trees = List.fold_left (fun q tree -> Rat.mul q (through x y tree)) Rat.one trees

let random trees =
  let body = gradients ^ String.concat "" (List.map written trees) in
  let r = ok ~resolution:10 body (svg ~box:"0 0 10 10" body) in
  for y = 0 to 9 do
    for x = 0 to 9 do
      let expected = Rat.compare (behind x y trees) Rat.half <= 0 in
      if inside r x y <> expected then QCheck2.Test.fail_reportf "pixel %d, %d: %b" x y (not expected)
    done
  done;
  true

(* {1 Cases} *)

let pixel body =
  match read ~resolution:1 (svg ~box:"0 0 1 1" body) with
  | Error d -> (d.code :> string)
  | Ok r -> if inside r 0 0 then Raster.colour_text r.colours.(0) else "none"

let rect properties = Printf.sprintf "<rect width='1' height='1' %s/>" properties
let times n text = String.concat "" (List.init n (fun _ -> text))

let cases () =
  let is name expected body = Alcotest.(check string) name expected (pixel body) in
  let both = rect "opacity='.4'" ^ rect "opacity='.4'" in
  is "two" "#000000" both;
  is "two in a group" "none" ("<g opacity='.7'>" ^ both ^ "</g>");
  is "two that inherit one" "#000000" ("<g fill-opacity='.4'>" ^ times 2 (rect "") ^ "</g>");
  is "exactly a half" "#000000" (rect "opacity='.2'" ^ rect "opacity='.375'");
  is "just less" "none" (rect "opacity='.2'" ^ rect "opacity='.37499999'");
  is "a use" "none" ("<defs><g id='a' opacity='.7'>" ^ both ^ "</g></defs><use href='#a'/>");
  is "uses" "#000000" ("<defs><g id='a' opacity='.7'>" ^ both ^ "</g></defs>" ^ times 2 "<use href='#a'/>");
  is "a use that is not opaque" "none" ("<defs><g id='a'>" ^ both ^ "</g></defs><use opacity='.7' href='#a'/>");
  is "an inner drawing" "none" ("<svg opacity='.7'>" ^ both ^ "</svg>");
  is "the last opacity counts" "none" ("<g opacity='.9' style='opacity:.45'>" ^ rect "" ^ "</g>");
  is "black over white" "#666666" (rect "fill='white'" ^ rect "opacity='.6'");
  is "red over blue" "#990066" (rect "fill='blue'" ^ rect "fill='red' fill-opacity='.6'");
  is "red over little blue" "#aa0055" (rect "fill='blue' opacity='.5'" ^ rect "fill='red' opacity='.5'");
  is "fill and stroke as one" "none" (rect "stroke='red' stroke-width='3' opacity='.4'");
  is "fill and stroke, each by itself" "#9f0000"
    (rect "stroke='red' stroke-width='3' fill-opacity='.4' stroke-opacity='.4'");
  is "as many as may be" "#000000" (times 300 (rect "opacity='.01'"));
  is "more than are composed" "SC0341" (times 3000 (rect "opacity='.01'"));
  is "as many on opaque ones" "#000000" (times 10 (times 300 (rect "opacity='.01'") ^ rect ""))

let gradients_of_opacity () =
  let is name expected stops body =
    let text = Printf.sprintf "<linearGradient id='g'>%s</linearGradient>%s" stops body in
    Alcotest.(check string) name expected (pixel text)
  in
  let rect = rect "fill='url(#g)'" in
  is "no stops" "none" "" rect;
  is "a stop of little opacity" "none" "<stop stop-opacity='.4'/>" rect;
  is "by its colour" "none" "<stop stop-color='#0004'/>" rect;
  is "by the current colour" "none" "<stop color='#0004' stop-color='currentColor'/>" rect;
  is "by a style" "none" "<stop style='stop-color:red;stop-opacity:40%'/>" rect;
  is "two of them" "#000000" "<stop stop-opacity='.4'/>" (rect ^ rect);
  is "from half on" "#000000" "<stop stop-opacity='.5'/><stop offset='1'/>" rect;
  is "below half" "none" "<stop stop-opacity='0'/><stop offset='1' stop-opacity='.49'/>" rect;
  is "from nothing to all" "SC0341" "<stop stop-opacity='0'/><stop offset='1'/>" rect;
  is "from nothing to all, over an opaque one" "#000000" "<stop stop-opacity='0'/><stop offset='1'/>"
    ("<rect width='1' height='1'/>" ^ rect);
  let other = "<rect fill='url(#h)' width='1' height='1'/>" in
  is "the stops of another one" "none" ""
    ("<linearGradient id='h' href='#i'/><radialGradient id='i'><stop stop-opacity='.4'/></radialGradient>"
     ^ other);
  is "one that refers to itself" "SC0340" "" ("<linearGradient id='h' href='#h'/>" ^ other)

let () =
  let case name f = Alcotest.test_case name `Quick f in
  let random = QCheck2.Test.make ~count:200 ~name:"random groups" generator random in
  Alcotest.run "opacity"
    [
      ("over each other", [ case "cases" cases; case "gradients" gradients_of_opacity ]);
      ("against light that comes through", [ Scc_test_support.Property.case random ]);
    ]
