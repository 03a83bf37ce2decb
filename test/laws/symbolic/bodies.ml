open Scc_exact
open Scc_geometry

let polyhedron vertices faces =
  let vertex (name, (x, y, z)) = (name, Vec.of_ints x y z) in
  let ifs =
    { Polyhedron.ifs_vertices = Array.of_list (List.map vertex vertices); ifs_faces = Array.of_list faces }
  in
  match Polyhedron.of_ifs ifs with Ok p -> p | Error _ -> failwith "a shape is refused"

let octahedron =
  polyhedron
    [ ("e", (1, 0, 0)); ("w", (-1, 0, 0)); ("n", (0, 1, 0));
      ("s", (0, -1, 0)); ("u", (0, 0, 1)); ("d", (0, 0, -1)) ]
    [ ("enu", [| 0; 2; 4 |]); ("nwu", [| 2; 1; 4 |]); ("wsu", [| 1; 3; 4 |]); ("seu", [| 3; 0; 4 |]);
      ("ned", [| 2; 0; 5 |]); ("wnd", [| 1; 2; 5 |]); ("swd", [| 3; 1; 5 |]); ("esd", [| 0; 3; 5 |]) ]

let tetrahedron =
  polyhedron
    [ ("o", (-1, -1, -1)); ("a", (1, -1, -1)); ("b", (-1, 1, -1)); ("c", (-1, -1, 1)) ]
    [ ("low", [| 0; 2; 1 |]); ("near", [| 0; 1; 3 |]); ("side", [| 0; 3; 2 |]); ("slant", [| 1; 2; 3 |]) ]

let half = Rat.make Z.one (Z.of_int 2)
let flat = Mat.diagonal (Vec.make Rat.one half Rat.one)
let cube = Scc_test_networks.Cube.polyhedron

let solids =
  Array.mapi
    (fun id (p, linear) -> Solid.make ~id p linear)
    [| (cube, Mat.identity); (cube, flat); (octahedron, Mat.identity); (tetrahedron, Mat.identity) |]

let shapes =
  [|
    [ (0, Vec.zero) ];
    [ (1, Vec.zero) ];
    [ (2, Vec.zero) ];
    [ (3, Vec.zero) ];
    [ (0, Vec.zero); (0, Vec.of_ints 2 0 0) ];
    [ (0, Vec.zero); (1, Vec.make (Rat.of_int 2) half Rat.zero) ];
    [ (0, Vec.zero); (2, Vec.of_ints 0 2 0) ];
  |]
