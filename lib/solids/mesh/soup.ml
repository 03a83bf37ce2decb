open Scc_exact
module Points = Hashtbl.Make (Vec)

type t = {
  numbers : int Points.t;
  mutable vertices : Vec.t list;  (* in reverse order *)
  mutable faces : int array list;
}

let create () = { numbers = Points.create 64; vertices = []; faces = [] }

let number soup v =
  match Points.find_opt soup.numbers v with
  | Some i -> i
  | None ->
    let i = Points.length soup.numbers in
    Points.add soup.numbers v i;
    soup.vertices <- v :: soup.vertices;
    i

let add soup a b c = if a <> b && b <> c && c <> a then soup.faces <- [| a; b; c |] :: soup.faces

let solid soup =
  let set = Text.ifs soup.vertices soup.faces in
  match soup.faces with
  | [] -> set
  | _ :: _ -> Merge_coplanar.merge set
