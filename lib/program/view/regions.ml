open Scc_exact
open Scc_polyhedra
open Scc_calculus
open Scc_regions
open Scc_json

let outcome : Plane.outcome -> string = function
  | Holds -> "holds"
  | Varies -> "varies"
  | Unknown -> "unknown"
  | Fails -> "fails"

let is_line (view : Plane.view) = Option.is_none view.up
let axes (view : Plane.view) = view.across :: Option.to_list view.up

(* Of a line, where it is alone; the drawing has a height of 1 there. *)
let point (p : Planar.point) = `List [ Json.rat p.x; Json.rat p.y ]

let region (r : Plane.region) =
  let outline = Outline.make r.set in
  let segment (a, b) = `List [ point a; point b ] in
  let border (b : Outline.border) =
    `Assoc [ ("ends", segment b.ends); ("belongs", `Bool b.belongs) ]
  in
  `Assoc
    [
      ("outcomes", `List (List.map (fun o -> `String (outcome o)) r.outcomes));
      ("polygons", `List (List.map (fun p -> `List (List.map point (Planar.corners p))) outline.polygons));
      ("borders", `List (List.map border outline.borders));
      ("lines", `List (List.map segment outline.lines));
      ("points", `List (List.map point outline.points));
      ("share", Json.rat r.share);
    ]

let axis (ranges : Ranges.t) i =
  let r = ranges.(i) in
  let bound (b : Ranges.bound) = `Assoc [ ("value", Json.rat b.value); ("included", `Bool b.included) ] in
  `Assoc [ ("name", Json.text r.name); ("low", bound r.low); ("high", bound r.high) ]

let sample (values, run) =
  `Assoc
    [ ("at", `Assoc (List.map (fun (name, v) -> (name, Json.rat v)) values)); ("run", `Int run) ]

let json ranges view named ~samples =
  let regions = Plane.regions ranges view (List.map snd named) in
  `Assoc
    [
      ("axes", `List (List.map (axis ranges) (axes view)));
      ("checks", `List (List.map (fun (name, _) -> Json.text name) named));
      ("regions", `List (List.map region regions));
      ("samples", `List (List.map sample samples));
    ]

(* {1 Starts} *)

(* So many on each side of the grid, and so many pieces at most. *)
let on_line = 17
let in_plane = 9
let most_pieces = 200

let interior p = Polyhedron.interior_point p

let grid (ranges : Ranges.t) view =
  let n = if is_line view then on_line else in_plane in
  let along i =
    let r = ranges.(i) in
    let part k = Rat.make (Z.of_int ((2 * k) + 1)) (Z.of_int (2 * n)) in
    List.init n (fun k -> Rat.add r.low.value (Rat.mul (part k) (Rat.sub r.high.value r.low.value)))
  in
  match axes view with
  | [ x ] -> List.map (fun a -> [ a ]) (along x)
  | [ x; y ] -> List.concat_map (fun b -> List.map (fun a -> [ a; b ]) (along x)) (along y)
  | _ -> []

let pieces ranges view where =
  let of_region (r : Plane.region) = List.filter_map interior (Union.pieces r.set) in
  Plane.regions ranges view where
  |> List.concat_map of_region
  |> List.filteri (fun i _ -> i < most_pieces)
  |> List.map (fun p -> List.filteri (fun i _ -> i < List.length (axes view)) (Array.to_list p))

let starts ranges (view : Plane.view) where =
  let simple = Ranges.point ranges in
  let value shown i =
    match (List.assoc_opt i (List.combine (axes view) shown), List.assoc_opt i view.fixed) with
    | Some v, _ | None, Some v -> v
    | None, None -> simple.(i)
  in
  let start shown = List.init (Array.length ranges) (fun i -> (ranges.(i).Ranges.name, value shown i)) in
  List.map start (pieces ranges view where @ grid ranges view)
