open Scc_exact
open Scc_polyhedra
open Scc_calculus
open Scc_regions
open Scc_json
open Scc_runs
open Json_format

let claim : Plane.outcome -> string = function
  | Holds -> "holds"
  | Varies -> "varies"
  | Unknown -> "unknown"
  | Fails -> "fails"
  | Value _ -> Scc_base.Bug.fail __POS__ "a claim with a number"

let is_line (view : Plane.view) = Option.is_none view.up
let axes (view : Plane.view) = view.across :: Option.to_list view.up

(* Of a line, where it is alone; the drawing has a height of 1 there. *)
let point =
  from (fun (p : Planar.point) -> [ p.x; p.y ]) (list ~least:2 ~most:2 Shared.rational)
  |> checked |> Rows.named "point"

let segment = from (fun (a, b) -> [ a; b ]) (list ~least:2 ~most:2 point) |> checked |> Rows.named "segment"

let whole n = Rat.make n Z.one

let constraint_ =
  let relation : Constraint.relation -> string = function Less -> "<" | At_most -> "<=" | Equal -> "=" in
  fields
    [
      field "normal" (list ~least:2 ~most:2 Shared.rational) (fun (c : Constraint.t) ->
          List.map whole (Array.to_list c.normal));
      field "relation" (word relation [ Less; At_most; Equal ]) (fun (c : Constraint.t) -> c.relation);
      field "right" Shared.rational (fun (c : Constraint.t) -> whole c.right);
    ]
  |> Rows.named "constraint"

(* A region with its outline, and how many of its outcomes are of checks; the others are of these numbers. *)
type shown = { region : Plane.region; outline : Outline.t; claims : int; numbers : Chances.t list }

let region =
  let border =
    fields
      [
        field "ends" segment (fun (b : Outline.border) -> b.ends);
        field "belongs" bool (fun (b : Outline.border) -> b.belongs);
      ]
  in
  let of_checks r = List.filteri (fun i _ -> i < r.claims) r.region.outcomes in
  (* What is not known comes after all values. *)
  let value ((c : Chances.t), (o : Plane.outcome)) =
    match o with
    | Value i -> Some i
    | Unknown -> Some (List.length c.parts)
    | Varies | Holds | Fails -> None
  in
  let of_numbers r =
    List.map value (List.combine r.numbers (List.filteri (fun i _ -> i >= r.claims) r.region.outcomes))
  in
  fields
    [
      field "outcomes" (list (word claim [ Plane.Holds; Varies; Unknown; Fails ])) of_checks
        ~about:"Of the checks.";
      field "values" (list (nullable Rows.number)) of_numbers
        ~about:"Of the numbers: which of its values each has; null where it depends on what is not shown.";
      field "pieces" (list (list constraint_))
        (fun r -> List.map Polyhedron.constraints (Union.pieces r.region.set))
        ~about:"All of it: the points that satisfy all constraints of some piece, normal . point relation right.";
      field "polygons" (list (list point)) (fun r -> List.map Planar.corners r.outline.polygons)
        ~about:"What has an area, by convex pieces, counter-clockwise.";
      field "borders" (list border) (fun r -> r.outline.borders)
        ~about:"Of what has an area, with it to the left.";
      field "lines" (list segment) (fun r -> r.outline.lines);
      field "points" (list point) (fun r -> r.outline.points);
      field "share" Shared.rational (fun r -> r.region.share) ~about:"Of its area in that of the ranges.";
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
  numbers : (string * Chances.t) list;
  drawn : Plane.region list;
  samples : ((string * Rat.t) list * int) list;
}

let drawn ranges view ~checks ~numbers =
  Plane.regions ~values:(List.map snd numbers) ranges view (List.map snd checks)

(* A value that a number has somewhere, or that nothing is known of it. *)
type value = Part of Ranges.t * Chances.part | Not_known

let values (c : Chances.t) =
  let parts = List.map (fun p -> Part (c.ranges, p)) c.parts in
  if Chances.known_everywhere c then parts else parts @ [ Not_known ]

let end_of get = function Part (_, p) -> get (Chances.ends_of p) | Not_known -> None

(* Of a value that depends on the parameters. *)
let form = function
  | Not_known -> Some Words.not_known
  | Part (ranges, p) ->
    let depends = function Some f -> not (Scc_polyhedra.Linear.is_constant f) | None -> false in
    if depends p.value.least || depends p.value.most then Some (Words.value ranges p.value) else None

let format =
  let shown d =
    let claims = List.length d.checks in
    let numbers = List.map snd d.numbers in
    let shown (region : Plane.region) = { region; outline = Outline.make region.set; claims; numbers } in
    List.map shown d.drawn
  in
  let sample = fields [ field "at" Origin_json.parameters_format fst; field "run" Rows.number snd ] in
  let value =
    fields
      [
        field "least" (nullable Shared.rational) (end_of (fun ends -> ends.low))
          ~about:"Its greatest lower bound; null of what is infinite or not known.";
        field "most" (nullable Shared.rational) (end_of (fun ends -> ends.high))
          ~about:"Its least upper bound; null if none is known.";
        maybe "form" some_text form
          ~about:"Of what is not one number: what it is by the parameters, or not known.";
      ]
  in
  let number =
    fields
      [
        field "name" some_text fst;
        field "values" (list value) (fun (_, c) -> values c)
          ~about:"Its values by size, exact where both bounds are the same. The last one may be not known.";
      ]
  in
  fields
    [
      field "axes" (list ~least:1 ~most:2 axis) (fun d -> List.map (Array.get d.ranges) (axes d.view));
      field "hidden" (list some_text) (fun d ->
          List.map (fun i -> d.ranges.(i).Ranges.name) (Plane.hidden d.ranges d.view))
        ~about:"Parameters that are not shown.";
      field "checks" (list some_text) (fun d -> List.map fst d.checks);
      field "numbers" (list number) (fun d -> d.numbers) ~about:"Probabilities as functions of the start.";
      field "regions" (list region) shown
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

let pieces (view : Plane.view) drawn =
  let of_region (r : Plane.region) = List.filter_map interior (Union.pieces r.set) in
  List.concat_map of_region drawn
  |> List.filteri (fun i _ -> i < most_pieces)
  |> List.map (fun p -> List.filteri (fun i _ -> i < List.length (axes view)) (Array.to_list p))

let starts ranges (view : Plane.view) drawn =
  let simple = Ranges.point ranges in
  let value shown i =
    match (List.assoc_opt i (List.combine (axes view) shown), List.assoc_opt i view.fixed) with
    | Some v, _ | None, Some v -> v
    | None, None -> simple.(i)
  in
  let start shown = List.init (Array.length ranges) (fun i -> (ranges.(i).Ranges.name, value shown i)) in
  List.map start (pieces view drawn @ grid ranges view)
