open Scc_base
open Scc_exact

type facet = Minkowski.facet = { normal : Ivec.t; num : Z.t; den : Z.t }

(* What proved the last answers. A plane supports the obstacle wherever B stands, and so may prove the next answer
   as well: the pair has moved a little, or another pair of the same solids is as far apart. *)
type memory = {
  mutable plane : Support_proof.plane option;  (** kept the two apart *)
  mutable entrance : entrance option;
  mutable contact : contact option;
}

(* A portal that was entered, and the plane of the facet that it carries. *)
and entrance = { carrier : Support_proof.plane; portal : Portal.triangle }

(* At this offset the two touch, and these are the normals of the facets that hold it: who has asked whether bodies
   touch asks next how. *)
and contact = { at : Vec.t; normals : Ivec.t list Later.t }

type t = { a : Solid.t; b : Solid.t; all : Facets.t Later.t; guess : Portal.guess; memory : memory }

let make ?(guess = Portal.guess) a b =
  let memory = { plane = None; entrance = None; contact = None } in
  { a; b; all = Later.make (fun () -> Facets.make a b); guess; memory }

let facets o = Facets.facets (Later.force o.all)

let keep_plane o p = o.memory.plane <- Some p

type relation = Facets.relation = Apart | Touching | Interpenetrating
type cast = Facets.cast = Never | Inside | At of Rat.t

(* {1 Relation} *)

let[@inline] beyond error r low_a high_a low_b high_b =
  r +. low_b -. high_a > error || low_a -. (r +. high_b) > error

(* What the boxes of the two and the spheres about their centres say. A difference of coordinates is off by at most
   3 u of the bound for each of its three terms' shares, and 2 u more for the sums: 5 u; a length by less than
   twice that and a few u for the root; the bound is 32 u. What is not sane compares as false. *)
let at_first_sight o (r : Shadow.floats) =
  let a = o.a.shadow and b = o.b.shadow in
  let error = 0x1p-48 *. Question.bound_on o.a o.b r in
  if
    beyond error r.x a.low.x a.high.x b.low.x b.high.x
    || beyond error r.y a.low.y a.high.y b.low.y b.high.y
    || beyond error r.z a.low.z a.high.z b.low.z b.high.z
  then Some Apart
  else
    let x = r.x +. b.cx -. a.cx and y = r.y +. b.cy -. a.cy and z = r.z +. b.cz -. a.cz in
    let distance = sqrt ((x *. x) +. (y *. y) +. (z *. z)) in
    if distance -. error > a.outer +. b.outer then Some Apart
    else if distance +. error < a.inner +. b.inner then Some Interpenetrating
    else None

(* What a search leads to, as far as it can be proved; for bodies that touch, with the facet that holds the
   origin and where it does. *)
type found =
  | Apart_by of Support_proof.plane
  | Overlap
  | Contact of Support_proof.plane * Support_proof.crossing
  | Open

let overlap c portal = if Support_proof.inside c portal then Overlap else Open

let settle c (guess : Portal.place) =
  match guess with
  | Inside portal -> overlap c portal
  | Facing portal -> (
      match Support_proof.facet c portal with
      | None -> Open
      | Some f -> (
          match Support_proof.height c f with
          | 0 -> (
              match Support_proof.foot c f portal with
              | Outside -> Open
              | (Within | Border _) as crossing -> Contact (f, crossing))
          | h when h < 0 -> Apart_by f
          | _ -> overlap c portal))
  | Apart _ | Lost -> Open

let locate o c question =
  match o.guess.locate question ~hasty:true with
  | Apart direction -> (
      match Support_proof.separating c direction with
      | Some p when Support_proof.apart c p -> Apart_by p
      | Some _ | None -> settle c (o.guess.locate question ~hasty:false))
  | found -> settle c found

let keep_contact o r c f crossing =
  let normals =
    Later.make (fun () ->
        match (crossing : Support_proof.crossing) with
        | Within -> [ Ivec.primitive (Support_proof.normal f) ]
        | Border p -> Support_proof.tight c p
        | Outside -> Bug.fail __POS__ "a contact outside of its portal")
  in
  o.memory.contact <- Some { at = r; normals };
  normals

let relation_by_search o r question =
  let c = Support_proof.make question r Vec.zero in
  match o.memory.plane with
  | Some p when Support_proof.apart c p -> Apart
  | Some _ | None -> (
      match locate o c question with
      | Apart_by p ->
        keep_plane o p;
        Apart
      | Overlap -> Interpenetrating
      | Contact (f, crossing) ->
        ignore (keep_contact o r c f crossing);
        Touching
      | Open -> Facets.relation (Later.force o.all) r)

let still = Shadow.floats Vec.zero

let relation o r =
  let floats = Shadow.floats r in
  match at_first_sight o floats with
  | Some relation -> relation
  | None -> (
      match Question.make o.a o.b floats still with
      | None -> Facets.relation (Later.force o.all) r
      | Some question -> relation_by_search o r question)

