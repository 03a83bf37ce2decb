open Scc_exact
open Scc_polyhedra
open Scc_calculus
open Scc_regions
open Scc_json
open Scc_runs
open Json_format

let outcome : Plane.outcome -> string = function
  | Holds -> "holds"
  | Varies -> "varies"
  | Unknown -> "unknown"
  | Fails -> "fails"
  | Value _ -> Scc_base.Bug.fail __POS__ "a number where claims alone are shown"

let is_line (view : Plane.view) = Option.is_none view.up
let axes (view : Plane.view) = view.across :: Option.to_list view.up

(* Of a line, where it is alone; the drawing has a height of 1 there. *)
let point =
  from (fun (p : Planar.point) -> [ p.x; p.y ]) (list ~least:2 ~most:2 Shared.rational)
  |> checked |> Rows.named "point"

let segment = from (fun (a, b) -> [ a; b ]) (list ~least:2 ~most:2 point) |> checked |> Rows.named "segment"

let region =
  let border =
    fields
      [
        field "ends" segment (fun (b : Outline.border) -> b.ends);
        field "belongs" bool (fun (b : Outline.border) -> b.belongs);
      ]
  in
  fields
    [
      field "outcomes" (list (word outcome [ Holds; Varies; Unknown; Fails ]))
        (fun ((r : Plane.region), _) -> r.outcomes)
        ~about:"Of the checks.";
      field "polygons" (list (list point)) (fun (_, (o : Outline.t)) -> List.map Planar.corners o.polygons)
        ~about:"What has an area, by convex pieces, counter-clockwise.";
      field "borders" (list border) (fun (_, (o : Outline.t)) -> o.borders)
        ~about:"Of what has an area, with it to the left.";
      field "lines" (list segment) (fun (_, (o : Outline.t)) -> o.lines);
      field "points" (list point) (fun (_, (o : Outline.t)) -> o.points);
      field "share" Shared.rational (fun ((r : Plane.region), _) -> r.share)
        ~about:"Of its area in that of the ranges.";
    ]
  |> Rows.named "region"

let axis =
  let bound =
    fields
      [
        field "value" Shared.rational (fun (b : Ranges.bound) -> b.value);
        field "included" bool (fun (b : Ranges.bound) -> b.included);
      ]
    |> Rows.named "bound"
  in
  fields
    [
      field "name" some_text (fun (r : Ranges.range) -> r.name);
      field "low" bound (fun (r : Ranges.range) -> r.low);
      field "high" bound (fun (r : Ranges.range) -> r.high);
    ]

type t = {
  ranges : Ranges.t;
  view : Plane.view;
  checks : (string * Where.t) list;
  samples : ((string * Rat.t) list * int) list;
}

let format =
  let regions d =
    let outlined (r : Plane.region) = (r, Outline.make r.set) in
    List.map outlined (Plane.regions d.ranges d.view (List.map snd d.checks))
  in
  let sample = fields [ field "at" Origin_json.parameters_format fst; field "run" Rows.number snd ] in
  fields
    [
      field "axes" (list ~least:1 ~most:2 axis) (fun d -> List.map (Array.get d.ranges) (axes d.view));
      field "checks" (list some_text) (fun d -> List.map fst d.checks);
      field "regions" (list region) regions
        ~about:"Disjoint. On the line of one parameter, the second coordinate is from 0 to 1.";
      field "samples" (list sample) (fun d -> d.samples) ~about:"Starts, and the runs from there.";
    ]
  |> Rows.named "regions"

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
