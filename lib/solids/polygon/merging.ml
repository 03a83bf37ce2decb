(* The corners from one place of the ring on. *)
let from ring k =
  let n = Array.length ring in
  List.init n (fun m -> ring.((k + m) mod n))

let index (ring : int array) p =
  let rec find k = if ring.(k) = p then k else find (k + 1) in
  find 0

let neighbours ring p =
  let n = Array.length ring and k = index ring p in
  (ring.((k + n - 1) mod n), ring.((k + 1) mod n))

(* [one] goes from u to v, and [other] from v to u. *)
let union g one other (u, v) =
  let before_u, _ = neighbours one u and _, after_v = neighbours one v in
  let before_v, _ = neighbours other v and _, after_u = neighbours other u in
  if Grid.turns g before_u u after_u && Grid.turns g before_v v after_v then
    let rest = List.filter (fun p -> p <> u && p <> v) (from other (index other u)) in
    Some (Array.of_list (from one (index one v) @ rest))
  else None

let merged g pieces =
  let table = Array.of_list (List.map Option.some pieces) in
  let owner = Hashtbl.create 64 in
  let enter k ring = List.iter (fun edge -> Hashtbl.replace owner edge k) (Polygon.edges ring) in
  Array.iteri (fun k ring -> Option.iter (enter k) ring) table;
  let inner (u, v) k = match Hashtbl.find_opt owner (v, u) with Some l when k < l -> [ (u, v) ] | _ -> [] in
  let cuts = List.concat (List.mapi (fun k ring -> List.concat_map (fun e ->
      inner e k) (Polygon.edges ring)) pieces) in
  let try_cut (u, v) =
    let k = Hashtbl.find owner (u, v) and l = Hashtbl.find owner (v, u) in
    match (table.(k), table.(l)) with
    | Some one, Some other when k <> l ->
      Option.iter
        (fun whole ->
           table.(k) <- Some whole;
           table.(l) <- None;
           enter k whole)
        (union g one other (u, v))
    | _ -> ()
  in
  List.iter try_cut cuts;
  List.filter_map Fun.id (Array.to_list table)
