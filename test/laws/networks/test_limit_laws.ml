(* The law Convergence: what is known of runs as the timestep, the resolution and the split step go to 0. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_test_networks
module Gen = QCheck2.Gen

let standard = Scc_engine.Standard.of_model
let rational n d = Rat.make (Z.of_int n) (Z.of_int d)
let say = Printf.sprintf
let half = rational 1 2

(* {1 The timestep} *)

(* One cube, by itself. *)
let alone ~law ~rigid ~timestep ~velocity ~spin =
  let solid = Random_rigid.cube ~id:0 in
  let part =
    { Model.name = "p"; template = "Cube"; solid; offset = Vec.zero; open_offset = None; mass = Rat.one }
  in
  let leaf : Model.leaf =
    { name = "p"; template = "Cube"; parts = [| part |]; fixed = false; absorbs = false; mass = Rat.one; law;
      law_at = Scc_base.Span.none }
  in
  let none = Random_network.model Random_network.none in
  let m = { none with leaves = [| leaf |]; timestep; steered = true; rigid } in
  let behaviour = Behaviour.fresh Behaviour.nil in
  let leaf = { State.leaf = 0; position = Vec.zero; turned = Quaternion.identity; waited = Rat.zero; behaviour } in
  let p = State.process ~leaves:[ leaf ] ~bonds:[] ~velocity ~spin ~clock:None () in
  (m, Reach.initial m (State.make ~processes:[ p ] ~step:None ~time:None))

(* A cube above a fixed one, which it meets face to face. *)
let over_a_floor ~law ~timestep ~height =
  let solid = Random_rigid.cube ~id:0 in
  let leaf name ~fixed law : Model.leaf =
    let part = { Model.name; template = "Cube"; solid; offset = Vec.zero; open_offset = None; mass = Rat.one } in
    { name; template = "Cube"; parts = [| part |]; fixed; absorbs = false; mass = Rat.one; law;
      law_at = Scc_base.Span.none }
  in
  let leaves = [| leaf "floor" ~fixed:true Inertial; leaf "p" ~fixed:false law |] in
  let m = { (Random_network.model Random_network.none) with leaves; timestep; steered = true } in
  let process leaf z =
    let behaviour = Behaviour.fresh Behaviour.nil in
    let position = Vec.make Rat.zero Rat.zero z in
    let leaf = { State.leaf; position; turned = Quaternion.identity; waited = Rat.zero; behaviour } in
    State.process ~leaves:[ leaf ] ~bonds:[] ~velocity:Vec.zero ~clock:None ()
  in
  let processes = [ process 0 (Rat.of_int (-2)); process 1 height ] in
  (m, Reach.initial m (State.make ~processes ~step:None ~time:None))

(* The state after a time, where each state has one transition. *)
let rec at m s d =
  let soon (t : Transition.t) =
    Rat.compare (Transition.duration t) d <= 0 && (Rat.sign d > 0 || not (Transition.is_time t.label))
  in
  match Reach.successors m s with
  | [ t ] when soon t ->
    at m t.target (Rat.sub d (Transition.duration t))
  | [ _ ] | [] -> Time.pass (standard m) d s
  | _ -> failwith "a choice"

(* The state after a number of steps; passing time is all that is possible. *)
let rec after m s n =
  if n = 0 then s
  else
    match Reach.successors m s with
    | [ t ] -> after m t.target (n - 1)
    | [] -> after m (Time.pass (standard m) m.timestep s) (n - 1)
    | _ -> failwith "something else is possible"

let falls =
  let open Gen in
  QCheck2.Test.make ~name:"Convergence: a body that falls is too high by half of g times the time times the step"
    ~count:40
    ~print:(fun (g, v, n, d) -> say "g %d, velocity %d, %d steps of 1/%d" g v n d)
    (quad (-9 -- 9) (-9 -- 9) (0 -- 30) (1 -- 40))
    (fun (g, v, n, d) ->
       let step = rational 1 d in
       let down : Law.expr = Sub (Var Vz, Mul (Const (Rat.of_int g), Var Dt)) in
       let law = Law.Gives (Law.velocity_alone (Var Vx, Var Vy, down)) in
       let m, start =
         alone ~law ~rigid:None ~timestep:step ~velocity:(Vec.of_ints 0 0 v) ~spin:Vec.zero
       in
       let height = (after m start n).processes.(0).leaves.(0).position.z in
       let t = Rat.mul (Rat.of_int n) step and g = Rat.of_int g in
       let ideal = Rat.sub (Rat.mul (Rat.of_int v) t) (Rat.mul half (Rat.mul g (Rat.mul t t))) in
       Rat.equal height (Rat.add ideal (Rat.mul half (Rat.mul g (Rat.mul t step)))))

(* By the angle about z, in floats: the exact one is no rational. *)
let spins =
  let open Gen in
  QCheck2.Test.make ~name:"Convergence: a body that spins falls short by the square of the step" ~count:25
    ~print:(fun (w, n, d) -> say "spin %d/8, %d steps of 1/%d" w n d)
    (triple (1 -- 8) (1 -- 20) (4 -- 40))
    (fun (w, n, d) ->
       let rigid =
         Some
           {
             Model.dynamics = Constant_spin; resolution = rational 1 1024; round_orientation = None;
           }
       in
       let spin = Vec.make Rat.zero Rat.zero (rational w 8) in
       let m, start = alone ~law:Inertial ~rigid ~timestep:(rational 1 d) ~velocity:Vec.zero ~spin in
       let q = (after m start n).processes.(0).leaves.(0).turned in
       let angle = 2. *. atan2 (Q.to_float (Q.of_bigint q.z)) (Q.to_float (Q.of_bigint q.w)) in
       let step = 1. /. float_of_int d and w = float_of_int w /. 8. in
       let t = float_of_int n *. step in
       let turns = (w *. t -. angle) /. (8. *. atan 1.) in
       let short = (turns -. Float.round turns) *. 8. *. atan 1. in
       short > -1e-9 && short <= (w *. w *. w *. step *. step *. t /. 12.) +. 1e-9)

(* {1 The resolution} *)

let finer (m : Model.t) =
  let rigid (r : Model.rigid) = { r with resolution = Rat.mul (rational 1 1000) r.resolution } in
  { m with rigid = Option.map rigid m.rigid }

let contact m (s : State.t) =
  let least d p = match (d, Turn.left p) with None, e | e, None -> e | Some d, Some e -> Some (Rat.min d e) in
  let limit = Array.fold_left least None s.processes in
  Collisions.first_time_of_contact (standard m) s.processes ~limit

(* Some two that collide at the instant that the coarse one finds come no nearer to each other, by what is missing,
   than the resolution. *)
let within_resolution m (s : State.t) early missing =
  let r = Turn.(rigid m).resolution in
  let there = if Rat.sign early = 0 then s else Time.pass (standard m) early s in
  let near (e : Kinematics.meeting) =
    let w = Vec.sub there.processes.(e.second).velocity there.processes.(e.first).velocity in
    Rat.compare (Rat.mul (Vec.norm2 w) (Rat.mul missing missing)) (Rat.mul r r) <= 0
  in
  List.exists near (Collisions.meetings (standard m) there.processes)

let contacts =
  QCheck2.Test.make ~name:"Convergence: the first contact comes early, by no more than the resolution" ~count:25
    ~print:Random_rigid.print
    (Random_rigid.generate { Random_rigid.anything with behaves = false })
    (fun n ->
       let m, states = Rigid_reach.reached n in
       let agrees (s, _) =
         Rigid_reach.bits s > 200
         || Collisions.collides (standard m) s
         ||
         match (contact m s, contact (finer m) s) with
         | None, None -> true
         | Some early, Some late ->
           let missing = Rat.sub late early in
           Rat.sign missing >= 0 && within_resolution m s early missing
         | Some _, None | None, Some _ -> false
       in
       List.for_all agrees (List.filteri (fun i _ -> i < 6) states))

(* {1 The split step} *)

let without_clocks (s : State.t) =
  State.make
    ~processes:(List.map (State.with_clock None) (Array.to_list s.processes))
    ~step:s.step ~time:s.time

(* Lets a time pass, however many transitions it takes; nothing where it does not pass. *)
let rec pass m s d =
  if Rat.sign d = 0 then Some s
  else
    match List.find_opt (fun (t : Transition.t) -> Transition.is_time t.label) (Reach.successors m s) with
    | Some t when Rat.compare (Transition.duration t) d <= 0 -> pass m t.target (Rat.sub d (Transition.duration t))
    | Some _ | None -> None

(* What leads from a state of the finer model to where a transition of the coarser one leads. *)
let follows fine s (t : Transition.t) =
  let same s = State.equal (without_clocks s) (without_clocks t.target) in
  match t.label with
  | Time d -> Option.bind (pass fine s d) (fun s -> if same s then Some s else None)
  | label ->
    List.find_opt
      (fun (u : Transition.t) -> Transition.equal_label u.label label && same u.target)
      (Reach.successors fine s)
    |> Option.map (fun (u : Transition.t) -> u.target)

let split_step (m : Model.t) = match m.splits with Every step -> step | Any_time -> assert false

let splits =
  QCheck2.Test.make ~name:"Convergence: runs of a split step are runs of its half, and of its third" ~count:60
    ~print:(fun (n, _) -> Random_network.print n)
    (Gen.pair (Random_network.generate ()) Gen.(2 -- 3))
    (fun (n, k) ->
       let m, start = Random_network.start n in
       let fine = { m with splits = Every (Rat.div (split_step m) (Rat.of_int k)) } in
       let rec go budget = function
         | (s, s') :: rest when budget > 0 ->
           let followed (t : Transition.t) =
             match follows fine s' t with
             | Some target -> (t.target, target)
             | None -> QCheck2.Test.fail_reportf "%s is lost" (Transition.label_to_string m t.label)
           in
           go (budget - 1) (rest @ List.map followed (Reach.successors m s))
         | _ -> true
       in
       go 40 [ (start, start) ])

(* {1 Windows}

   From a state in which a bond may be released and time may pass by d: with a split step that is a part of d, once
   that has passed. What comes of a split at once, when as much time has passed, is as far as places and motions go
   what comes of the split then. *)

let with_clocks_at_0 (s : State.t) =
  let restart (p : State.process) = State.with_clock (Option.map (fun _ -> Rat.zero) p.clock) p in
  State.make ~processes:(List.map restart (Array.to_list s.processes)) ~step:s.step ~time:s.time

type window = { d : Rat.t; wait : Rat.t; whole : State.t; at_once : State.t; later : State.t }

let weak_splits = List.filter (fun (t : Transition.t) -> match t.label with Weak_split _ -> true | _ -> false)

(* The windows that a state has, each with one bond that is released; an error where it is not possible later. *)
let windows (m : Model.t) part (s, _) =
  let s = with_clocks_at_0 s in
  let ts = Reach.successors { m with splits = Every (Rat.of_int 1_000) } s in
  match List.find_opt (fun (t : Transition.t) -> Transition.is_time t.label) ts with
  | None -> []
  | Some t ->
    let d = Transition.duration t in
    let wait = Rat.mul part d in
    let fine = { m with splits = Every wait } in
    let there =
      Reach.successors fine s
      |> List.find_opt (fun (t : Transition.t) -> Rat.equal (Transition.duration t) wait)
    in
    let of_split (u : Transition.t) =
      let same (v : Transition.t) = Transition.equal_label u.label v.label in
      let later = Option.map (fun (t : Transition.t) -> Reach.successors fine t.target) there in
      match Option.bind later (List.find_opt same) with
      | None -> QCheck2.Test.fail_report "the window is missed"
      | Some v -> { d; wait; whole = s; at_once = u.target; later = v.target }
    in
    List.map of_split (weak_splits ts)

let windows_of n k =
  let m, start = Random_network.start n in
  let states = Reach.states m start ~limit:60 in
  (m, List.concat_map (windows m (rational k 13)) states)

let turning_windows_of n k =
  let m, states = Rigid_reach.reached n in
  let short (s, _) = Rigid_reach.(bits s <= longest) in
  (m, List.concat_map (windows m (rational k 13)) (List.filter short states))

(* Many bonds. *)
let sticking =
  let stuck n = Random_network.(with_switches Switches.by_contact (sticking n)) in
  Gen.map stuck (Random_network.switched ())

let in_translation =
  QCheck2.Test.make ~name:"Convergence: within a window, when a split happens tells on no place" ~count:30
    ~print:(fun (n, _) -> Random_network.print n)
    (Gen.pair sticking Gen.(1 -- 12))
    (fun (n, k) ->
       let m, windows = windows_of n k in
       let bare s = without_clocks (Rewriting.without_behaviours s) in
       let same w = State.equal (bare (Time.pass (standard m) w.wait w.at_once)) (bare w.later) in
       List.for_all same windows)

let constant_spin = Random_rigid.generate { Random_rigid.anything with dynamics = `Constant_spin }

(* A piece at r from the centre of a whole that spins by w has its velocity of the instant, and goes on straight:
   so the two differ by no more than |w| |r| (2 + |w| d) times what was waited. *)
let of_turning =
  QCheck2.Test.make ~name:"Convergence: of bodies that turn, places follow the split instant" ~count:16
    ~print:(fun (n, _) -> Random_rigid.print n)
    (Gen.pair constant_spin Gen.(1 -- 12))
    (fun (n, k) ->
       let m, windows = turning_windows_of n k in
       let centre = State.centre_of_mass m in
       let close w (p : State.process) =
         let whole = Option.get (State.home w.whole p.leaves.(0).leaf) in
         let before = Option.get (State.home w.at_once p.leaves.(0).leaf) in
         let rest = Rat.sub w.d w.wait in
         let one = centre (Turn.pass m w.d before) and other = centre (Turn.pass m rest p) in
         let w2 = Vec.norm2 whole.spin and r2 = Vec.norm2 (Vec.sub (centre before) (centre whole)) in
         let root q = Rat.sqrt_above q.Q.num q.Q.den in
         let speed = root (Rat.mul w2 r2) in
         let bound = Rat.mul w.wait (Rat.mul speed (Rat.add (Rat.of_int 2) (Rat.mul (root w2) w.d))) in
         Rat.compare (Vec.norm2 (Vec.sub one other)) (Rat.mul bound bound) <= 0
       in
       List.for_all (fun w -> Array.for_all (close w) w.later.processes) windows)

(* So that they are about something. *)
let there_are_windows () =
  let drawn gen = Gen.generate ~rand:(Random.State.make [| 42 |]) ~n:30 gen in
  let count windows_of gen =
    List.fold_left (fun k n -> k + List.length (snd (windows_of n 5))) 0 (drawn gen)
  in
  Alcotest.(check bool) "in translation" true (count windows_of sticking > 20);
  Alcotest.(check bool) "where bodies turn" true (count turning_windows_of constant_spin > 5)

(* {1 Bounces} *)

(* A cube falls from rest on a floor, and comes back. *)
let bounces =
  let open Gen in
  QCheck2.Test.make ~name:"Convergence: a body that falls and bounces is off by no more than the step" ~count:16
    ~print:(fun (g, t, n, d) -> say "g %d, falls for %d/4, %d steps of 1/%d" g t n d)
    (quad (1 -- 9) (2 -- 8) (0 -- 60) (8 -- 60))
    (fun (g, t, n, d) ->
       let gravity = Rat.of_int g and fall = rational t 4 and step = rational 1 d in
       let square x = Rat.mul x x in
       let height = Rat.mul half (Rat.mul gravity (square fall)) in
       let down : Law.expr = Sub (Var Vz, Mul (Const gravity, Var Dt)) in
       let law = Law.Gives (Law.velocity_alone (Var Vx, Var Vy, down)) in
       let m, start = over_a_floor ~law ~timestep:step ~height in
       let time = Rat.min (Rat.mul (Rat.of_int n) step) (Rat.mul (rational 7 4) fall) in
       let s = at m start time in
       let z = s.State.processes.(1).leaves.(0).position.z in
       let ideal =
         let since = Rat.sub time fall in
         if Rat.sign since <= 0 then Rat.sub height (Rat.mul half (Rat.mul gravity (square time)))
         else Rat.sub (Rat.mul gravity (Rat.mul fall since)) (Rat.mul half (Rat.mul gravity (square since)))
       in
       let off = Rat.abs (Rat.sub z ideal) in
       Rat.compare off (Rat.mul (Rat.of_int 3) (Rat.mul step (Rat.mul gravity time))) <= 0)

(* The first bounce, if it is one of two that meet by themselves. *)
let first_bounce m s =
  let rec go s n =
    match Reach.successors m s with
    | [ { label = Time _; target; _ } ] when n > 0 -> go target (n - 1)
    | [ { label = Bounce _; target; _ } ] -> Some target
    | _ -> None
  in
  go s 40

let at_resolution k (m : Model.t) =
  let rigid (r : Model.rigid) = { r with resolution = Rat.make Z.one (Z.shift_left Z.one k) } in
  { m with rigid = Option.map rigid m.rigid }

(* Velocities and spins of all processes. *)
let motions (s : State.t) =
  List.concat_map (fun (p : State.process) -> [ p.velocity; p.spin ]) (Array.to_list s.processes)

let bounces_of_turning =
  QCheck2.Test.make ~name:"Convergence: a first bounce of bodies that turn follows the resolution" ~count:10
    ~print:Random_rigid.print
    (Random_rigid.generate { Random_rigid.anything with behaves = false })
    (fun n ->
       let m = Random_rigid.model n in
       let declared = Random_rigid.declared n in
       let after k = let m = at_resolution k m in first_bounce m (Reach.initial m declared) in
       match (after 20, after 32) with
       | Some s, Some t ->
         let near v w = Rat.compare (Vec.norm2 (Vec.sub v w)) (rational 1 1_000_000) <= 0 in
         List.for_all2 near (motions s) (motions t)
       | None, None -> true
       | None, Some _ | Some _, None -> QCheck2.Test.fail_report "one bounces, the other does not")

let suite =
  ("limit laws",
   [
     ( "Convergence",
       Scc_test_support.Property.cases
         [ falls; spins; contacts; splits; in_translation; of_turning; bounces; bounces_of_turning ]
       @ [ Alcotest.test_case "there are windows" `Quick there_are_windows ] );
   ])
