open Scc_exact

type touching = { obstacle : Obstacle.t; offset : Vec.t }

(* Every touching pair of parts has an obstacle in the space of the relative translation p of the two
   bodies, and near the present p = 0 that obstacle is the cone of all p with m.p <= 0 for its tight
   directions m. The union of these cones is what the collision happens against. *)

(* {1 Which directions count (reading I-13)}

   The facet of a direction n of the pair k is, near 0, the plane cone of the p with n.p = 0 that lie in the
   cone of k. It is no part of the surface of the union if just outside of it, at p + eps n, there is always
   another pair's cone. For p on none of the lines in which the other planes cut the plane of n, p + eps n
   lies in the cone of j for small eps > 0 iff for every tight m of j
     m.p < 0,  or  m.p = 0 and m.n <= 0,
   where m.p = 0 means that m is parallel to n: covered from the other side if m is -n, flush and so not
   covered if m is n. The answer is the same for all p between two neighbouring lines, so that one sample
   from each sector decides exactly. *)

let holds_outside tight n p =
  List.for_all
    (fun m ->
       let s = Z.sign (Ivec.dot m p) in
       s < 0 || (s = 0 && Z.sign (Ivec.dot m n) <= 0))
    tight

(* Whether a direction p of the plane of [n], on none of the lines, points into the facet. *)
let in_facet own n p =
  List.for_all (fun m -> Z.sign (Ivec.dot m p) < 0 || Ivec.equal m n) own

(* Both directions of the line in which the plane of [m] cuts the plane of [n], if it does. *)
let line n m =
  let d = Ivec.cross n m in
  if Ivec.is_zero d then [] else [ d; Ivec.neg d ]

(* A direction that is not parallel to [n]. *)
let off_axis (n : Ivec.t) =
  if Z.sign n.x = 0 && Z.sign n.y = 0 then Ivec.of_ints 1 0 0 else Ivec.of_ints 0 0 1

(* The order of directions around [n]. The products with u and v = n x u, which are orthogonal, map the
   plane of n to two dimensions linearly and keep the sense of rotation, hence the cyclic order. *)
let around (n : Ivec.t) =
  let u = Ivec.cross (off_axis n) n in
  let v = Ivec.cross n u in
  let half x y = if Z.sign y > 0 || (Z.sign y = 0 && Z.sign x > 0) then 0 else 1 in
  fun d e ->
    let dx = Ivec.dot d u and dy = Ivec.dot d v and ex = Ivec.dot e u and ey = Ivec.dot e v in
    Int.compare (half dx dy) (half ex ey) <?> fun () -> Z.compare (Z.mul ex dy) (Z.mul dx ey)

(* One direction strictly inside each sector between neighbouring lines. With two lines or more, neighbours are
   less than half a turn apart and their sum lies between them; one line leaves two sectors, none the whole
   plane. *)
let samples n normals =
  match List.sort_uniq (around n) (List.concat_map (line n) normals) with
  | [] ->
    [ Ivec.cross n (off_axis n) ]
  | [ d; _ ] -> [ Ivec.cross n d; Ivec.cross d n ]
  | sorted ->
    List.map (fun (d, e) -> Ivec.add d e) (Scc_data.Lists.ring sorted)

(* [own] are the tight directions of the pair that [n] belongs to, [others] those of each other pair. *)
let covered own others n =
  samples n (List.concat (own :: others))
  |> List.for_all (fun p ->
      (not (in_facet own n p)) || List.exists (fun tight -> holds_outside tight n p) others)

let approaches w tight = List.for_all (fun n -> Z.sign (Ivec.dot n w) < 0) tight

(* Each element with all the others. *)
let with_others xs =
  let rec go found before = function
    | [] -> List.rev found
    | x :: after -> go ((x, List.rev_append before after) :: found) (x :: before) after
  in
  go [] [] xs

let exposed own others = List.filter (fun n -> not (covered own others n)) own

let directions touching w =
  let w, _ = Ivec.of_vec w in
  let all = List.map (fun t -> Obstacle.separating t.obstacle t.offset) touching in
  let approaching = List.filter (fun (own, _) -> approaches w own) (with_others all) in
  let kept =
    match List.concat_map (fun (own, others) -> exposed own others) approaching with
    | [] -> List.concat_map fst approaching
    | kept -> kept
  in
  List.map Ivec.to_vec (List.sort_uniq Ivec.compare kept)

(* For x = proj_N(-w) the projection on a cone has x.(-w - x) = 0, so that |w + 2x| = |w|; and n.(x + w) >= 0
   for every n of the cone, so that n.(w + 2x) >= -n.w > 0: a pair that approached no longer does. In
   translation the kinetic metric of the relative velocity is the reduced mass times the Euclidean one,
   which has the same projection. *)
let bounce touching w =
  let n = directions touching w in
  Vec.axpy (Rat.of_int 2) (Nnls.project_cone n (Vec.neg w)) w
