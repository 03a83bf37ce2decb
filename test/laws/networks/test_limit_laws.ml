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
  let part = { Model.name = "p"; template = "Cube"; solid; offset = Vec.zero; mass = Rat.one } in
  let leaf : Model.leaf =
    { name = "p"; template = "Cube"; parts = [| part |]; fixed = false; mass = Rat.one; law }
  in
  let none = Random_network.model Random_network.none in
  let m = { none with leaves = [| leaf |]; timestep; steered = true; rigid } in
  let behaviour = Behaviour.fresh Behaviour.nil in
  let leaf = { State.leaf = 0; position = Vec.zero; turned = Quaternion.identity; waited = Rat.zero; behaviour } in
  let p = State.process ~leaves:[ leaf ] ~bonds:[] ~velocity ~spin ~clock:None () in
  (m, Reach.initial m (State.make ~processes:[ p ] ~step:None ~time:None))

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
    ~count:100
    ~print:(fun (g, v, n, d) -> say "g %d, velocity %d, %d steps of 1/%d" g v n d)
    (quad (-9 -- 9) (-9 -- 9) (0 -- 30) (1 -- 40))
    (fun (g, v, n, d) ->
       let step = rational 1 d in
       let law : Law.t = Velocity (Var Vx, Var Vy, Sub (Var Vz, Mul (Const (Rat.of_int g), Var Dt))) in
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
  QCheck2.Test.make ~name:"Convergence: a body that spins falls short by the square of the step" ~count:60
    ~print:(fun (w, n, d) -> say "spin %d/8, %d steps of 1/%d" w n d)
    (triple (1 -- 8) (1 -- 20) (4 -- 40))
    (fun (w, n, d) ->
       let rigid =
         Some
           {
             Model.dynamics = Constant_spin; resolution = rational 1 1024; round_orientation = None;
             round_velocity = None;
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
  QCheck2.Test.make ~name:"Convergence: the first contact comes early, by no more than the resolution" ~count:60
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

let splits =
  QCheck2.Test.make ~name:"Convergence: runs of a split step are runs of its half, and of its third" ~count:150
    ~print:(fun (n, _) -> Random_network.print n)
    (Gen.pair (Random_network.generate ()) Gen.(2 -- 3))
    (fun (n, k) ->
       let m, start = Random_network.start n in
       let fine = { m with split_step = Rat.div m.split_step (Rat.of_int k) } in
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

let () =
  Alcotest.run "limit laws"
    [
      ( "Convergence",
        Scc_test_support.Property.cases [ falls; spins; contacts; splits ] );
    ]
