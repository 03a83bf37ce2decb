open Scc_exact

(* The point of least norm of conv { q - p | p of A, q of B } (Gilbert, Johnson and Keerthi). The corral, a few of
   these differences, has its point of least norm x in the relative interior of its hull, so that x.c = x.x for
   every c of the corral. The lowest difference s along x proves that x is the answer, if x.s >= x.x. Else it joins
   the corral, whose least norm falls strictly: in exact arithmetic no corral occurs twice, and the search ends.

   x.c = x.x on the affine hull of the corral, so that an s with x.s < x.x is not on it: the corral stays affinely
   independent. Four points with x in the interior of their hull have x = 0; so a corral has at most three as long
   as x is not 0. *)

(* [along] is a positive multiple of x, so that x.s - x.x has the sign of along.s - along.c for the first c of the
   corral. *)
type least = { along : Ivec.t; corral : Ivec.t list }

let above x s = Z.compare (Ivec.dot x.along s) (Ivec.dot x.along (List.hd x.corral))
let all_positive = List.for_all (fun w -> Z.sign w > 0)

(* The foot of the origin on the affine hull of some points, if its weights are all positive. *)
let foot corral =
  match corral with
  | [ p ] -> Some { along = p; corral }
  | [ p; q ] ->
    let e = Ivec.sub q p in
    let wp = Ivec.dot q e and wq = Z.neg (Ivec.dot p e) in
    if all_positive [ wp; wq ] then
      Some { along = Ivec.add (Ivec.scale wp p) (Ivec.scale wq q); corral }
    else None
  | [ p; q; r ] ->
    (* The foot f is parallel to n. The triangle f q r has the area n.((q - f) x (r - f)) = n.(q x r), up to the
       factor 1 / 2|n|, and these areas are the weights of the corners opposite. *)
    let n = Ivec.cross (Ivec.sub q p) (Ivec.sub r p) in
    if all_positive [ Ivec.det n q r; Ivec.det n r p; Ivec.det n p q ] then
      let side = Z.of_int (Z.sign (Ivec.dot n p)) in
      Some { along = Ivec.scale side n; corral }
    else None
  | _ -> None

let rec choose k points =
  match points with
  | _ when k = 0 -> [ [] ]
  | [] -> []
  | p :: rest -> List.map (List.cons p) (choose (k - 1) rest) @ choose k rest

(* The point of least norm in the hull of at most four affinely independent points lies in the relative interior of
   the hull of some of them. If of all four, it is 0. *)
let least_of points =
  let is_least x = List.for_all (fun p -> above x p >= 0) points in
  let proper corral = match foot corral with Some x when is_least x -> Some x | Some _ | None -> None in
  match List.find_map proper (List.concat_map (fun k -> choose k points) [ 1; 2; 3 ]) with
  | Some x -> x
  | None -> { along = Ivec.zero; corral = points }

let lowest n points =
  let best = ref points.(0) and at = ref (Ivec.dot n points.(0)) in
  for i = 1 to Array.length points - 1 do
    let v = Ivec.dot n points.(i) in
    if Z.lt v !at then begin
      best := points.(i);
      at := v
    end
  done;
  !best

let find a b =
  let support n = Ivec.sub (lowest n b) (lowest (Ivec.neg n) a) in
  let rec search x =
    if Ivec.is_zero x.along then None
    else
      let s = support x.along in
      if above x s >= 0 then Some x else search (least_of (s :: x.corral))
  in
  search (least_of [ Ivec.sub b.(0) a.(0) ])

(* x = along (along.c) / (along.along), as x.c = x.x. *)
let vector_over denominator a b =
  match find a b with
  | None -> Vec.zero
  | Some { along; corral } ->
    let n = Ivec.primitive along in
    let k = Rat.make (Ivec.dot n (List.hd corral)) (Z.mul denominator (Ivec.dot n n)) in
    Vec.scale k (Ivec.to_vec n)

let vector a b =
  let k = Array.length a in
  let points, denominator = Ivec.of_vecs (Array.append a b) in
  vector_over denominator (Array.sub points 0 k) (Array.sub points k (Array.length b))

let distance2 a b = Vec.norm2 (vector a b)
