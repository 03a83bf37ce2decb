open Scc_exact

type mesh = { corners : Ivec.t array; denominator : Z.t; faces : int array array; edges : (int * int) array }

let nowhere = (0, 0)

(* The point between two corners at which the height is zero: their heights have different signs. *)
let crossing mesh heights (i, j) =
  let a = Z.abs heights.(i) and b = Z.abs heights.(j) in
  let sum = Ivec.add (Ivec.scale b mesh.corners.(i)) (Ivec.scale a mesh.corners.(j)) in
  Vec.scale (Rat.make Z.one (Z.mul mesh.denominator (Z.add a b))) (Ivec.to_vec sum)

(* Corners of the result are the former ones and then the crossings of edges. *)
let cut mesh heights =
  let count = Array.length mesh.corners in
  let made = Hashtbl.create 16 and points = ref [] in
  let between i j =
    let edge = (min i j, max i j) in
    match Hashtbl.find_opt made edge with
    | Some k -> k
    | None ->
      let k = count + Hashtbl.length made in
      Hashtbl.add made edge k;
      points := crossing mesh heights edge :: !points;
      k
  in
  let sign i = Z.sign heights.(i) in
  let side i j =
    (if sign i >= 0 then [ i ] else []) @ if sign i * sign j < 0 then [ between i j ] else []
  in
  let face corners =
    let n = Array.length corners in
    let kept = List.concat (List.init n (fun k -> side corners.(k) corners.((k + 1) mod n))) in
    if List.compare_length_with kept 3 < 0 then [||] else Array.of_list kept
  in
  let edge (i, j) =
    match (sign i, sign j) with
    | a, b when a >= 0 && b >= 0 -> (i, j)
    | a, b when a > 0 && b < 0 -> (i, between i j)
    | a, b when a < 0 && b > 0 -> (between i j, j)
    | _ -> nowhere
  in
  let faces = Array.map face mesh.faces in
  let edges = Array.map edge mesh.edges in
  let old = Array.map (fun c -> Vec.scale (Rat.make Z.one mesh.denominator) (Ivec.to_vec c)) mesh.corners in
  let corners, denominator = Ivec.of_vecs (Array.append old (Array.of_list (List.rev !points))) in
  (* What is cut off is in no face any more: it is put where something is left. *)
  let left = match List.find_opt (fun i -> sign i >= 0) (List.init count Fun.id) with Some i -> i | None -> 0 in
  let there i c = if i < count && sign i < 0 then corners.(left) else c in
  { corners = Array.mapi there corners; denominator; faces; edges }

let part ~height mesh =
  let heights = Array.map height mesh.corners in
  if Array.for_all (fun h -> Z.sign h >= 0) heights then Some mesh
  else if Array.for_all (fun h -> Z.sign h <= 0) heights then None
  else Some (cut mesh heights)
