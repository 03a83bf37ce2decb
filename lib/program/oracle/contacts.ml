open Scc_exact
open Scc_geometry
open Scc_rigid
open Scc_json

let relation : Obstacle.relation -> string = function
  | Apart -> "apart"
  | Touching -> "touching"
  | Interpenetrating -> "interpenetrating"

(* {1 Features} *)

let feature (s : Solid.t) (f : Feature.t) =
  let p = s.polyhedron in
  let kind, vertices =
    match f with
    | Vertex v -> ("vertex", [ v ])
    | Edge e ->
      let v, w = p.edges.(e) in
      ("edge", [ v; w ])
    | Face i -> ("face", Array.to_list (snd p.faces.(i)))
  in
  `Assoc
    [
      ("kind", `String kind);
      ("name", Json.text (Polyhedron.feature_name p f));
      ("vertices", `List (List.map (fun v -> `Int v) vertices));
    ]

let pair (a : Solid.t) (b : Solid.t) (t : Contact.pair) =
  `Assoc
    [ ("first", feature a t.first); ("second", feature b t.second); ("dimension", `Int t.dimension) ]

let vectors list = `List (List.map Json.vec list)
let normals list = vectors (List.map Ivec.to_vec list)

(* How two are, and where they touch. *)
let touch ~relation ~region ~normals:ns ~pairs ~highest a b =
  [
    ("relation", `String relation);
    ("region", vectors region);
    ("normals", normals ns);
    ("pairs", `List (List.map (pair a b) pairs));
    ("highest", pair a b highest);
  ]

let no_touch relation =
  ("relation", `String relation)
  :: List.map (fun member -> (member, `Null)) [ "region"; "normals"; "pairs"; "highest" ]

(* {1 Contact} *)

let translational store p a b offset =
  let velocity = Read.optional p "velocity" Read.vector in
  let o = Shapes.obstacle store a b in
  let members =
    match Obstacle.relation o offset with
    | (Apart | Interpenetrating) as r -> no_touch (relation r) @ [ ("approaching", `Null) ]
    | Touching ->
      let approaching w = `Bool (Obstacle.approaching o offset w) in
      touch ~relation:"touching" ~region:(Contact.region o offset) ~normals:(Obstacle.separating o offset)
        ~pairs:(Contact.touching o offset) ~highest:(Contact.highest o offset) a b
      @ [ ("approaching", Json.option approaching velocity) ]
  in
  Shapes.tidy store o;
  members

let near resolution (a : Placed.t) (b : Placed.t) =
  let o = Obstacle.make (Placed.fixed_solid a) (Placed.fixed_solid b) in
  let none relation = no_touch relation @ [ ("gap", `Null); ("plane", `Null) ] in
  let found name =
    match Near_contact.find ~resolution a b with
    | None -> none "apart"
    | Some c ->
      let n, height = c.plane in
      let plane = `Assoc [ ("normal", Json.vec (Ivec.to_vec n)); ("height", Json.rat height) ] in
      touch ~relation:name ~region:c.corners ~normals:c.normals ~pairs:c.pairs ~highest:c.highest a.solid b.solid
      @ [ ("gap", Json.vec c.gap); ("plane", plane) ]
  in
  match Obstacle.relation o (Vec.sub b.at a.at) with
  | Interpenetrating -> none "interpenetrating"
  | Apart -> found "near"
  | Touching -> found "touching"

let turned p name = Option.value (Read.optional p name Read.quaternion) ~default:Quaternion.identity

let contact store p =
  Read.only p [ "a"; "b"; "offset"; "velocity"; "turned_a"; "turned_b"; "resolution"; "limits" ];
  let a = Read.required p "a" (Shapes.shape store) and b = Read.required p "b" (Shapes.shape store) in
  let offset = Read.required p "offset" Read.vector in
  let without other member =
    if Read.has p member then Fault.invalid (Member member) "it goes %s" other
  in
  match Read.optional p "resolution" Read.positive with
  | None ->
    List.iter (without "with `resolution` only") [ "turned_a"; "turned_b" ];
    Reply.Value (`Assoc (translational store p a b offset))
  | Some resolution ->
    without "without `resolution` only" "velocity";
    let placed solid name at = { Placed.solid; turned = turned p name; at } in
    Reply.Value (`Assoc (near resolution (placed a "turned_a" Vec.zero) (placed b "turned_b" offset)))

(* {1 First time of contact} *)

let never = ("outcome", `String "never")
let inside = ("outcome", `String "inside")
let at = ("outcome", `String "at")

let cast store a b offset velocity =
  let o = Shapes.obstacle store a b in
  let members =
    match Obstacle.first_time_of_contact o offset velocity with
    | Never -> [ never; ("time", `Null) ]
    | Inside -> [ inside; ("time", `Null) ]
    | At t -> [ at; ("time", Reply.quantity t) ]
  in
  Shapes.tidy store o;
  members

let turning = [ "turned_"; "spin_"; "since_"; "arm_" ]
let of_side side = List.map (fun name -> name ^ side) turning
let spans = [ "span"; "until" ]
let rigid_members = spans @ [ "resolution"; "grid"; "phase" ] @ of_side "a" @ of_side "b"

(* [reference] is where the reference point is now; the turn has taken the arm with it. *)
let motion p side (solid : Solid.t) reference velocity : Motion.t =
  let read name kind = Read.optional p (name ^ side) kind in
  let turned = Option.value (read "turned_" Read.quaternion) ~default:Quaternion.identity in
  let spin = Option.value (read "spin_" Read.vector) ~default:Vec.zero in
  let since = Option.value (read "since_" Read.not_negative) ~default:Rat.zero in
  let from_centroid () = Vec.neg (Quaternion.apply turned solid.centroid) in
  let arm = match read "arm_" Read.vector with Some v -> v | None -> from_centroid () in
  let still = { Motion.solid; turned; arm; centre = Vec.zero; velocity; spin; since } in
  { still with centre = Vec.sub reference (Motion.reference still Rat.zero) }

(* Rule Cast: the grid counts from the start of the last turn of those that go on. *)
let turn_phase (a : Motion.t) (b : Motion.t) =
  match (Vec.is_zero a.spin, Vec.is_zero b.spin) with
  | false, false -> Rat.min a.since b.since
  | false, true -> a.since
  | true, false -> b.since
  | true, true -> Rat.zero

let phase a b p place : Wire.t -> Rat.t = function
  | Text "turn" -> turn_phase a b
  | value -> Read.not_negative p place value

let rigid store p a b offset velocity =
  let motion_a = motion p "a" a Vec.zero Vec.zero and motion_b = motion p "b" b offset velocity in
  let grid =
    match (Read.optional p "grid" Read.natural, Read.optional p "resolution" Read.positive) with
    | Some k, None -> k
    | None, Some resolution -> Cast.grid motion_a motion_b ~resolution
    | None, None ->
      Fault.invalid (Member "resolution") "either `resolution` or `grid` is needed with `span` or `until`"
    | Some _, Some _ -> Fault.invalid (Member "grid") "it does not go with `resolution`"
  in
  let most = (Read.quotas p).grid in
  if grid > most then Fault.refuse (Limit ("grid", most));
  let phase = Option.value (Read.optional p "phase" (phase motion_a motion_b)) ~default:Rat.zero in
  let span =
    match (Read.optional p "span" Read.not_negative, Read.optional p "until" Read.not_negative) with
    | Some span, None -> span
    | None, Some limit -> Cast.next_instant ~grid ~phase limit
    | None, None -> Fault.invalid (Member "span") "a number is missing"
    | Some _, Some _ -> Fault.invalid (Member "until") "it does not go with `span`"
  in
  let obstacle = Shapes.obstacle store a b in
  let outcome = Cast.first_time_of_contact ~obstacle ~phase motion_a motion_b ~span ~grid in
  Shapes.tidy store obstacle;
  let answer =
    match outcome with
    | Never -> [ never; ("time", `Null) ]
    | Inside -> [ inside; ("time", `Null) ]
    | At t -> [ at; ("time", Reply.quantity t) ]
  in
  answer @ [ ("grid", `Int grid) ]

let plain_members = [ "a"; "b"; "offset"; "velocity"; "limits" ]

let first_time_of_contact store p =
  let a = Read.required p "a" (Shapes.shape store) and b = Read.required p "b" (Shapes.shape store) in
  let offset = Read.required p "offset" Read.vector in
  let velocity = Read.required p "velocity" Read.vector in
  if List.exists (Read.has p) spans then begin
    Read.only p (rigid_members @ plain_members);
    Reply.Value (`Assoc (rigid store p a b offset velocity))
  end
  else begin
    let without name = if Read.has p name then Fault.invalid (Member name) "it goes with `span` or `until` only" in
    List.iter without rigid_members;
    Read.only p plain_members;
    Reply.Value (`Assoc (cast store a b offset velocity))
  end
