open Scc_exact
open Scc_geometry

let without k array = Array.of_list (List.filteri (fun i _ -> i <> k) (Array.to_list array))

(* Of a convex polygon, of which some angles may be straight: a corner is cut off at which it turns, where the rest
   has an area as well. *)
let rec of_convex place found corners =
  let n = Array.length corners in
  if n = 3 then List.rev (corners :: found)
  else
    let at k = corners.((k + n) mod n) in
    let area list = Drawn.area_vector (fun i -> place (List.nth list i)) (List.length list) in
    let fits k =
      (not (Vec.is_zero (area [ at (k - 1); at k; at (k + 1) ])))
      && not (Vec.is_zero (area (Array.to_list (without k corners))))
    in
    match List.find_opt fits (List.init n Fun.id) with
    | Some k -> of_convex place ([| at (k - 1); at k; at (k + 1) |] :: found) (without k corners)
    | None -> Scc_base.Bug.fail __POS__ "a polygon without an area"

let make (set : Polyhedron.ifs) =
  let place v = snd set.ifs_vertices.(v) in
  let face (name, corners) =
    let pieces = Drawn.convex_corners set corners (Drawn.normal set corners) in
    List.map (fun t -> (name, t)) (List.concat_map (of_convex place []) (Option.value pieces ~default:[ corners ]))
  in
  { set with ifs_faces = Array.of_list (List.concat_map face (Array.to_list set.ifs_faces)) }