let separating_by_search o r =
  let by_facets () = Facets.separating (Later.force o.all) r in
  match Question.make o.a o.b (Shadow.floats r) still with
  | None -> by_facets ()
  | Some question -> (
      let c = Support_proof.make question r Vec.zero in
      match settle c (o.guess.locate question ~hasty:false) with
      | Contact (f, crossing) -> Later.force (keep_contact o r c f crossing)
      | Apart_by _ | Overlap | Open -> by_facets ())

let separating o r =
  match o.memory.contact with
  | Some { at; normals } when Vec.equal at r -> Later.force normals
  | Some _ | None -> separating_by_search o r

(* There is no room at the facets that hold r, and some at all others. *)
let approaching o r w =
  let w, _ = Ivec.of_vec w in
  let collides n = Side.holds (Side.collision ~speed:(Z.sign (Ivec.dot n w))) 0 in
  List.for_all collides (separating o r)

(* {1 Casts} *)

(* How a line, from its infinite past on, meets the interior: not at all from the time 0 on, or through a facet. *)
type passage = Misses of Support_proof.plane | Enters of Support_proof.plane | Unknown

(* Whether the line runs through the interior: strictly inside of a facet it does. *)
let pierces c portal edge =
  match Support_proof.crossing c portal with
  | Outside -> false
  | Within -> true
  | Border _ -> Support_proof.interior c edge

let entry o c portal edge =
  match Support_proof.facet c portal with
  | Some f when Support_proof.speed c f < 0 && pierces c portal edge ->
    o.memory.entrance <- Some { carrier = f; portal };
    Enters f
  | Some _ | None -> Unknown

let misses o p =
  keep_plane o p;
  Misses p

let rec follow o c question (guess : Portal.line) =
  match guess with
  | Apart direction -> (
      match Support_proof.separating c direction with
      | Some p when Support_proof.never c p -> misses o p
      | Some _ | None -> patiently o c question)
  | Beside edge -> (
      match Support_proof.beside c edge with
      | Never p -> misses o p
      | Crosses -> (
          match o.guess.through question edge with
          | Through { portal; edge } -> entry o c portal edge
          | Apart _ | Beside _ | Lost -> Unknown)
      | Unknown -> Unknown)
  | Through { portal; edge } -> entry o c portal edge
  | Lost -> Unknown

and patiently o c question =
  match o.guess.cast question ~hasty:false with
  | Apart _ -> Unknown
  | guess -> follow o c question guess

let remembered o c =
  match (o.memory.plane, o.memory.entrance) with
  | Some p, _ when Support_proof.never c p -> Misses p
  | _, Some { carrier; portal } when Support_proof.speed c carrier < 0 -> (
      match Support_proof.crossing c portal with Within -> Enters carrier | Border _ | Outside -> Unknown)
  | _ -> Unknown

let passage o c question =
  match remembered o c with
  | Unknown -> follow o c question (o.guess.cast question ~hasty:true)
  | known -> known

let inside_now o r =
  match relation o r with
  | Interpenetrating -> Inside
  | Touching | Apart -> Never

let moving_contact o r w =
  let by_facets () = Facets.first_time_of_contact (Later.force o.all) r w in
  match Question.make o.a o.b (Shadow.floats r) (Shadow.floats w) with
  | None -> by_facets ()
  | Some question -> (
      let c = Support_proof.make question r w in
      match passage o c question with
      | Misses _ -> Never
      | Unknown -> by_facets ()
      | Enters f when Support_proof.height c f <= 0 -> At (Support_proof.time c f)
      | Enters _ -> inside_now o r (* entered before time 0: inside still, or through already *))

let first_time_of_contact o r w = if Vec.is_zero w then inside_now o r else moving_contact o r w

(* The closed bodies meet from where the line enters the obstacle to where the reverse line does. A line that
   grazes it is left to all facets. *)
let moving_meeting o r w =
  let passage w =
    match Question.make o.a o.b (Shadow.floats r) (Shadow.floats w) with
    | None -> (None, Unknown)
    | Some question ->
      let c = Support_proof.make question r w in
      (Some c, patiently o c question)
  in
  let by_facets () = Facets.meeting (Later.force o.all) r w in
  match passage w with
  | Some c, Misses p when Support_proof.apart_forever c p -> None
  | Some c, Enters low -> (
      match passage (Vec.neg w) with
      | Some d, Enters high -> Some (Some (Support_proof.time c low), Some (Rat.neg (Support_proof.time d high)))
      | _ -> by_facets ())
  | _ -> by_facets ()

let meeting o r w =
  if Vec.is_zero w then match relation o r with Apart -> None | Touching | Interpenetrating -> Some (None, None)
  else moving_meeting o r w
