open Scc_exact
open Scc_geometry

let polyhedron =
  let vertex name x y z = (name, Vec.of_ints x y z) in
  let ifs =
    {
      Polyhedron.ifs_vertices =
        [|
          vertex "a" (-1) (-1) (-1); vertex "b" 1 (-1) (-1); vertex "c" 1 1 (-1); vertex "d" (-1) 1 (-1);
          vertex "e" (-1) (-1) 1; vertex "f" 1 (-1) 1; vertex "g" 1 1 1; vertex "h" (-1) 1 1;
        |];
      ifs_faces =
        [|
          ("bottom", [| 0; 3; 2; 1 |]); ("top", [| 4; 5; 6; 7 |]); ("left", [| 0; 4; 7; 3 |]);
          ("right", [| 1; 2; 6; 5 |]); ("front", [| 0; 1; 5; 4 |]); ("back", [| 3; 7; 6; 2 |]);
        |];
    }
  in
  match Polyhedron.of_ifs ifs with Ok p -> p | Error _ -> failwith "the cube is refused"
