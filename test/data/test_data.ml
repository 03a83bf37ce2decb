open Scc_exact
open Scc_geometry
module Naive = Scc_naive.Naive

let solid ~id (s : Naive.solid) linear =
  let named prefix i x = (prefix ^ string_of_int i, x) in
  let faces = Array.of_list (List.map Array.of_list s.faces) in
  let ifs =
    { Polyhedron.ifs_vertices = Array.mapi (named "v") s.points; ifs_faces = Array.mapi (named "f") faces }
  in
  match Polyhedron.of_ifs ifs with
  | Ok p -> Solid.make ~id p linear
  | Error _ -> failwith "not a convex closed polyhedron"

let lines path =
  let input = open_in path in
  let rec go found =
    match input_line input with
    | line -> go (line :: found)
    | exception End_of_file -> close_in input; Array.of_list (List.rev found)
  in
  go []

let words line = List.filter (fun w -> w <> "") (String.split_on_char ' ' (String.trim line))
let numbers line = Array.of_list (List.map int_of_string (words line))
let vector row i = Vec.of_ints row.(i) row.(i + 1) row.(i + 2)

let shape path =
  let rows = Array.map numbers (lines path) in
  let n = rows.(0).(0) and m = rows.(0).(1) in
  let face i = List.tl (Array.to_list rows.(1 + n + i)) in
  { Naive.points = Array.init n (fun i -> vector rows.(1 + i) 0); faces = List.init m face }

let turn row i =
  let q k = Rat.of_int row.(i + k) in
  match Mat.of_quaternion (q 0, q 1, q 2, q 3) with Some m -> m | None -> failwith "a zero quaternion"

let rows path =
  let rows = Array.map numbers (lines path) in
  Array.sub rows 1 rows.(0).(0)

type case = { near : Vec.t; far : Vec.t; velocity : Vec.t; turn : Mat.t }

let pairs path =
  let case r = { near = vector r 0; far = vector r 3; velocity = vector r 6; turn = turn r 9 } in
  Array.map case (rows path)

let is_kissing path =
  let found = rows path in
  Array.length found > 0 && Array.length found.(0) = 7

let kissing path =
  let case r =
    let norm2 = Array.fold_left (fun s q -> s + (q * q)) 0 (Array.sub r 3 4) in
    (turn r 3, Vec.scale (Rat.make Z.one (Z.of_int norm2)) (vector r 0))
  in
  Array.map case (rows path)

let touch_word = function
  | None -> "never"
  | Some (_, Some last) when Rat.sign last < 0 -> "never"
  | Some (None, _) -> "touch 0"
  | Some (Some first, _) -> "touch " ^ Rat.to_string (Rat.max Rat.zero first)

let answer o r w =
  let collision =
    match Obstacle.first_time_of_contact o r w with
    | Never -> "never"
    | Inside -> "inside"
    | At t -> "collide " ^ Rat.to_string t
  in
  collision ^ " | " ^ touch_word (Obstacle.meeting o r w)
