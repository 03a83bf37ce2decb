(* Laws of the rigid calculus (rules Turn, Near, Bind, Bounce, Split, Time, Round and Steer), tried on every
   transition of random networks. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_test_networks

let standard = Scc_engine.Standard.of_model
module Gen = QCheck2.Gen

let rational n d = Rat.make (Z.of_int n) (Z.of_int d)

(* {1 Where networks get to} *)

let bits = Rigid_reach.bits
let longest = Rigid_reach.longest
let reached = Rigid_reach.reached

let uses rule (t : Transition.t) = List.memq rule t.rules
let say = Printf.sprintf

let with_fixed m (s : State.t) : Transition.label -> bool = function
  | Bounce { firsts; _ } ->
    List.exists (fun leaf -> Option.is_none (State.mass m (Option.get (State.home s leaf)))) firsts
  | Time _ | Bind _ | Close _ | Absorb _ | Weak_split _ | Strong_split _ | Draw _ | Lot _ -> false

(* {1 Laws of a state or a transition} *)

let well_formed m s =
  match Well_formed.check (standard m) s with
  | [] -> None
  | fault :: _ -> Some (Well_formed.to_string m s fault)

(* What does not collide is in a turn, and not by more than 2 atan(1/4); a step that is over is steered;
   but while somebody waits to draw, all of that waits. *)
let turns_are_right m (s : State.t) =
  let colliding = Collisions.colliding (standard m) s in
  let collides i = List.exists (fun (a, b) -> a = i || b = i) colliding in
  let drawing = Option.is_some (Steer.next_to_draw (standard m) s) in
  let wrong i (p : State.process) =
    match p.lasts with
    | None -> if drawing || collides i then None else Some "a turn that is due does not begin"
    | Some d ->
      let too_far = Rat.compare (Rat.mul (Vec.norm2 p.spin) (Rat.mul d d)) (rational 1 4) > 0 in
      if too_far then Some "a process turns too far" else None
  in
  let due = match s.step with Some { phase = Due; _ } -> true | Some _ | None -> false in
  if due && colliding = [] && not drawing then Some "a step that is over goes on"
  else List.find_map Fun.id (List.mapi wrong (Array.to_list s.processes))

let find (s : State.t) (p : State.process) =
  Option.get (State.home s p.leaves.(0).leaf)

(* Relative poses of the leaves of a process, as its first leaf sees them. *)
let poses (p : State.process) =
  let first = p.leaves.(0) in
  let back = Quaternion.inverse first.turned in
  Array.to_list p.leaves
  |> List.map (fun (l : State.leaf) ->
      (Quaternion.apply back (Vec.sub l.position first.position), Quaternion.mul back l.turned))

let same_poses = List.equal (fun (a, q) (b, r) -> Vec.equal a b && Quaternion.equal q r)

(* Of a process that does not move on: about its centre. *)
let about_centre m p =
  let energy = (Conservation.of_process m p).energy in
  let centre = State.centre_of_mass m p in
  let home (l : State.leaf) = { l with position = Vec.sub l.position centre } in
  ((Conservation.of_process m (State.with_velocity Vec.zero (State.map_leaves home p))).angular, energy)

let is_free (m : Model.t) =
  match m.rigid with
  | Some { dynamics = Free_body; _ } -> true
  | Some { dynamics = Constant_spin; _ } | None -> false

(* What a passing of time does to one process. *)
let passes m d (t : Transition.t) (p : State.process) =
  let q = find t.target p in
  let centre = State.centre_of_mass m in
  let rounded = uses Rule.Round t and steered = uses Rule.Steer t in
  let l_before, e_before = about_centre m (Turn.renew m p) in
  let l_after, e_after = about_centre m (Turn.renew m q) in
  if not (Vec.equal (centre q) (Vec.axpy d p.velocity (centre p))) then Some "a centre strays"
  else if not (same_poses (poses p) (poses q)) then Some "the leaves of a process come apart"
  else if (not (steered || rounded)) && not (Vec.equal p.velocity q.velocity) then Some "a velocity changes"
  else if rounded then None
  else if is_free m then
    if Vec.equal l_before l_after then None else Some "angular momentum changes on the way"
  else if not (Vec.equal p.spin q.spin) then Some "a spin changes"
  else if steered || Rat.equal e_before e_after then None
  else Some "energy changes on the way"

let time_law m (s : State.t) (t : Transition.t) =
  match t.label with
  | Time d -> Array.to_list s.processes |> List.find_map (passes m d t)
  | Bind _ | Close _ | Bounce _ | Absorb _ | Weak_split _ | Strong_split _ | Draw _ | Lot _ -> None

let interpenetrate m s =
  List.find_map
    (function
      | Well_formed.Interpenetration _ as fault -> Some (Well_formed.to_string m s fault)
      | _ -> None)
    (Well_formed.check (standard m) s)

let between m (s : State.t) (t : Transition.t) =
  match t.label with
  | Time d ->
    List.find_map
      (fun (n, k) -> interpenetrate m (Time.pass (standard m) (Rat.mul (rational n k) d) s))
      [ (1, 3); (1, 2); (9, 10); (999, 1000) ]
  | Bind _ | Close _ | Bounce _ | Absorb _ | Weak_split _ | Strong_split _ | Draw _ | Lot _ -> None

let resolution m = (Turn.rigid m).resolution

let placed m (s : State.t) (leaf, part) =
  State.placed m (State.leaf_of (Option.get (State.home s leaf)) leaf) part

(* Processes collide only when they are within the resolution, and only if they would soon interpenetrate. *)
let collides_in_time m (s : State.t) =
  let near ((a : Part.t), (b : Part.t)) =
    let r = resolution m in
    let distance2 = Scc_rigid.Near_contact.distance2 (placed m s (Part.name a)) (placed m s (Part.name b)) in
    Rat.compare distance2 (Rat.mul r r) <= 0
  in
  let semantics = standard m in
  let (module K) = semantics.kinematics in
  let from_afar (a, b) =
    match K.contact semantics.setting a b with Colliding -> not (near (a, b)) | Touching | Apart -> false
  in
  let meetings = Collisions.meetings semantics s.processes in
  if List.exists (fun (e : Kinematics.meeting) -> List.exists from_afar e.touching) meetings then
    Some "a collision from afar"
  else None

let rules_are_right m (_ : State.t) (t : Transition.t) =
  let time = Transition.is_time t.label in
  let rounds = (Turn.rigid m).round_orientation <> None in
  let laws = Array.exists (Steer.steers m) t.target.processes in
  if uses Rule.Turn t <> time then Some "rule Turn where no time passes"
  else if uses Rule.Round t && not rounds then Some "rule Round where nothing rounds"
  else if uses Rule.Steer t && not laws then Some "rule Steer without a law"
  else None

(* {1 Properties} *)

let fail_on = function None -> true | Some why -> QCheck2.Test.fail_report why

let property name ?(count = 3) features holds =
  QCheck2.Test.make ~name ~count ~print:Random_rigid.print (Random_rigid.generate features) holds

let any = Random_rigid.anything
let rounded = { any with rounds = true }
let falling = { any with laws = true; rounds = true }
let switched (f : Random_rigid.features) = { f with switched = true }

(* One law after the other at each state, and at each transition. *)
let preserved =
  ( [ ("well-formed", well_formed); ("turns", turns_are_right); ("contact", collides_in_time) ],
    [ ("nothing interpenetrates on the way", between); ("rules", rules_are_right) ] )

let conserved = ([], [ ("conservation", Conservation.fault); ("time on a process", time_law) ])

let broken (of_state, of_transition) network =
  let m, states = reached network in
  let check x (law, fault) = Option.map (say "%s: %s" law) (fault x) in
  List.find_map
    (fun (s, ts) ->
       match List.find_map (check s) (List.map (fun (law, fault) -> (law, fault m)) of_state) with
       | Some _ as why -> why
       | None ->
         List.find_map
           (fun t -> List.find_map (check t) (List.map (fun (law, fault) -> (law, fault m s)) of_transition))
           ts)
    states

let laws =
  List.map
    (fun (name, features, laws) -> property name features (fun network -> fail_on (broken laws network)))
    [
      ("Preservation: bodies that turn", any, preserved);
      ("Preservation: bodies that turn, with laws and rounding", falling, preserved);
      ("Conservation: bodies that turn", any, conserved);
      ("Conservation: what there is of it with rounding", rounded, conserved);
      ("Conservation: what there is of it with laws of motion", { falling with rounds = false }, conserved);
      ("Preservation: bodies that turn, with the switches of a model", switched falling, preserved);
      ("Conservation: bodies that turn, with the switches of a model", switched any, conserved);
    ]

(* {1 Mirror images} *)

(* In the origin: spins and orientations are seen as they were. *)
let reflection =
  let process (p : State.process) =
    State.with_velocity (Vec.neg p.velocity)
      (State.map_leaves (fun (l : State.leaf) -> { l with position = Vec.neg l.position }) p)
  in
  Symmetry.make "point reflection" (fun s ->
      State.make ~processes:(List.map process (Array.to_list s.State.processes)) ~step:s.step ~time:s.time)

let mirrored network =
  let m, states = reached network in
  let short (s, _) = bits s <= longest in
  fail_on (Symmetry.broken reflection m (List.filter short states))

let mirror =
  [ property "point reflection" ~count:4 { rounded with plain = true; behaves = false } mirrored ]

(* {1 Quiescent networks} *)

(* Followed turn by turn, as if one did not know. *)
let rec nothing_ahead m (s : State.t) n =
  let lefts = List.filter_map Turn.left (Array.to_list s.processes) in
  match lefts with
  | first :: rest when n > 0 && bits s < longest ->
    let left = List.fold_left Rat.min first rest in
    Option.is_none (Collisions.first_time_of_contact (standard m) s.processes ~limit:(Some left))
    &&
    (match Steer.settle (standard m) (Time.pass (standard m) left s) with
     | Ok next -> nothing_ahead m next.state (n - 1)
     | Error _ -> false)
  | _ -> true

let quiescent_and_spins m (s : State.t) =
  Array.exists Turn.spinning s.processes && Network.quiescent (standard m) s

let stays_quiescent network =
  let m, states = reached network in
  List.for_all (fun (s, _) -> (not (quiescent_and_spins m s)) || nothing_ahead m s 50) states

let quiescence =
  [ property "where nothing is ahead, nothing happens" { rounded with behaves = false } stays_quiescent ]

(* So that the properties are about something: over some networks, every kind of transition comes up that is
   expected, and no other, unless it is one of those that may. *)
let varied ?(seen_as = Fun.id) ?(may = []) features expected () =
  let rand = Random.State.make [| 42 |] in
  let seen = Hashtbl.create 8 in
  let kind m s (t : Transition.t) =
    match t.label with
    | Time _ -> if uses Rule.Round t then "time, rounded" else "time"
    | Bind _ -> "bind"
    | Close _ -> "close"
    | Bounce _ -> if with_fixed m s t.label then "bounce, fixed" else "bounce"
    | Absorb _ -> "absorb"
    | Draw _ -> "draw"
    | Lot { decision; _ } -> Transition.decision_to_string decision
    | Weak_split _ -> "weak"
    | Strong_split _ -> "strong"
  in
  let add kind = Hashtbl.replace seen kind () in
  let look network =
    let m, states = reached network in
    List.iter
      (fun (s, ts) ->
         if quiescent_and_spins m s then add "quiescent";
         List.iter (fun t -> add (kind m s t)) ts)
      states
  in
  (* Random numbers differ between versions of OCaml, and so does how many networks it takes. *)
  let rec until_all_are_seen n =
    if n > 0 && not (List.for_all (Hashtbl.mem seen) expected) then begin
      look (seen_as (Gen.generate1 ~rand (Random_rigid.generate features)));
      until_all_are_seen (n - 1)
    end
  in
  until_all_are_seen 1000;
  let kinds = Hashtbl.fold (fun kind () found -> kind :: found) seen [] in
  let kinds = List.filter (fun kind -> List.mem kind expected || not (List.mem kind may)) kinds in
  Alcotest.(check (list string))
    "kinds of transitions" (List.sort String.compare expected)
    (List.sort String.compare kinds)

let () =
  let all = [ "bind"; "bounce"; "bounce, fixed"; "strong"; "time"; "time, rounded"; "weak" ] in
  let switched = { rounded with switched = true } in
  let rings =
    varied ~seen_as:(Random_rigid.with_switches Switches.rings) ~may:("quiescent" :: all) switched [ "close" ]
  in
  Alcotest.run "rigid laws"
    [
      ( "scope",
        [
          Alcotest.test_case "every kind of transition comes up" `Quick (varied rounded ("quiescent" :: all));
          Alcotest.test_case "with switches, too" `Quick
            (varied ~may:[ "close" ] switched ([ "absorb"; "first"; "keep"; "quiescent"; "release" ] @ all));
          (* Among networks with any switches they are rare. *)
          Alcotest.test_case "rings" `Quick rings;
        ] );
      ("laws", Scc_test_support.Property.cases laws);
      ("mirror images", Scc_test_support.Property.cases mirror);
      ("quiescence", Scc_test_support.Property.cases quiescence);
    ]
