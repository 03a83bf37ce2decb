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

(* How long the numbers of a state are. *)
let bits (s : State.t) =
  let of_rat q = max (Z.numbits (Q.num q)) (Z.numbits (Q.den q)) in
  let of_vec (v : Vec.t) = max (of_rat v.x) (max (of_rat v.y) (of_rat v.z)) in
  let of_leaf most (l : State.leaf) = max most (max (of_vec l.position) (Quaternion.bits l.turned)) in
  let of_process most (p : State.process) =
    Array.fold_left of_leaf (max most (max (of_vec p.velocity) (of_vec p.spin))) p.leaves
  in
  Array.fold_left of_process 0 s.processes

(* Exact numbers grow quickly where nothing is rounded: states with longer ones are left alone. *)
let longest = 800

let successors m s =
  match Network.successors (standard m) s with
  | Ok ts -> ts
  | Error (Persistent_contact _) -> []
  | Error (Bad_law _) -> failwith "a law of motion could not be evaluated"

(* The first states breadth first, each with its transitions. *)
let explored m start ~limit =
  let rec go seen found = function
    | [] -> List.rev found
    | s :: rest ->
      let ts = if bits s > longest then [] else successors m s in
      let fresh =
        List.filter_map
          (fun (t : Transition.t) ->
             if List.exists (State.equal t.target) seen then None else Some t.target)
          ts
      in
      let seen = fresh @ seen in
      if List.length found >= limit then List.rev found else go seen ((s, ts) :: found) (rest @ fresh)
  in
  go [ start ] [] [ start ]

(* A run that chooses now this, now that. *)
let run m start ~steps =
  let rec go s n found =
    if n >= steps || bits s > longest then List.rev found
    else
      match successors m s with
      | [] -> List.rev ((s, []) :: found)
      | ts -> go (List.nth ts (n * 7 mod List.length ts)).target (n + 1) ((s, ts) :: found)
  in
  go start 0 []

let reached network =
  let m, start = Random_rigid.start network in
  (m, explored m start ~limit:8 @ run m start ~steps:16)

let uses rule (t : Transition.t) = List.memq rule t.rules
let say = Printf.sprintf

let with_fixed m (s : State.t) : Transition.label -> bool = function
  | Bounce (p, q) ->
    List.exists (fun leaf -> Option.is_none (State.mass m s.processes.(fst (State.find_leaf s leaf)))) [ p; q ]
  | Time _ | Bind _ | Weak_split _ | Strong_split _ -> false

(* {1 Laws of a state or a transition} *)

let well_formed m s =
  match Well_formed.check (standard m) s with
  | [] -> None
  | fault :: _ -> Some (Well_formed.to_string m s fault)

(* No step lets a process turn by more than 2 atan(1/4); a step that is over is steered unless something
   collides. *)
let steps_are_right m (s : State.t) =
  match s.step with
  | None -> Some "no step"
  | Some step ->
    let turns_too_far (p : State.process) =
      let d = Rat.add p.since step.remaining in
      Rat.compare (Rat.mul (Vec.norm2 p.spin) (Rat.mul d d)) (rational 1 4) > 0
    in
    if Collisions.collides (standard m) s then None
    else if State.equal_phase step.phase Due then Some "a step that is over goes on"
    else if Array.exists turns_too_far s.processes then Some "a process turns too far in a step"
    else None

let find (s : State.t) (p : State.process) =
  s.processes.(fst (State.find_leaf s p.leaves.(0).leaf))

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
  | Bind _ | Bounce _ | Weak_split _ | Strong_split _ -> None

(* Within a turn, time passes in two goes as in one. *)
let additive m (s : State.t) (t : Transition.t) =
  match t.label with
  | Time d ->
    let first = Rat.mul (rational 2 7) d in
    let each p = Turn.pass m (Rat.sub d first) (Turn.pass m first p) in
    if Array.for_all (fun p -> State.equal_process (each p) (Turn.pass m d p)) s.processes then None
    else Some "two passings are not one"
  | Bind _ | Bounce _ | Weak_split _ | Strong_split _ -> None

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
  | Bind _ | Bounce _ | Weak_split _ | Strong_split _ -> None

let resolution m = (Turn.rigid m).resolution

let placed m (s : State.t) (leaf, part) =
  let _, l = State.find_leaf s leaf in
  State.placed m l part

(* Processes collide only when they are within the resolution, and only if they would soon interpenetrate. *)
let collides_in_time m (s : State.t) =
  let near ((a : Part.t), (b : Part.t)) =
    let r = resolution m in
    let distance2 = Scc_rigid.Near_contact.distance2 (placed m s (Part.name a)) (placed m s (Part.name b)) in
    Rat.compare distance2 (Rat.mul r r) <= 0
  in
  let colliding = Collisions.meetings (standard m) s.processes in
  if List.exists (fun (e : Collisions.meeting) -> not (List.for_all near e.approaching)) colliding then
    Some "a collision from afar"
  else None

let rules_are_right m (_ : State.t) (t : Transition.t) =
  let time = match t.label with Time _ -> true | Bind _ | Bounce _ | Weak_split _ | Strong_split _ -> false in
  let rounds = (Turn.rigid m).round_orientation <> None in
  let laws = Array.exists (Steer.steers m) t.target.processes in
  if uses Rule.Turn t <> time then Some "rule Turn where no time passes"
  else if uses Rule.Round t && not rounds then Some "rule Round where nothing rounds"
  else if uses Rule.Steer t && not laws then Some "rule Steer without a law"
  else None

(* {1 Properties} *)

let fail_on = function None -> true | Some why -> QCheck2.Test.fail_report why

let property name ?(count = 25) features holds =
  QCheck2.Test.make ~name ~count ~print:Random_rigid.print (Random_rigid.generate features) holds

