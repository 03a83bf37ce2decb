open Scc_exact
open Scc_polyhedra
open Scc_calculus
open Scc_regions
open Scc_json

let relation : Constraint.relation -> string = function
  | Less -> "<"
  | At_most -> "<="
  | Equal -> "="

let coefficients ~name numbers =
  let term i a = if Rat.sign a = 0 then [] else [ (name i, Json.rat a) ] in
  `Assoc (List.concat (Array.to_list (Array.mapi term numbers)))

let constraint_ ~name (c : Constraint.t) =
  `Assoc
    [
      ("coefficients", coefficients ~name (Array.map Q.of_bigint c.normal));
      ("relation", `String (relation c.relation));
      ("bound", Json.rat (Q.of_bigint c.right));
    ]

let polyhedron_of ~name p = `List (List.map (constraint_ ~name) (Polyhedron.constraints p))
let polyhedron ranges p = polyhedron_of ~name:(Ranges.name ranges) p

let form ~name (f : Linear.t) =
  `Assoc [ ("coefficients", coefficients ~name f.coefficients); ("constant", Json.rat f.constant) ]

let set ranges u measure =
  [
    ("pieces", `List (List.map (polyhedron ranges) (Union.pieces u)));
    ("measure", match measure with Some volume -> Json.rat volume | None -> `Null);
  ]

let probability w =
  let between low high =
    [ ("probability", `Null); ("probability_between", `List [ Json.rat low; Json.rat high ]) ]
  in
  match Where.probability w with
  | Exactly x -> [ ("probability", Json.rat x) ]
  | Between (low, high) -> between low high
  | Not_computed -> between Rat.zero Rat.one

let where (w : Where.t) =
  let { Where.of_holds; of_fails; of_unknown } = Where.measures w in
  let name (r : Ranges.range) = Json.text r.name in
  `Assoc
    ([ ("parameters", `List (List.map name (Array.to_list w.ranges))) ]
     @ set w.ranges w.holds of_holds @ probability w
     @ [
       ("range", polyhedron w.ranges (Ranges.box w.ranges));
       ("fails", `Assoc (set w.ranges w.fails of_fails));
       ("unknown", `Assoc (set w.ranges w.unknown of_unknown));
     ])
