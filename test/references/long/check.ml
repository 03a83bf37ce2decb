open Scc_exact
open Scc_geometry
module Naive = Scc_naive.Naive
module Fast = Scc_naive.Fast

type group = {
  first : Shapes.body;
  second : Shapes.body;
  obstacle : Obstacle.t;
  swapped : Obstacle.t;
  every : Fast.t;
  fast : Fast.t;
  aim : Aim.pair;
}

let solid ~id (b : Shapes.body) = Solid.make ~id b.shape.polyhedron b.linear

(* With more axes than this, only those of facets are looked at in every case. *)
let many_axes = 150

let group first second =
  let a = solid ~id:0 first and b = solid ~id:1 second in
  let at_a = Shapes.place first and at_b = Shapes.place second in
  let every = Fast.make at_a at_b in
  let fast = if Fast.axes every > many_axes then Fast.reduce every else every in
  { first; second; obstacle = Obstacle.make a b; swapped = Obstacle.make b a; every; fast;
    aim = Aim.pair at_a at_b fast }

let aim g = g.aim
let size g = Fast.axes g.fast
let show g = Printf.sprintf "  A: %s\n  B: %s" (Shapes.show g.first) (Shapes.show g.second)

exception Differs of string

type extras = { swapped : bool; fresh : bool; all_axes : bool; naive : bool }

(* {1 Answers in words} *)

let of_relation : Obstacle.relation -> Naive.relation = function
  | Apart -> Apart
  | Touching -> Touching
  | Interpenetrating -> Interpenetrating

let of_cast : Obstacle.cast -> Naive.cast = function Never -> Never | Inside -> Inside | At t -> At t

let relation_word : Naive.relation -> string = function
  | Apart -> "apart"
  | Touching -> "touching"
  | Interpenetrating -> "interpenetrating"

let cast_word : Naive.cast -> string = function
  | Never -> "never"
  | Inside -> "inside"
  | At t -> "at " ^ Rat.to_string t

let meeting_word = function
  | None -> "never"
  | Some (low, high) ->
    let bound = function None -> "always" | Some t -> Rat.to_string t in
    bound low ^ " to " ^ bound high

let directions_word ns = String.concat " " (List.map Ivec.to_string ns)

let same word what x y =
  let x = word x and y = word y in
  if not (String.equal x y) then raise (Differs (Printf.sprintf "%s: %s instead of %s" what x y))

let same_flag what x y = same string_of_bool what x y

(* The words above are canonical, but numbers need not be written out to be compared. *)
let same_cast what (x : Naive.cast) (y : Naive.cast) =
  match (x, y) with At s, At t when Rat.equal s t -> () | _ -> same cast_word what x y

let same_meeting what x y =
  let agree (a, b) (c, d) = Option.equal Rat.equal a c && Option.equal Rat.equal b d in
  if not (Option.equal agree x y) then same meeting_word what x y

(* {1 Contacts} *)

let in_order = List.sort Ivec.compare

let contact what g o r w =
  same directions_word (what ^ ", separating") (in_order (Obstacle.separating o r)) (Fast.tight g.fast r);
  same_flag (what ^ ", approaching") (Obstacle.approaching o r w) (Fast.approaching g.fast r w)

let compare_lists = List.compare Int.compare

