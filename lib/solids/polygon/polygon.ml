type t = { grid : Grid.t; outer : int array; holes : int array list }

type fault =
  | Short_ring of int
  | Same_place of int * int
  | Crossing of (int * int) * (int * int)
  | Outside of int

let edges ring =
  let n = Array.length ring in
  List.init n (fun k -> (ring.(k), ring.((k + 1) mod n)))

(* Two edges of which the end of one is the start of the other have that corner alone in common, unless one goes
   back over the other. *)
let clash g (a, b) (c, d) =
  if b = c then Grid.same g a d || (Grid.orient g a b d = 0 && not (Grid.turns g a b d))
  else if d = a then Grid.same g c b || (Grid.orient g c d b = 0 && not (Grid.turns g c d b))
  else Grid.meet g (a, b) (c, d)

(* Pairs whose ranges of x overlap, found by going from left to right. *)
let find_clash g all =
  let left (a, b) = if Grid.compare_x g a b <= 0 then a else b in
  let right (a, b) = if Grid.compare_x g a b <= 0 then b else a in
  let low (a, b) = if Grid.compare_y g a b <= 0 then a else b in
  let high (a, b) = if Grid.compare_y g a b <= 0 then b else a in
  let sorted = Array.of_list all in
  Array.stable_sort (fun e f -> Grid.compare_x g (left e) (left f)) sorted;
  let n = Array.length sorted in
  let rec from i j =
    if i >= n then None
    else if j >= n || Grid.compare_x g (left sorted.(j)) (right sorted.(i)) > 0 then from (i + 1) (i + 2)
    else
      let e = sorted.(i) and f = sorted.(j) in
      let beside = Grid.compare_y g (low e) (high f) > 0 || Grid.compare_y g (low f) (high e) > 0 in
      if (not beside) && clash g e f then Some (e, f) else from i (j + 1)
  in
  from 0 1

(* For a point that is on no edge of the ring: rays to the right cross it an odd number of times. *)
let inside g ring p =
  let crosses (a, b) =
    let below k = Grid.compare_y g k p <= 0 in
    match (below a, below b) with
    | true, false -> Grid.orient g a b p > 0
    | false, true -> Grid.orient g b a p > 0
    | true, true | false, false -> false
  in
  List.length (List.filter crosses (edges ring)) mod 2 = 1

let reversed ring =
  let n = Array.length ring in
  Array.init n (fun k -> ring.(n - 1 - k))

let directed g ~left ring = if Grid.twice_area g ring > 0 = left then ring else reversed ring

let repeated g rings =
  let all = Array.concat rings in
  let order a b =
    Grid.compare_x g a b <?> fun () -> Grid.compare_y g a b
  in
  Array.stable_sort order all;
  let rec from k =
    if k + 1 >= Array.length all then None
    else if Grid.same g all.(k) all.(k + 1) then Some (all.(k), all.(k + 1))
    else from (k + 1)
  in
  from 0

let stray g outer holes =
  let hole k ring =
    let p = ring.(0) in
    let others = List.filteri (fun j _ -> j <> k) holes in
    if inside g outer p && not (List.exists (fun other -> inside g other p) others) then None else Some (k + 1)
  in
  List.find_map Fun.id (List.mapi hole holes)

let make points rings =
  let g = Grid.make points in
  let short = List.mapi (fun k ring -> if Array.length ring < 3 then Some k else None) rings in
  match (rings, List.find_map Fun.id short, repeated g rings) with
  | [], _, _ -> Error (Short_ring 0)
  | _, Some k, _ -> Error (Short_ring k)
  | _, None, Some (a, b) -> Error (Same_place (a, b))
  | outer :: holes, None, None -> (
      match find_clash g (List.concat_map edges rings) with
      | Some (e, f) -> Error (Crossing (e, f))
      | None -> (
          match stray g outer holes with
          | Some k -> Error (Outside k)
          | None ->
            let holes = List.map (directed g ~left:false) holes in
            Ok { grid = g; outer = directed g ~left:true outer; holes }))
