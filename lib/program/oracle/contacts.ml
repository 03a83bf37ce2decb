open Scc_exact
open Scc_geometry
open Scc_rigid
open Scc_runs
open Scc_json.Json_format

let relation : Obstacle.relation -> string = function
  | Apart -> "apart"
  | Touching -> "touching"
  | Interpenetrating -> "interpenetrating"

(* {1 Features} *)

let feature =
  let kind (_, (f : Feature.t)) = match f with Vertex _ -> "vertex" | Edge _ -> "edge" | Face _ -> "face" in
  let vertices ((s : Solid.t), (f : Feature.t)) =
    match f with
    | Vertex v -> [ v ]
    | Edge e ->
      let v, w = s.polyhedron.edges.(e) in
      [ v; w ]
    | Face i -> Array.to_list (snd s.polyhedron.faces.(i))
  in
  fields
    [
      field "kind" (word Fun.id [ "vertex"; "edge"; "face" ]) kind;
      field "name" some_text (fun ((s : Solid.t), f) -> Polyhedron.feature_name s.polyhedron f);
      field "vertices" (list ~least:1 natural) vertices;
    ]
  |> Answers.named "feature"

(* Where two touch. *)
type touch = { region : Vec.t list; normals : Vec.t list; pairs : Contact.pair list; highest : Contact.pair }

type found = { relation : string; solids : Solid.t * Solid.t; touch : touch option }

let pair =
  fields
    [
      field "first" feature (fun ((a, _), (t : Contact.pair)) -> (a, t.first));
      field "second" feature (fun ((_, b), (t : Contact.pair)) -> (b, t.second));
      field "dimension" (one_of [ 0; 1; 2 ]) (fun (_, (t : Contact.pair)) -> t.dimension);
    ]
  |> Answers.named "pair"

let found =
  let touch f found = Option.map f found.touch in
  let pairs found = touch (fun t -> List.map (fun p -> (found.solids, p)) t.pairs) found in
  let relations = [ "apart"; "near"; "touching"; "interpenetrating" ] in
  all
    [
      field "relation" (word Fun.id relations) (fun f -> f.relation);
      field "region" (nullable (list ~least:1 Shared.vector)) (touch (fun t -> t.region));
      field "normals" (nullable (list ~least:1 Shared.vector)) (touch (fun t -> t.normals));
      field "pairs" (nullable (list ~least:1 pair)) pairs;
      field "highest" (nullable pair) (fun f -> touch (fun t -> (f.solids, t.highest)) f);
    ]

let normals list = List.map Ivec.to_vec list

(* {1 Contact} *)

let a = Read.member "a" Shapes.handle
let b = Read.member "b" Shapes.handle
let offset = Read.member "offset" Read.vector
let velocity = Read.member "velocity" Read.vector
let turned_a = Read.member "turned_a" Read.quaternion
let turned_b = Read.member "turned_b" Read.quaternion
let resolution = Read.member "resolution" Read.positive

let translational_result = fields [ within fst found; field "approaching" (nullable bool) snd ]

let translational store p a b offset =
  let velocity = Read.optional p velocity in
  let o = Shapes.obstacle store a b in
  let found =
    match Obstacle.relation o offset with
    | (Apart | Interpenetrating) as r -> ({ relation = relation r; solids = (a, b); touch = None }, None)
    | Touching ->
      let normals = normals (Obstacle.separating o offset) in
      let pairs = Contact.touching o offset and highest = Contact.highest o offset in
      let touch = Some { region = Contact.region o offset; normals; pairs; highest } in
      ({ relation = "touching"; solids = (a, b); touch }, Option.map (Obstacle.approaching o offset) velocity)
  in
  Shapes.tidy store o;
  found

let near_result =
  let near f (_, c) = Option.map f c in
  let plane = fields [ field "normal" Shared.vector fst; field "height" Shared.rational snd ] in
  fields
    [
      within fst found;
      field "gap" (nullable Shared.vector) (near (fun (c : Near_contact.t) -> c.gap));
      field "plane" (nullable plane)
        (near (fun (c : Near_contact.t) ->
             let n, height = c.plane in
             (Ivec.to_vec n, height)));
    ]

let near resolution (a : Placed.t) (b : Placed.t) =
  let o = Obstacle.make (Placed.fixed_solid a) (Placed.fixed_solid b) in
  let solids = (a.solid, b.solid) in
  let none relation = ({ relation; solids; touch = None }, None) in
  let found relation =
    match Near_contact.find ~resolution a b with
    | None -> none "apart"
    | Some c ->
      let touch = { region = c.corners; normals = normals c.normals; pairs = c.pairs; highest = c.highest } in
      ({ relation; solids; touch = Some touch }, Some c)
  in
  match Obstacle.relation o (Vec.sub b.at a.at) with
  | Interpenetrating -> none "interpenetrating"
  | Apart -> found "near"
  | Touching -> found "touching"

let turned p member = Option.value (Read.optional p member) ~default:Quaternion.identity

let contact =
  let params =
    Read.
      [
        needs a; needs b; needs offset; may velocity; may turned_a; may turned_b; may resolution; Method.limits;
      ]
  in
  let result =
    union [ case translational_result Either.find_left ignore; case near_result Either.find_right ignore ]
  in
  let work store p =
    let a = Shapes.get store p a and b = Shapes.get store p b in
    let offset = Read.required p offset in
    let without other (m : Scc_json.Json_schema.member) =
      if Read.has p m then Fault.invalid (Member m.name) "it goes %s" other
    in
    match Read.optional p resolution with
    | None ->
      List.iter (without "with `resolution` only") Read.[ may turned_a; may turned_b ];
      Either.Left (translational store p a b offset)
    | Some resolution ->
      without "without `resolution` only" (Read.may velocity);
      let placed solid turn at = { Placed.solid; turned = turned p turn; at } in
      Right (near resolution (placed a turned_a Vec.zero) (placed b turned_b offset))
  in
  Method.make "contact" params result work

