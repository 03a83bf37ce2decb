type t = { grid : Grid.t; at : int array }

let around ring k =
  let n = Array.length ring in
  (ring.((k + n - 1) mod n), ring.(k), ring.((k + 1) mod n))

(* Whether the way from the corner k of a ring to a point begins inside, strictly between its two edges. *)
let in_angle g ring k q =
  let before, a, after = around ring k in
  if Grid.turns g before a after then Grid.orient g a q before > 0 && Grid.orient g q a after > 0
  else not (Grid.orient g a q after >= 0 && Grid.orient g q a before >= 0)

(* It begins strictly outside. *)
let off_angle g ring k q =
  let before, a, after = around ring k in
  if Grid.turns g before a after then Grid.orient g a q before < 0 || Grid.orient g q a after < 0
  else Grid.orient g a q after > 0 && Grid.orient g q a before > 0

(* Nothing of these rings is on the open segment. *)
let free g rings a q =
  let clear ring =
    let n = Array.length ring in
    let rec from k =
      k = n
      || (not (Grid.between g a q ring.(k)))
         && (not (Grid.crosses g (a, q) (ring.(k), ring.((k + 1) mod n))))
         && from (k + 1)
    in
    from 0
  in
  List.for_all clear rings

(* An edge crosses the open segment at an inner point of both. *)
let crossed g ring a q =
  let n = Array.length ring in
  let side k = Grid.orient g a q ring.(k) in
  let rec from k here =
    k < n
    &&
    let l = if k + 1 = n then 0 else k + 1 in
    let there = side l in
    (here * there < 0 && Grid.crosses g (a, q) (ring.(k), ring.(l))) || from (k + 1) there
  in
  from 0 (side 0)

let reflex c k =
  let before, a, after = around c.at k in
  not (Grid.turns c.grid before a after)

type view = Open | Along | Closed

let view c i j =
  let g = c.grid and a = c.at.(i) and q = c.at.(j) in
  if Grid.same g a q || off_angle g c.at i q || off_angle g c.at j a || crossed g c.at a q then Closed
  else if in_angle g c.at i q && in_angle g c.at j a && free g [ c.at ] a q then Open
  else Along

(* From position i around the ring of a hole and back. *)
let spliced at i hole k =
  let n = Array.length hole in
  let loop = Array.init (n + 1) (fun m -> hole.((k + m) mod n)) in
  Array.concat [ Array.sub at 0 (i + 1); loop; Array.sub at i (Array.length at - i) ]

let compare_triples (h, i, k) (h', i', k') =
  Int.compare h h' <?> fun () ->
    Int.compare i i' <?> fun () -> Int.compare k k'

(* All cuts from a position to a corner of a hole, the shortest first. *)
let cuts g at holes =
  let of_hole h hole =
    let to_corner i k = (Grid.squared g at.(i) hole.(k), (h, i, k)) in
    List.concat (List.init (Array.length at) (fun i -> List.init (Array.length hole) (to_corner i)))
  in
  let shorter (d, one) (e, other) =
    Z.compare d e <?> fun () -> compare_triples one other
  in
  List.map snd (List.sort shorter (List.concat (List.mapi of_hole holes)))

let rec join g at = function
  | [] -> at
  | holes -> (
      let hole h = List.nth holes h in
      let fits (h, i, k) =
        let a = at.(i) and q = (hole h).(k) in
        in_angle g at i q && in_angle g (hole h) k a && free g (at :: holes) a q
      in
      match List.find_opt fits (cuts g at holes) with
      | None -> Scc_base.Bug.fail __POS__ "a hole that no cut joins to the rest"
      | Some (h, i, k) ->
        let others = List.filteri (fun j _ -> j <> h) holes in
        join g (spliced at i (hole h) k) others)

let of_polygon (p : Polygon.t) = { grid = p.grid; at = join p.grid p.outer p.holes }
