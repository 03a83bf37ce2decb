open Scc_exact
open Scc_geometry
open Scc_rigid
open Scc_runs
open Scc_json.Json_format

let not_in_contact at relation = Fault.refuse (Not_in_contact { at; relation })

(* The velocity afterwards, and the spin of what may turn. *)
let result =
  let motion =
    fields [ field "velocity" Shared.vector fst; maybe "spin" Shared.vector snd ] |> Answers.named "motion"
  in
  fields
    [
      field "outcome" (word Fun.id [ "bounced"; "persistent" ]) (fun (outcome, _, _) -> outcome);
      field "first" motion (fun (_, first, _) -> first);
      field "second" motion (fun (_, _, second) -> second);
    ]

(* {1 Bodies} *)

let of_mass = Read.member "mass" Read.positive
let velocity = Contacts.velocity
let is_fixed = Read.member "fixed" (Read.value (Constant [ `Bool true ]))
let fixed_members = [ Read.needs is_fixed ]

let positive_definite (m : Mat.t) =
  let minor = Rat.sub (Rat.mul m.r0.x m.r1.y) (Rat.mul m.r0.y m.r1.x) in
  Rat.sign m.r0.x > 0 && Rat.sign minor > 0 && Rat.sign (Mat.det m) > 0

let inertia =
  let definite _ at m =
    if not (Mat.equal m (Mat.transpose m)) then Fault.invalid at "a symmetric matrix is expected"
    else if positive_definite m then m
    else Fault.invalid at "a positive definite matrix is expected"
  in
  Read.member "inertia" (Read.map definite Read.matrix)

let centre = Read.member "centre" Read.vector
let spin = Read.member "spin" Read.vector
let rigid_members = Read.[ needs of_mass; needs centre; needs inertia; needs velocity; needs spin ]

let plain_members = Read.[ needs of_mass; needs velocity ]

let body =
  let object_of members = Scc_json.Json_schema.Members members in
  Read.(value (defined "body" (Any_of (List.map object_of [ plain_members; rigid_members; fixed_members ]))))

let first = Read.member "first" body
let second = Read.member "second" body

(* A body by its members, or one that is fixed: nothing else is said of it then. *)
let mover members ~fixed read =
  let body _ _ p =
    match Read.optional p is_fixed with
    | None ->
      Read.only p members;
      read p
    | Some (Wire.Bool true) ->
      Read.only p fixed_members;
      fixed
    | Some _ -> Fault.invalid (Read.place p is_fixed) "`true` is expected"
  in
  Read.map body Read.any_fields

(* Mass and velocity; no mass when fixed. *)
let plain_mover =
  mover plain_members ~fixed:(None, Vec.zero) (fun p ->
      (Some (Read.required p of_mass), Read.required p velocity))

(* How the change of the relative velocity is shared: in inverse proportion to the masses. *)
let shares first second =
  match (first, second) with
  | Some m, Some n ->
    let total = Rat.add m n in
    (Rat.div n total, Rat.div m total)
  | None, Some _ -> (Rat.zero, Rat.one)
  | Some _, None -> (Rat.one, Rat.zero)
  | None, None -> Fault.invalid (Member "second") "two fixed bodies do not collide"

(* {1 In translation} *)

let here = Read.member "at" Read.vector
let plain_pair = Read.(fields Contacts.[ needs a; needs b; needs offset ])

let rigid_pair =
  Read.(fields Contacts.[ needs a; needs b; needs offset; may turned_a; may turned_b; may here ])

let touching = Read.member "touching" (Read.value (Read.list ~least:1 rigid_pair).schema)

let pair store _ _ p =
  let a = Shapes.get store p Contacts.a and b = Shapes.get store p Contacts.b in
  { Response.obstacle = Shapes.obstacle store a b; offset = Read.required p Contacts.offset }

let check_touching i (t : Response.touching) =
  match Obstacle.relation t.obstacle t.offset with
  | Touching -> ()
  | (Apart | Interpenetrating) as r -> not_in_contact i (Contacts.relation r)

let translational store p =
  let touching = Read.(required_as (list (map (pair store) plain_pair)) p touching) in
  let m, v = Read.required_as plain_mover p first and n, u = Read.required_as plain_mover p second in
  let share_first, share_second = shares m n in
  List.iteri check_touching touching;
  let w = Vec.sub u v in
  let change = Vec.sub (Response.bounce touching w) w in
  List.iter (fun (t : Response.touching) -> Shapes.tidy store t.obstacle) touching;
  let moved share v = (Vec.axpy share change v, None) in
  let outcome = if Vec.is_zero change then "persistent" else "bounced" in
  (outcome, moved (Rat.neg share_first) v, moved share_second u)

(* {1 Of rigid bodies} *)

let rigid_mover =
  let fixed = { Impact.mass = None; velocity = Vec.zero; spin = Vec.zero } in
  mover rigid_members ~fixed (fun p ->
      let mass =
        {
          Mass.mass = Read.required p of_mass;
          centre = Read.required p centre;
          inertia = Read.required p inertia;
        }
      in
      let velocity = Read.required p velocity in
      { Impact.mass = Some mass; velocity; spin = Read.required p spin })

let pair_of_bodies store _ _ p =
  let solid member = Shapes.get store p member in
  let turned member = Option.value (Read.optional p member) ~default:Quaternion.identity in
  let here = Option.value (Read.optional p here) ~default:Vec.zero in
  let there = Vec.add here (Read.required p Contacts.offset) in
  ( { Placed.solid = solid Contacts.a; turned = turned Contacts.turned_a; at = here },
    { Placed.solid = solid Contacts.b; turned = turned Contacts.turned_b; at = there } )

let near resolution i ((a : Placed.t), (b : Placed.t)) =
  let o = Obstacle.make (Placed.fixed_solid a) (Placed.fixed_solid b) in
  match Obstacle.relation o (Vec.sub b.at a.at) with
  | Interpenetrating -> not_in_contact i "interpenetrating"
  | Apart | Touching -> (
      match Near_contact.find ~resolution a b with
      | Some c -> c
      | None -> not_in_contact i "apart")

let rigid store p resolution =
  let pairs = Read.(required_as (list (map (pair_of_bodies store) rigid_pair)) p touching) in
  let a = Read.required_as rigid_mover p first and b = Read.required_as rigid_mover p second in
  (match (a.mass, b.mass) with
   | None, None -> Fault.invalid (Member "second") "two fixed bodies do not collide"
   | Some _, _ | None, Some _ -> ());
  let contacts = List.mapi (near resolution) pairs in
  let told (m : Impact.mover) = (m.velocity, Some m.spin) in
  match Impact.bounce a b contacts with
  | Bounced (a, b) -> ("bounced", told a, told b)
  | Persistent -> ("persistent", told a, told b)

let response =
  let params = Read.[ needs touching; needs first; needs second; may Contacts.resolution; Method.limits ] in
  let work store p =
    let most = (Read.quotas p).touching in
    (match Read.required p touching with
     | List [] -> Fault.invalid (Member "touching") "at least one pair is needed"
     | List items when List.compare_length_with items most > 0 -> Fault.refuse (Limit ("touching", most))
     | _ -> ());
    match Read.optional p Contacts.resolution with
    | None -> translational store p
    | Some resolution -> rigid store p resolution
  in
  Method.make "response" params result work
