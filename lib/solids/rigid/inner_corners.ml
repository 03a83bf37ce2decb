open Scc_exact
open Scc_geometry

type pair = { contact : Near_contact.t; approaches : bool; obstacle : Obstacle.t; offset : Vec.t }

let pair ((contact : Near_contact.t), approaches) =
  let a = contact.first and b = contact.second in
  {
    contact;
    approaches;
    obstacle = Obstacle.make (Placed.fixed_solid a) (Placed.fixed_solid b);
    offset = Vec.sub b.at a.at;
  }

(* The tight directions of a pair when the second body is moved by [p]: none within its obstacle, which then covers
   all that is near. *)
let tight p pair =
  let r = Vec.add pair.offset p in
  match Obstacle.relation pair.obstacle r with
  | Apart -> None
  | Touching -> Some (Obstacle.separating pair.obstacle r)
  | Interpenetrating -> Some []

let exposed (pair, others) =
  if not pair.approaches then []
  else
    let closed = Vec.neg pair.contact.gap in
    match tight closed pair with
    | None | Some [] -> Scc_base.Bug.fail __POS__ "two bodies do not touch where their gap is closed"
    | Some own ->
      let left = Response.exposed own (List.filter_map (tight closed) others) in
      if List.compare_lengths left own = 0 then pair.contact.normals else left

let counting contacts =
  let with_normals normals = List.map2 (fun (c, _) ns -> (c, ns)) contacts normals in
  let all = List.map (fun ((c : Near_contact.t), is) -> if is then c.normals else []) contacts in
  match contacts with
  | [] | [ _ ] -> with_normals all
  | _ ->
    let left = List.map exposed (Response.with_others (List.map pair contacts)) in
    let some = List.exists (function [] -> false | _ :: _ -> true) left in
    with_normals (if some then left else all)
