open Scc_exact
module Points = Scc_data.Numbering.Make (Vec)

type t = {
  vertices : Points.t;
  mutable faces : int array list;
}

let create () = { vertices = Points.create (); faces = [] }

let number soup = Points.number soup.vertices

let add soup a b c = if a <> b && b <> c && c <> a then soup.faces <- [| a; b; c |] :: soup.faces

let solid soup =
  let set = Text.ifs (List.rev (Points.keys soup.vertices)) soup.faces in
  match soup.faces with
  | [] -> set
  | _ :: _ -> Merge_coplanar.merge set