(* {1 First time of contact} *)

(* What was found, and by which grid where they may turn. *)
let cast_result =
  let outcome (o, _) = match (o : Obstacle.cast) with Never -> "never" | Inside -> "inside" | At _ -> "at" in
  let time (o, _) = match (o : Obstacle.cast) with At t -> Some t | Never | Inside -> None in
  fields
    [
      field "outcome" (word Fun.id [ "never"; "inside"; "at" ]) outcome;
      field "time" (nullable Answers.quantity) time;
      maybe "grid" natural snd;
    ]

let cast store a b offset velocity =
  let o = Shapes.obstacle store a b in
  let found = Obstacle.first_time_of_contact o offset velocity in
  let answer = Reply.of_format cast_result (found, None) in
  Shapes.tidy store o;
  answer

(* What a body that may turn has beside its shape. *)
type side = {
  turned : Quaternion.t Read.member;
  spin : Vec.t Read.member;
  since : Rat.t Read.member;
  arm : Vec.t Read.member;
}

let side turned name =
  {
    turned;
    spin = Read.member ("spin_" ^ name) Read.vector;
    since = Read.member ("since_" ^ name) Read.not_negative;
    arm = Read.member ("arm_" ^ name) Read.vector;
  }

let side_a = side turned_a "a"
let side_b = side turned_b "b"
let of_side s = Read.[ may s.turned; may s.spin; may s.since; may s.arm ]
let span = Read.member "span" Read.not_negative
let until = Read.member "until" Read.not_negative
let grid = Read.member "grid" Read.natural

let phase =
  let schema = Scc_json.Json_schema.Any_of [ Constant [ `String "turn" ]; Read.not_negative.schema ] in
  Read.member "phase" (Read.value schema)
    ~about:"Since when the grid counts; \"turn\": since the last of their turns began."

let spans = Read.[ may span; may until ]
let rigid_members = spans @ Read.[ may resolution; may grid; may phase ] @ of_side side_a @ of_side side_b

(* [reference] is where the reference point is now; the turn has taken the arm with it. *)
let motion p side (solid : Solid.t) reference velocity : Motion.t =
  let turned = turned p side.turned in
  let spin = Option.value (Read.optional p side.spin) ~default:Vec.zero in
  let since = Option.value (Read.optional p side.since) ~default:Rat.zero in
  let from_centroid () = Vec.neg (Quaternion.apply turned solid.centroid) in
  let arm = match Read.optional p side.arm with Some v -> v | None -> from_centroid () in
  let still = { Motion.solid; turned; arm; centre = Vec.zero; velocity; spin; since } in
  { still with centre = Vec.sub reference (Motion.reference still Rat.zero) }

(* Rule Cast: the grid counts from the start of the last turn of those that go on. *)
let turn_phase (a : Motion.t) (b : Motion.t) =
  match (Vec.is_zero a.spin, Vec.is_zero b.spin) with
  | false, false -> Rat.min a.since b.since
  | false, true -> a.since
  | true, false -> b.since
  | true, true -> Rat.zero

let phase_of a b p : Wire.t -> Rat.t = function
  | Text "turn" -> turn_phase a b
  | value -> Read.not_negative.value p (Read.place p phase) value

let rigid store p a b offset velocity =
  let motion_a = motion p side_a a Vec.zero Vec.zero and motion_b = motion p side_b b offset velocity in
  let grid =
    match (Read.optional p grid, Read.optional p resolution) with
    | Some k, None -> k
    | None, Some resolution -> Cast.grid motion_a motion_b ~resolution
    | None, None ->
      Fault.invalid (Member "resolution") "either `resolution` or `grid` is needed with `span` or `until`"
    | Some _, Some _ -> Fault.invalid (Member "grid") "it does not go with `resolution`"
  in
  let most = (Read.quotas p).grid in
  if grid > most then Fault.refuse (Limit ("grid", most));
  let phase = Option.fold ~none:Rat.zero ~some:(phase_of motion_a motion_b p) (Read.optional p phase) in
  let span =
    match (Read.optional p span, Read.optional p until) with
    | Some span, None -> span
    | None, Some limit -> Cast.next_instant ~grid ~phase limit
    | None, None -> Fault.invalid (Member "span") "a number is missing"
    | Some _, Some _ -> Fault.invalid (Member "until") "it does not go with `span`"
  in
  let obstacle = Shapes.obstacle store a b in
  let outcome = Cast.first_time_of_contact ~obstacle ~phase motion_a motion_b ~span ~grid in
  Shapes.tidy store obstacle;
  let found : Obstacle.cast = match outcome with Never -> Never | Inside -> Inside | At t -> At t in
  Reply.of_format cast_result (found, Some grid)

let plain_members = Read.[ needs a; needs b; needs offset; needs velocity ]

let first_time_of_contact =
  let params = plain_members @ rigid_members @ [ Method.limits ] in
  let work store p =
    let a = Shapes.get store p a and b = Shapes.get store p b in
    let offset = Read.required p offset in
    let velocity = Read.required p velocity in
    if List.exists (Read.has p) spans then begin
      Read.only p params;
      rigid store p a b offset velocity
    end
    else begin
      let without (m : Scc_json.Json_schema.member) =
        if Read.has p m then Fault.invalid (Member m.name) "it goes with `span` or `until` only"
      in
      List.iter without rigid_members;
      Read.only p (plain_members @ [ Method.limits ]);
      cast store a b offset velocity
    end
  in
  { Method.name = "first_time_of_contact"; params; result = schema cast_result; work }
