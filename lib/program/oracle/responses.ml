open Scc_exact
open Scc_geometry
open Scc_rigid
open Scc_json

let not_in_contact at relation = Fault.refuse (Not_in_contact { at; relation })

let answer outcome first second =
  Reply.Value
    (`Assoc [ ("outcome", `String outcome); ("first", `Assoc first); ("second", `Assoc second) ])

(* {1 In translation} *)

let is_fixed p =
  match Read.optional p "fixed" Read.value with
  | None -> false
  | Some (Bool true) ->
    Read.only p [ "fixed" ];
    true
  | Some _ -> Fault.invalid (Read.within p "fixed") "`true` is expected"

(* Mass and velocity; no mass when fixed. *)
let mover p at v =
  let p = Read.fields p at v in
  if is_fixed p then (None, Vec.zero)
  else begin
    Read.only p [ "mass"; "velocity" ];
    (Some (Read.required p "mass" Read.positive), Read.required p "velocity" Read.vector)
  end

(* How the change of the relative velocity is shared: in inverse proportion to the masses. *)
let shares first second =
  match (first, second) with
  | Some m, Some n ->
    let total = Rat.add m n in
    (Rat.div n total, Rat.div m total)
  | None, Some _ -> (Rat.zero, Rat.one)
  | Some _, None -> (Rat.one, Rat.zero)
  | None, None -> Fault.invalid (Member "second") "two fixed bodies do not collide"

let pair store p at v =
  let p = Read.fields p at v in
  Read.only p [ "a"; "b"; "offset" ];
  let a = Read.required p "a" (Shapes.shape store) and b = Read.required p "b" (Shapes.shape store) in
  { Response.obstacle = Shapes.obstacle store a b; offset = Read.required p "offset" Read.vector }

let check_touching i (t : Response.touching) =
  match Obstacle.relation t.obstacle t.offset with
  | Touching -> ()
  | (Apart | Interpenetrating) as r -> not_in_contact i (Contacts.relation r)

let translational store p =
  let touching = Read.required p "touching" (Read.list (pair store)) in
  let m, v = Read.required p "first" mover and n, u = Read.required p "second" mover in
  let share_first, share_second = shares m n in
  List.iteri check_touching touching;
  let w = Vec.sub u v in
  let change = Vec.sub (Response.bounce touching w) w in
  List.iter (fun (t : Response.touching) -> Shapes.tidy store t.obstacle) touching;
  let moved share v = [ ("velocity", Json.vec (Vec.axpy share change v)) ] in
  answer
    (if Vec.is_zero change then "persistent" else "bounced")
    (moved (Rat.neg share_first) v) (moved share_second u)

(* {1 Of rigid bodies} *)

let positive_definite (m : Mat.t) =
  let minor = Rat.sub (Rat.mul m.r0.x m.r1.y) (Rat.mul m.r0.y m.r1.x) in
  Rat.sign m.r0.x > 0 && Rat.sign minor > 0 && Rat.sign (Mat.det m) > 0

let inertia p at v =
  let m = Read.matrix p at v in
  if not (Mat.equal m (Mat.transpose m)) then Fault.invalid at "a symmetric matrix is expected"
  else if positive_definite m then m
  else Fault.invalid at "a positive definite matrix is expected"

let rigid_mover p at v : Impact.mover =
  let p = Read.fields p at v in
  if is_fixed p then { mass = None; velocity = Vec.zero; spin = Vec.zero }
  else begin
    Read.only p [ "mass"; "centre"; "inertia"; "velocity"; "spin" ];
    let mass =
      {
        Mass.mass = Read.required p "mass" Read.positive;
        centre = Read.required p "centre" Read.vector;
        inertia = Read.required p "inertia" inertia;
      }
    in
    let velocity = Read.required p "velocity" Read.vector in
    { mass = Some mass; velocity; spin = Read.required p "spin" Read.vector }
  end

let rigid_pair store p at v =
  let p = Read.fields p at v in
  Read.only p [ "a"; "b"; "offset"; "turned_a"; "turned_b"; "at" ];
  let solid name = Read.required p name (Shapes.shape store) in
  let turned name = Option.value (Read.optional p name Read.quaternion) ~default:Quaternion.identity in
  let here = Option.value (Read.optional p "at" Read.vector) ~default:Vec.zero in
  let there = Vec.add here (Read.required p "offset" Read.vector) in
  ( { Placed.solid = solid "a"; turned = turned "turned_a"; at = here },
    { Placed.solid = solid "b"; turned = turned "turned_b"; at = there } )

let near resolution i ((a : Placed.t), (b : Placed.t)) =
  let o = Obstacle.make (Placed.fixed_solid a) (Placed.fixed_solid b) in
  match Obstacle.relation o (Vec.sub b.at a.at) with
  | Interpenetrating -> not_in_contact i "interpenetrating"
  | Apart | Touching -> (
      match Near_contact.find ~resolution a b with
      | Some c -> c
      | None -> not_in_contact i "apart")

let rigid store p resolution =
  let pairs = Read.required p "touching" (Read.list (rigid_pair store)) in
  let a = Read.required p "first" rigid_mover and b = Read.required p "second" rigid_mover in
  (match (a.mass, b.mass) with
   | None, None -> Fault.invalid (Member "second") "two fixed bodies do not collide"
   | Some _, _ | None, Some _ -> ());
  let contacts = List.mapi (near resolution) pairs in
  let told (m : Impact.mover) = [ ("velocity", Json.vec m.velocity); ("spin", Json.vec m.spin) ] in
  match Impact.bounce a b contacts with
  | Bounced (a, b) -> answer "bounced" (told a) (told b)
  | Persistent -> answer "persistent" (told a) (told b)

let response store p =
  Read.only p [ "touching"; "first"; "second"; "resolution"; "limits" ];
  let most = (Read.quotas p).touching in
  (match Read.required p "touching" Read.value with
   | List [] -> Fault.invalid (Member "touching") "at least one pair is needed"
   | List items when List.compare_length_with items most > 0 -> Fault.refuse (Limit ("touching", most))
   | _ -> ());
  match Read.optional p "resolution" Read.positive with
  | None -> translational store p
  | Some resolution -> rigid store p resolution