let compare_pair (f, g, (d : int)) (f', g', d') =
  let c = compare_lists f f' in
  if c <> 0 then c
  else
    let c = compare_lists g g' in
    if c <> 0 then c else Int.compare d d'

let pair_word (f, g, d) =
  let corners f = String.concat "," (List.map string_of_int f) in
  Printf.sprintf "%s/%s(%d)" (corners f) (corners g) d

let pairs_word ps = String.concat " " (List.map pair_word ps)

let corners (s : Solid.t) = function
  | Feature.Vertex i -> [ i ]
  | Feature.Edge i ->
    let v, w = s.polyhedron.edges.(i) in
    [ v; w ]
  | Feature.Face i -> List.sort Int.compare (Array.to_list (snd s.polyhedron.faces.(i)))

let by_corners (o : Obstacle.t) (p : Contact.pair) = (corners o.a p.first, corners o.b p.second, p.dimension)

(* The highest pair holds all others in its closure: the features that are on top in the direction that is the
   sum of the separating ones. *)
let highest g (o : Obstacle.t) r =
  let sum = List.fold_left Ivec.add Ivec.zero (Fast.tight g.fast r) in
  let f, h = Fast.support g.fast sum in
  let found, other, _ = by_corners o (Contact.highest o r) in
  same pairs_word "highest pair" [ (found, other, 0) ] [ (f, h, 0) ]

(* Every pair of features; the highest is the one of them whose corners include those of all others; and the
   corners of the region are the pairs that meet in a point. *)
let features g (o : Obstacle.t) r =
  let a = g.aim.a and b = Naive.move Mat.identity r g.aim.b in
  let theirs = List.sort compare_pair (Naive.touching a b) in
  let ours = List.sort compare_pair (List.map (by_corners o) (Contact.touching o r)) in
  same pairs_word "touching features" ours theirs;
  let includes (f, h, _) (f', h', _) =
    let all_in big = List.for_all (fun i -> List.exists (Int.equal i) big) in
    all_in f f' && all_in h h'
  in
  let top = List.filter (fun p -> List.for_all (includes p) theirs) theirs in
  same pairs_word "highest pair of all" [ by_corners o (Contact.highest o r) ] top;
  let at (s : Naive.solid) = List.map (Array.get s.points) in
  let meets x (f, h, _) =
    Naive.relative_interiors_meet (at a f) [ x ] && Naive.relative_interiors_meet (at b h) [ x ]
  in
  let points = List.filter (fun (_, _, d) -> d = 0) theirs and region = Contact.region o r in
  same string_of_int "corners of the region" (List.length region) (List.length points);
  same_flag "each corner of the region at a pair of features" true
    (List.for_all (fun x -> List.exists (meets x) points) region)

(* {1 A case} *)

let slow g (c : Aim.case) =
  let a = g.aim.a and b = Naive.move Mat.identity c.r g.aim.b in
  same relation_word "fast brute force, relation" (Fast.relation g.every c.r) (Naive.relation a b);
  same_cast "fast brute force, cast" (Fast.first_time_of_contact g.every c.r c.w)
    (Naive.first_time_of_contact a b c.w);
  same_meeting "fast brute force, meeting" (Fast.meeting g.every c.r c.w) (Naive.meeting a b c.w)

let ask g o what (c : Aim.case) (relation, cast, meeting) =
  same relation_word (what ^ "relation") (of_relation (Obstacle.relation o c.r)) relation;
  same_cast (what ^ "cast") (of_cast (Obstacle.first_time_of_contact o c.r c.w)) cast;
  same_meeting (what ^ "meeting") (Obstacle.meeting o c.r c.w) meeting;
  match (relation, cast) with
  | Naive.Touching, _ -> contact (what ^ "contact at the start") g o c.r c.w; Some c.r
  | _, Naive.At t ->
    let r = Vec.axpy t c.w c.r in
    same relation_word (what ^ "relation at the collision") (of_relation (Obstacle.relation o r)) Touching;
    same_flag (what ^ "approaching at the collision") (Obstacle.approaching o r c.w) true;
    contact (what ^ "contact at the collision") g o r c.w;
    Some r
  | _ -> None

let answers fast (c : Aim.case) =
  (Fast.relation fast c.r, Fast.first_time_of_contact fast c.r c.w, Fast.meeting fast c.r c.w)

let mirrored (g : group) (c : Aim.case) (relation, cast, meeting) =
  let o = g.swapped and r = Vec.neg c.r and w = Vec.neg c.w in
  same relation_word "swapped, relation" (of_relation (Obstacle.relation o r)) relation;
  same_cast "swapped, cast" (of_cast (Obstacle.first_time_of_contact o r w)) cast;
  same_meeting "swapped, meeting" (Obstacle.meeting o r w) meeting;
  match (relation : Naive.relation) with
  | Touching ->
    let back = in_order (List.map Ivec.neg (Obstacle.separating o r)) in
    same directions_word "swapped, separating" back (Fast.tight g.fast c.r);
    same_flag "swapped, approaching" (Obstacle.approaching o r w) (Fast.approaching g.fast c.r c.w)
  | Apart | Interpenetrating -> ()

let outcome (relation, cast, meeting) =
  let start =
    match (relation : Naive.relation) with Apart -> "" | Touching -> "touching: " | Interpenetrating -> "" in
  let rest =
    match ((cast : Naive.cast), meeting) with
    | Inside, _ -> "inside"
    | At t, _ -> if Rat.sign t = 0 then "at 0" else "later"
    | Never, None -> "never meet"
    | Never, Some (_, Some last) when Rat.sign last < 0 -> "in the past"
    | Never, Some _ -> "graze or leave"
  in
  start ^ rest

let case (g : group) extras (c : Aim.case) =
  let expected = answers g.fast c in
  let _, cast, _ = expected in
  Option.iter (same_cast "brute force and construction" cast) c.known;
  let o = g.obstacle in
  let touching = ask g o "" c expected in
  Option.iter (highest g o) touching;
  if extras.swapped then mirrored g c expected;
  if extras.fresh then begin
    let o = Obstacle.make g.obstacle.a g.obstacle.b in
    (* in the other order, so that nothing has been asked when the cast is *)
    same_cast "fresh, cast" (of_cast (Obstacle.first_time_of_contact o c.r c.w)) cast;
    ignore (ask g (Obstacle.make g.obstacle.a g.obstacle.b) "fresh, " c expected)
  end;
  if extras.all_axes then begin
    let relation, cast', meeting = answers g.every c and relation', _, meeting' = expected in
    same relation_word "all axes, relation" relation relation';
    same_cast "all axes, cast" cast' cast;
    same_meeting "all axes, meeting" meeting meeting'
  end;
  if extras.naive then begin
    slow g c;
    Option.iter (features g o) touching
  end;
  outcome expected
