type t =
  | No_faces
  | Flat of int
  | Bad_vertex_index of int * int
  | Short_face of int
  | Open_edge of int * int * int
  | Repeated_edge of int * int * int * int
  | Turned_face of int * int array
  | Same_position of int * int
  | Unused_vertex of int
  | Off_plane of int * int
  | Degenerate_face of int * int
  | Self_crossing of int * int array option
  | Not_convex of int * int
  | Coplanar_neighbours of int * int
  | In_plane of int * int
  | Inward
  | Separate_solids of int * int

let kind = function
  | No_faces -> "no-faces"
  | Flat _ -> "flat"
  | Bad_vertex_index _ -> "bad-vertex-index"
  | Short_face _ -> "short-face"
  | Open_edge _ -> "open-edge"
  | Repeated_edge _ -> "repeated-edge"
  | Turned_face _ -> "turned-face"
  | Same_position _ -> "same-position"
  | Unused_vertex _ -> "unused-vertex"
  | Off_plane _ -> "off-plane"
  | Degenerate_face _ -> "degenerate-face"
  | Self_crossing _ -> "self-crossing"
  | Not_convex _ -> "not-convex"
  | Coplanar_neighbours _ -> "coplanar-neighbours"
  | In_plane _ -> "in-plane"
  | Inward -> "inward"
  | Separate_solids _ -> "separate-solids"

let code =
  let open Scc_base.Code in
  function
  | No_faces | Flat _ -> no_solid
  | Bad_vertex_index _ -> bad_index
  | Short_face _ | Degenerate_face _ | Self_crossing _ -> not_convex_face
  | Open_edge _ -> open_solid
  | Repeated_edge _ | Turned_face _ -> overused_edge
  | Inward -> inward_faces
  | Same_position _ | Unused_vertex _ -> bad_vertices
  | Off_plane _ -> not_planar
  | Not_convex _ | In_plane _ -> not_convex
  | Coplanar_neighbours _ -> coplanar_faces
  | Separate_solids _ -> several_solids

let message ~vertex ~face =
  let say = Printf.sprintf in
  function
  | No_faces -> "there is no face, so no solid is enclosed"
  | Flat f -> say "the solid is flat: no vertex is behind the plane of face %s" (face f)
  | Bad_vertex_index (f, i) -> say "face %s names the vertex number %d, which does not exist" (face f) i
  | Short_face f -> say "face %s has fewer than three corners" (face f)
  | Open_edge (f, v, w) ->
    say "the solid is not closed: edge [%s,%s] belongs to one face only, %s" (vertex v) (vertex w)
      (face f)
  | Repeated_edge (f, g, v, w) when f = g ->
    say "face %s runs from %s to %s twice" (face f) (vertex v) (vertex w)
  | Repeated_edge (f, g, v, w) ->
    say "faces %s and %s both run from %s to %s" (face f) (face g) (vertex v) (vertex w)
  | Turned_face (f, _) -> say "face %s is turned over: it runs the other way round than its neighbours" (face f)
  | Same_position (v, w) -> say "vertices %s and %s have the same position" (vertex v) (vertex w)
  | Unused_vertex v -> say "vertex %s is used by no face" (vertex v)
  | Off_plane (f, v) -> say "face %s is not planar: %s is off its plane" (face f) (vertex v)
  | Degenerate_face (f, v) ->
    say "face %s is not a strictly convex polygon: it does not turn left at %s" (face f) (vertex v)
  | Self_crossing (f, _) ->
    say "face %s is not a simple polygon: it crosses itself or winds more than once" (face f)
  | Not_convex (f, v) ->
    say "the solid is not convex: vertex %s is in front of the plane of face %s" (vertex v) (face f)
  | Coplanar_neighbours (f, g) -> say "faces %s and %s are coplanar neighbours" (face f) (face g)
  | In_plane (f, v) ->
    say "the solid is not convex: vertex %s lies in the plane of face %s without being a corner of it"
      (vertex v) (face f)
  | Inward -> "the faces are oriented inward: clockwise seen from outside"
  | Separate_solids (f, g) ->
    say "these are separate solids: faces %s and %s are not connected through edges" (face f) (face g)

(* More of them would hide what is said. *)
let most_corners = 12

let with_corners ~vertex advice corners =
  if Array.length corners > most_corners then advice
  else Printf.sprintf "%s: [%s]" advice (String.concat "," (List.map vertex (Array.to_list corners)))

let hint ~vertex ~face = function
  | No_faces -> Some "of points alone scc shape --hull makes a solid, their convex hull"
  | Coplanar_neighbours (f, g) -> Some (Printf.sprintf "merge %s and %s into one face" (face f) (face g))
  | Inward -> Some "reverse the order of the corners of every face"
  | Turned_face (f, corners) ->
    Some (with_corners ~vertex (Printf.sprintf "reverse the order of the corners of %s" (face f)) corners)
  | Self_crossing (f, Some corners) ->
    let advice = Printf.sprintf "list the corners of %s in the order along its border" (face f) in
    Some (with_corners ~vertex advice corners)
  | Same_position (v, w) ->
    Some (Printf.sprintf "use %s in place of %s in every face" (vertex v) (vertex w))
  | Unused_vertex v -> Some (Printf.sprintf "remove %s" (vertex v))
  | Off_plane _ ->
    Some
      "if its decimals are rounded and the solid is convex: `snap 1e-5` after a mesh, or scc shape --snap 1e-5, \
       finds an exact one; of other solids, export the faces as triangles"
  | Separate_solids _ ->
    Some "make a template of each, and glue them in a compound; what is hollow inside is cut up by `decompose`"
  | _ -> None
