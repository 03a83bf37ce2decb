open Scc_exact

type facet = Minkowski.facet = { normal : Ivec.t; num : Z.t; den : Z.t }
type t = { a : Solid.t; b : Solid.t; all : Facets.t Lazy.t }

let make a b = { a; b; all = lazy (Facets.make a b) }
let facets o = Facets.facets (Lazy.force o.all)

type relation = Facets.relation = Apart | Touching | Interpenetrating
type cast = Facets.cast = Never | Inside | At of Rat.t

(* {1 Relation} *)

(* What the spheres about the two centres say. *)
let by_spheres (o : t) (s : Portal.t) =
  let distance = sqrt (Portal.dot s Portal.centre Portal.centre) in
  let error = 0x1p-48 *. s.bound in
  let a = o.a.shadow and b = o.b.shadow in
  if distance -. error > a.outer +. b.outer then Some Apart
  else if distance +. error < a.inner +. b.inner then Some Interpenetrating
  else None

(* The answer that a search leads to, when it can be proved, and the corner of the portal to look at when the two
   touch. *)
type found = Relation of relation | Contact of Certificate.facet * Certificate.crossing | Open

let settle c (search : Portal.search) =
  match search with
  | Inside -> if Certificate.inside c then Relation Interpenetrating else Open
  | Through -> (
      match Certificate.facet c with
      | None -> Open
      | Some f -> (
          match Certificate.height c f with
          | 0 -> (
              match Certificate.foot c f with
              | Outside -> Open
              | (Within | Border _) as crossing -> Contact (f, crossing))
          | h when h < 0 -> Relation Apart
          | _ -> if Certificate.inside c then Relation Interpenetrating else Open))
  | Apart | Beside | Lost -> Open

let search c s =
  match Portal.locate s ~hasty:true with
  | Apart ->
    if Certificate.strictly_separated c then Relation Apart else settle c (Portal.locate s ~hasty:false)
  | found -> settle c found

let relation o r =
  match Portal.make o.a o.b r Vec.zero with
  | None -> Facets.relation (Lazy.force o.all) r
  | Some s -> (
      match by_spheres o s with
      | Some relation -> relation
      | None -> (
          match search (Certificate.make s r Vec.zero) s with
          | Relation relation -> relation
          | Contact _ -> Touching
          | Open -> Facets.relation (Lazy.force o.all) r))

let separating o r =
  let by_facets () = Facets.separating (Lazy.force o.all) r in
  match Portal.make o.a o.b r Vec.zero with
  | None -> by_facets ()
  | Some s -> (
      let c = Certificate.make s r Vec.zero in
      match settle c (Portal.locate s ~hasty:false) with
      | Contact (f, Within) -> [ Ivec.primitive (Certificate.normal f) ]
      | Contact (_, Border k) -> Certificate.tight c k
      | Contact (_, Outside) | Relation _ | Open -> by_facets ())

(* At a boundary point r of a convex polytope, r + t w is interior for all small t > 0 iff w goes strictly
   inwards through every facet that holds r. *)
let approaching o r w =
  let w, _ = Ivec.of_vec w in
  List.for_all (fun n -> Z.sign (Ivec.dot n w) < 0) (separating o r)

(* {1 Casts} *)

(* Whether the line runs through the interior: strictly inside of a facet it does. *)
let pierces c =
  match Certificate.crossing c with
  | Outside -> false
  | Within -> true
  | Border _ -> Certificate.interior c

let entered o r c =
  match Certificate.facet c with
  | Some f when Certificate.speed c f < 0 && pierces c ->
    if Certificate.height c f <= 0 then Some (At (Certificate.time c f))
    else
      (* entered before time 0: now inside, or through already *)
      Some (match relation o r with Interpenetrating -> Inside | Touching | Apart -> Never)
  | Some _ | None -> None

let rec follow o r c s (search : Portal.search) =
  match search with
  | Apart -> if Certificate.separated c then Some Never else follow o r c s (Portal.cast s ~hasty:false)
  | Beside -> (
      match Certificate.beside c with
      | Never -> Some Never
      | Crosses -> follow o r c s (Portal.through s)
      | Unknown -> None)
  | Through -> entered o r c
  | Inside | Lost -> None

let first_time_of_contact o r w =
  let found =
    match Portal.make o.a o.b r w with
    | None -> None
    | Some s -> follow o r (Certificate.make s r w) s (Portal.cast s ~hasty:true)
  in
  match found with Some cast -> cast | None -> Facets.first_time_of_contact (Lazy.force o.all) r w

let meeting o r w = Facets.meeting (Lazy.force o.all) r w
