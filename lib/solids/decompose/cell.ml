open Scc_exact

type facet = { plane : Plane.t; corners : Homogeneous.t array }
type t = facet list

module Places = Hashtbl.Make (Homogeneous)

let box low high : t =
  let at i =
    let either bit part = part (if i land bit = 0 then low else high) in
    let x = either 1 (fun (v : Vec.t) -> v.x) and y = either 2 (fun (v : Vec.t) -> v.y) in
    Homogeneous.of_vec (Vec.make x y (either 4 (fun (v : Vec.t) -> v.z)))
  in
  let facet (x, y, z) corners =
    let corners = Array.map at corners in
    { plane = Plane.make (Ivec.of_ints x y z) corners.(0); corners }
  in
  [
    facet (0, 0, -1) [| 0; 2; 3; 1 |]; facet (0, 0, 1) [| 4; 5; 7; 6 |]; facet (0, -1, 0) [| 0; 1; 5; 4 |];
    facet (0, 1, 0) [| 2; 6; 7; 3 |]; facet (-1, 0, 0) [| 0; 4; 6; 2 |]; facet (1, 0, 0) [| 1; 3; 7; 5 |];
  ]

(* {1 Polygons} *)

let behind plane corners =
  let n = Array.length corners in
  let sides = Array.map (Plane.side plane) corners in
  let kept = ref [] in
  for i = 0 to n - 1 do
    let j = (i + 1) mod n in
    if sides.(i) <= 0 then kept := corners.(i) :: !kept;
    if sides.(i) * sides.(j) < 0 then begin
      let p = corners.(i) and q = corners.(j) in
      kept := Homogeneous.crossing p (Plane.height plane p) q (Plane.height plane q) :: !kept
    end
  done;
  Array.of_list (List.rev !kept)

type position = Behind | In_front | On | Across

let position plane corners =
  let front = ref false and back = ref false in
  Array.iter
    (fun p ->
       let s = Plane.side plane p in
       if s > 0 then front := true else if s < 0 then back := true)
    corners;
  match (!front, !back) with
  | false, false -> On
  | true, false -> In_front
  | false, true -> Behind
  | true, true -> Across

(* {1 Cells} *)

(* The edges that lie on the plane, of what is left of the facets, bound the new facet the other way round. *)
let lid plane (facets : t) =
  let next = Places.create 16 in
  let edges f =
    let n = Array.length f.corners in
    for i = 0 to n - 1 do
      let p = f.corners.(i) and q = f.corners.((i + 1) mod n) in
      if Plane.side plane p = 0 && Plane.side plane q = 0 then Places.replace next q p
    done
  in
  List.iter edges facets;
  let lesser p _ least = match least with Some l when Homogeneous.compare l p <= 0 -> least | _ -> Some p in
  let first = Places.fold lesser next None in
  match first with
  | None -> Scc_base.Bug.fail __POS__ "a cut without an edge"
  | Some first ->
    let rec walk p found =
      let q = Places.find next p in
      if Homogeneous.equal q first then List.rev (p :: found) else walk q (p :: found)
    in
    { plane; corners = Array.of_list (walk first []) }

let clip (cell : t) plane =
  match position plane (Array.concat (List.map (fun f -> f.corners) cell)) with
  | Behind | On -> Some cell
  | In_front -> None
  | Across ->
    let cut f =
      match position plane f.corners with
      | Behind -> Some f
      | In_front | On -> None
      | Across -> Some { f with corners = behind plane f.corners }
    in
    let kept = List.filter_map cut cell in
    Some (lid plane kept :: kept)

let corners (cell : t) =
  List.sort_uniq Homogeneous.compare (List.concat_map (fun f -> Array.to_list f.corners) cell)
