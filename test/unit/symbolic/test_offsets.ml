(* Constraints on an offset against the queries that answer for one offset, at points of the parameters. *)

open Scc_exact
open Scc_geometry
open Scc_polyhedra
open Scc_offsets

let all_mem constraints point = List.for_all (fun c -> Constraint.mem c point) constraints
let seen = Hashtbl.create 8
let note kind = Hashtbl.replace seen kind (1 + Option.value ~default:0 (Hashtbl.find_opt seen kind))

let agree what scene point a b =
  if a <> b then
    QCheck2.Test.fail_reportf "%s at %s, %s of %s" what (Rat.to_string point.(0)) (Rat.to_string point.(1))
      (Scenes.print scene)

(* {1 Facets} *)

(* By numbers over all facets, and by the proofs of the fast route. *)
let contact scene =
  let o = Scenes.obstacle scene in
  let facets = Half_space.moving o (Scenes.offset scene) (Scenes.velocity scene) in
  let contact = Half_space.contact facets and overlap = Half_space.overlap facets in
  let collision = Half_space.collision facets in
  let all = Facets.make o.a o.b in
  let at point =
    let r = Scenes.offset_at scene point and w = Scenes.velocity scene in
    let look what relation =
      agree (what ^ ", contact") scene point (all_mem contact point) (relation <> Obstacle.Apart);
      agree (what ^ ", overlap") scene point (all_mem overlap point) (relation = Obstacle.Interpenetrating)
    in
    let relation = Obstacle.relation o r in
    look "proved" relation;
    look "over all facets" (Facets.relation all r);
    if relation = Touching then begin
      let approaching = Obstacle.approaching o r w in
      note (if approaching then "a collision" else "a contact");
      agree "approach" scene point (all_mem collision point) approaching;
      let at_once =
        match Obstacle.first_time_of_contact o r w with At t -> Rat.sign t = 0 | Never | Inside -> false
      in
      agree "collision" scene point (all_mem collision point) at_once
    end
  in
  List.iter at Scenes.points;
  true

(* {1 Features} *)

let features (s : Solid.t) =
  List.init (Array.length s.vertices) (fun i -> Feature.Vertex i)
  @ List.init (Array.length s.directions) (fun i -> Feature.Edge i)
  @ List.init (Array.length s.normals) (fun i -> Feature.Face i)

let some_of n list = List.filteri (fun i _ -> (i * 7919) mod 31 < n) list

let pairs scene =
  let o = Scenes.obstacle scene in
  let all = List.concat_map (fun f -> List.map (fun g -> (f, g)) (features o.b)) (features o.a) in
  (o, some_of 4 all)

let side solid feature = { Feature_offsets.solid; feature }

(* Rule Touching, where the bodies do not interpenetrate. *)
let touching scene =
  let memory = Feature_offsets.create () in
  let (o : Obstacle.t), pairs = pairs scene in
  let of_pair (f, g) =
    (f, g, Place.within (Feature_offsets.touching memory (side o.a f) (side o.b g)) (Scenes.offset scene))
  in
  let sets = List.map of_pair pairs in
  let at point =
    let r = Scenes.offset_at scene point in
    match Obstacle.relation o r with
    | Apart | Interpenetrating -> ()
    | Touching ->
      let found = Contact.touching o r in
      let look (f, g, constraints) =
        let is (p : Contact.pair) = Feature.equal p.first f && Feature.equal p.second g in
        let touch = List.find_opt is found in
        agree "touching" scene point (all_mem constraints point) (Option.is_some touch);
        let dimension (p : Contact.pair) =
          note "features that touch";
          let expected = Feature_offsets.dimension memory (side o.a f) (side o.b g) in
          agree "dimension" scene point (p.dimension = expected) true
        in
        Option.iter dimension touch
      in
      List.iter look sets
  in
  List.iter at Scenes.points;
  true

(* Reading I-33: closed features that come to meet. *)
let meeting scene =
  let memory = Feature_offsets.create () in
  let (o : Obstacle.t), pairs = pairs scene in
  let w = Scenes.velocity scene and offset = Scenes.offset scene in
  let now = Linear.constant 2 Rat.zero in
  let of_pair (f, g) =
    let set = Feature_offsets.touching memory (side o.a f) (side o.b g) in
    let passage = Half_space.passage (Half_space.of_closed set offset w) in
    let times, conditions = Half_space.first_meeting passage ~now ~limit:None in
    let at point =
      let r = Scenes.offset_at scene point in
      let corners solid at f =
        Scc_rigid.Placed.corners { Scc_rigid.Placed.solid; turned = Quaternion.identity; at } f
      in
      let expected = Feature_cast.first_meeting (corners o.a Vec.zero f) (corners o.b r g) w in
      let found =
        if all_mem conditions point then
          Some (List.fold_left (fun t f -> Rat.max t (Linear.eval f point)) Rat.zero times)
        else None
      in
      if Option.is_some expected then note "features that meet";
      agree "meeting" scene point (Option.equal Rat.equal expected found) true
    in
    List.iter at (some_of 6 Scenes.points)
  in
  List.iter of_pair (some_of 6 pairs);
  true

let random name ~count ~far check =
  QCheck2.Test.make ~name ~count ~print:Scenes.print (Scenes.generate ~far) check

let tests =
  [
    random "contact, overlap and collision" ~count:200 ~far:3 contact;
    random "features that touch" ~count:120 ~far:3 touching;
    random "features that come to meet" ~count:60 ~far:3 meeting;
  ]

(* So that the properties are about something. *)
let counts () =
  let at_least (n, kind) =
    let k = Option.value ~default:0 (Hashtbl.find_opt seen kind) in
    if k < n then Alcotest.failf "only %d of %s" k kind
  in
  List.iter at_least
    [ (100, "a collision"); (500, "a contact"); (200, "features that touch"); (300, "features that meet") ]

let suite =
  let cases = Scc_test_support.Property.cases tests in
  ("offsets", [ ("random", cases @ [ Alcotest.test_case "enough of all" `Quick counts ]) ])