let any = Random_rigid.anything
let rounded = { any with rounds = true }
let falling = { any with laws = true; rounds = true }

(* One law after the other at each state, and at each transition. *)
let of_state = [ ("well-formed", well_formed); ("step", steps_are_right); ("contact", collides_in_time) ]

let of_transition =
  [
    ("conservation", Conservation.fault);
    ("time on a process", time_law);
    ("time is additive within a turn", additive);
    ("nothing interpenetrates on the way", between);
    ("rules", rules_are_right);
  ]

let broken network =
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
    (fun (name, features) -> property name features (fun network -> fail_on (broken network)))
    [
      ("laws of states and transitions", any); ("so they are with rounding", rounded);
      ("so they are with laws of motion", falling);
    ]

(* {1 Symmetries} *)

let keeps symmetry network =
  let m, states = reached network in
  let symmetry : Symmetry.t = symmetry m in
  let comparable (s, _) =
    bits s <= longest
    (* that nothing is ahead is proved with cubes along the axes: perhaps here and not there *)
    && Bool.equal
      (Network.quiescent (standard m) s)
      (Network.quiescent (standard (symmetry.model m)) (symmetry.state s))
  in
  fail_on (Symmetry.broken symmetry m (List.filter comparable states))

let turning w x y z =
  let z_of = Z.of_int in
  Symmetry.turning (Quaternion.make (z_of w) (z_of x) (z_of y) (z_of z))

let reversed (m : Model.t) =
  let n = Array.length m.leaves in
  Symmetry.permutation (Array.init n (fun i -> n - 1 - i))

(* In the origin: spins and orientations are seen as they were. *)
let reflection _ : Symmetry.t =
  let process (p : State.process) =
    State.with_velocity (Vec.neg p.velocity)
      (State.map_leaves (fun (l : State.leaf) -> { l with position = Vec.neg l.position }) p)
  in
  let state (s : State.t) =
    State.make ~processes:(List.map process (Array.to_list s.processes)) ~step:s.step ~time:s.time
  in
  { name = "point reflection"; model = Fun.id; state; bond = Fun.id; leaf = Fun.id }

let elsewhere _ = Symmetry.translation (Vec.make (Rat.of_int 5) (rational 1 3) (Rat.of_int (-7)))
let rotation i _ = List.nth Symmetry.rotations i

let symmetries =
  [
    property "nothing depends on where the network is" ~count:20 falling (keeps elsewhere);
    property "a quarter turn" ~count:20 any (keeps (fun _ -> turning 1 0 0 1));
    (* the estimates of the spins of free bodies are rounded along the axes *)
    property "any turn" ~count:10 { any with dynamics = `Constant_spin } (keeps (fun _ -> turning 3 1 (-2) 0));
    property "rotations of a cube, with rounding" ~count:20 rounded (keeps (rotation 7));
    property "parallel components in reverse order" ~count:20 { any with laws = true } (keeps reversed);
    property "point reflection" ~count:20 { rounded with plain = true; behaves = false } (keeps reflection);
  ]

(* {1 Quiescent networks} *)

(* Followed step by step, as if one did not know. *)
let rec nothing_ahead m (s : State.t) n =
  match s.step with
  | Some { remaining; _ } when n > 0 && bits s < longest ->
    let limit = Some remaining in
    let contact () = Collisions.first_time_of_contact (standard m) s.State.processes ~limit in
    if Rat.sign remaining > 0 && Option.is_some (contact ()) then false
    else
      let later = if Rat.sign remaining > 0 then Time.pass (standard m) remaining s else s in
      (match Steer.run (standard m) later with
       | Ok next -> nothing_ahead m next.state (n - 1)
       | Error _ -> false)
  | Some _ | None -> true

let quiescent_and_spins m (s : State.t) =
  Array.exists Turn.spinning s.processes && Network.quiescent (standard m) s

let stays_quiescent network =
  let m, states = reached network in
  List.for_all (fun (s, _) -> (not (quiescent_and_spins m s)) || nothing_ahead m s 50) states

let quiescence =
  [ property "where nothing is ahead, nothing happens" { rounded with behaves = false } stays_quiescent ]

(* So that the properties are about something: over some networks, every kind of transition comes up. *)
let varied () =
  let rand = Random.State.make [| 42 |] in
  let seen = Hashtbl.create 8 in
  let kind m s (t : Transition.t) =
    match t.label with
    | Time _ -> if uses Rule.Round t then "time, rounded" else "time"
    | Bind _ -> "bind"
    | Bounce _ -> if with_fixed m s t.label then "bounce, fixed" else "bounce"
    | Weak_split _ -> "weak"
    | Strong_split _ -> "strong"
  in
  let add kind = Hashtbl.replace seen kind () in
  List.iter
    (fun network ->
       let m, states = reached network in
       List.iter (fun (s, ts) -> 
           if quiescent_and_spins m s then add "quiescent";
           List.iter (fun t -> add (kind m s t)) ts) states)
    (Gen.generate ~rand ~n:60 (Random_rigid.generate rounded));
  let kinds = Hashtbl.fold (fun kind () found -> kind :: found) seen [] in
  Alcotest.(check (list string))
    "kinds of transitions"
    [ "bind"; "bounce"; "bounce, fixed"; "quiescent"; "strong"; "time"; "time, rounded"; "weak" ]
    (List.sort String.compare kinds)

let () =
  Alcotest.run "rigid laws"
    [
      ("scope", [ Alcotest.test_case "every kind of transition comes up" `Quick varied ]);
      ("laws", Scc_test_support.Property.cases laws);
      ("symmetries", Scc_test_support.Property.cases symmetries);
      ("quiescence", Scc_test_support.Property.cases quiescence);
    ]
