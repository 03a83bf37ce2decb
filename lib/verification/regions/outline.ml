open Scc_exact
open Scc_polyhedra
open Scc_data

type border = { ends : Planar.point * Planar.point; belongs : bool }

type t = {
  polygons : Polyhedron.t list;
  borders : border list;
  lines : (Planar.point * Planar.point) list;
  points : Planar.point list;
}

(* The parts of a segment between which nothing changes: in each, all points are in the same closures of pieces. *)
let parts pieces segment =
  let cuts = List.concat_map (fun p -> Planar.meets_at p segment) pieces in
  let all = List.sort_uniq Rat.compare (Rat.zero :: Rat.one :: cuts) in
  Lists.neighbours (List.map (Planar.along segment) all)

let outwards ((a, b) : Planar.point * Planar.point) = (Rat.sub b.y a.y, Rat.sub a.x b.x)

(* The outer ones among the parts of the sides of a polygon. *)
let borders_of u polygons p =
  let side segment =
    let outer (a, b) =
      let middle = Planar.midpoint a b in
      let beyond q = Planar.reaches_beyond q middle ~towards:(outwards segment) in
      if List.exists beyond polygons then None else Some { ends = (a, b); belongs = Planar.mem u middle }
    in
    List.filter_map outer (parts (Union.pieces u) segment)
  in
  List.concat_map side (Lists.ring (Planar.corners p))

(* Of two of which one ends where the other begins. *)
let straight a b =
  let x, y = outwards a.ends and x', y' = outwards b.ends in
  Rat.sign (Rat.sub (Rat.mul x y') (Rat.mul x' y)) = 0

(* Puts together what goes on in one line, from either end. *)
let rec joined found = function
  | [] -> List.rev found
  | b :: rest -> (
      let same p q = Planar.compare p q = 0 in
      let goes_on c =
        c.belongs = b.belongs && straight b c && (same (snd b.ends) (fst c.ends) || same (snd c.ends) (fst b.ends))
      in
      match List.partition goes_on rest with
      | [], _ -> joined (b :: found) rest
      | c :: others, rest ->
        let ends = if same (snd b.ends) (fst c.ends) then (fst b.ends, snd c.ends) else (fst c.ends, snd b.ends) in
        joined found ({ b with ends } :: (others @ rest)))

let ends p =
  match Planar.corners p with
  | [ a; b ] -> (a, b)
  | _ -> Scc_base.Bug.fail __POS__ "a segment without two ends"

let make u =
  let of_dimension n = List.filter (fun p -> Polyhedron.affine_dimension p = n) (Union.pieces u) in
  let polygons = of_dimension 2 and segments = of_dimension 1 in
  let apart_from pieces point = not (List.exists (fun p -> Planar.in_closure p point) pieces) in
  let line p =
    List.filter (fun (a, b) -> apart_from polygons (Planar.midpoint a b)) (parts polygons (ends p))
  in
  let points = List.concat_map Planar.corners (of_dimension 0) in
  {
    polygons;
    borders = joined [] (List.concat_map (borders_of u polygons) polygons);
    lines = List.concat_map line segments;
    points = List.filter (apart_from (polygons @ segments)) points;
  }

let corners outlines =
  let both (a, b) = [ a; b ] in
  let of_one o =
    List.concat_map (fun b -> both b.ends) o.borders @ List.concat_map both o.lines @ o.points
  in
  List.sort_uniq Planar.compare (List.concat_map of_one outlines)
