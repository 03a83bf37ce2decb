(* The law Locality of the rule book: networks that are far apart run as their product, on random networks. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_test_networks
module Gen = QCheck2.Gen

let standard = Scc_engine.Standard.of_model

(* {1 Two networks as one} *)

type network = { model : Model.t; states : (State.t * Transition.t list) list }

let apart = Vec.of_ints 100_000 3_000 (-70_000)

let together (a : Model.t) (b : Model.t) : Model.t =
  { a with leaves = Array.append a.leaves b.leaves; steered = a.steered || b.steered }

(* The leaves of the second come after those of the first. *)
let moved from by (p : State.process) =
  let finish (f : State.finish) = { f with at = f.at + from } in
  let bond (b : State.bond) = State.bond b.name (finish b.one) (finish b.two) in
  let leaf (l : State.leaf) = { l with leaf = l.leaf + from; position = Vec.add l.position by } in
  State.process
    ~leaves:(List.map leaf (Array.to_list p.leaves))
    ~bonds:(List.map bond (Array.to_list p.bonds))
    ?phase:p.phase ?draw:p.draw
    ?lots:(Option.map (Symmetry.mapped_lots ~bond ~leaf:(fun l -> l + from)) p.lots)
    ~velocity:p.velocity ~spin:p.spin ~since:p.since ~lasts:p.lasts
    ~kept:p.kept ~clock:p.clock ()

let beside from (a : State.t) (b : State.t) =
  let second = List.map (moved from apart) (Array.to_list b.processes) in
  State.make ~processes:(Array.to_list a.processes @ second) ~step:None ~time:None

let relabelled from : Transition.label -> Transition.label =
  let finish (f : State.finish) = { f with at = f.at + from } in
  let bond (b : State.bond) = State.bond b.name (finish b.one) (finish b.two) in
  let all = List.map (fun (r : Transition.release) -> { r with bond = bond r.bond }) in
  function
  | Time d -> Time d
  | Bind b -> Bind (bond b)
  | Close b -> Close (bond b)
  | Lot l -> Lot { l with bond = bond l.bond }
  | Draw d -> Draw { d with first = d.first + from }
  | Weak_split releases -> Weak_split (all releases)
  | Strong_split releases -> Strong_split (all releases)
  | Absorb { first; absorber } -> Absorb { first = first + from; absorber = absorber + from }
  | Bounce { firsts; hits } ->
    let later leaf = leaf + from in
    let hit (h : Transition.hit) : Transition.hit =
      let part (leaf, index) = (later leaf, index) in
      { one = part h.one; two = part h.two }
    in
    Bounce { firsts = List.map later firsts; hits = List.map hit hits }

(* {1 What the product does} *)

let is_urgent (_, ts) = List.exists (fun (t : Transition.t) -> Transition.is_urgent t.label) ts
let discrete ts = List.filter (fun (t : Transition.t) -> not (Transition.is_time t.label)) ts

let least a b =
  match (a, b) with
  | None, x | x, None -> x
  | Some s, Some t -> Some (Rat.min s t)

(* How far time passes: for what is at rest, to the end of a turn, since another one may not be at rest. *)
let waits m (s, ts) =
  match List.find_opt (fun (t : Transition.t) -> Transition.is_time t.label) ts with
  | Some t -> Some (Transition.duration t)
  | None ->
    let turn = Array.fold_left (fun d p -> least d (Turn.left p)) None s.State.processes in
    if Array.exists (fun (p : State.process) -> Option.is_some p.phase) s.processes then
      least turn (Time.step_left m s)
    else turn

(* After a time that it may wait: with what is due then. *)
let after m d (s, ts) =
  let settled s =
    match Steer.settle (standard m) s with
    | Ok { state; _ } -> state
    | Error _ -> failwith "a law of motion"
  in
  match List.find_opt (fun (t : Transition.t) -> Transition.is_time t.label) ts with
  | Some t when Rat.equal (Transition.duration t) d -> t.target
  | Some _ | None -> settled (Time.pass (standard m) d s)

let same (label, target) (t : Transition.t) =
  Transition.equal_label label t.label && State.equal target t.target

let rec same_sets expected got =
  match expected with
  | [] -> got = []
  | x :: rest ->
    let equal, others = List.partition (same x) got in
    (match equal with _ :: more -> same_sets rest (more @ others) | [] -> false)

(* So long nothing of one comes to where the other is. *)
let horizon = Rat.of_int 1_000

let broken a b (((s, s_transitions) as one), ((t, t_transitions) as two)) =
  let m = together a.model b.model in
  let n = Array.length a.model.leaves in
  let whole = beside n s t in
  let left = List.map (fun (u : Transition.t) -> (u.label, beside n u.target t)) (discrete s_transitions) in
  let right =
    List.map (fun (u : Transition.t) -> (relabelled n u.label, beside n s u.target)) (discrete t_transitions)
  in
  let time =
    if is_urgent one || is_urgent two then []
    else
      match least (waits a.model one) (waits b.model two) with
      | None -> []
      | Some d -> [ (Transition.Time d, beside n (after a.model d one) (after b.model d two)) ]
  in
  let expected = left @ right @ time in
  match Network.successors (standard m) whole with
  | Error _ -> None
  | Ok got ->
    let far (t : Transition.t) = Rat.compare (Transition.duration t) horizon > 0 in
    let at_rest (s, ts) = ts = [] && Network.quiescent (standard m) s in
    if same_sets expected got then None
    else if List.exists far got then None
    else if at_rest one && at_rest two then None
    else
      let show label = Transition.label_to_string m label in
      Some
        (Printf.sprintf "expected %s; got %s"
           (String.concat "; " (List.map (fun (l, _) -> show l) expected))
           (String.concat "; " (List.map (fun (t : Transition.t) -> show t.label) got)))

let pairs a b =
  let every k list = List.filteri (fun i _ -> i mod k = 0) list in
  let some list = every (Int.max 1 (List.length list / 6)) list in
  List.concat_map (fun s -> List.map (fun t -> (s, t)) (some b.states)) (some a.states)

let fail_on = function None -> true | Some why -> QCheck2.Test.fail_report why

let law name ~count ~print gen start =
  QCheck2.Test.make ~name ~count
    ~print:(fun (a, b) -> print a ^ "\nand\n" ^ print b)
    (Gen.pair gen gen)
    (fun (first, second) ->
       let a, b = start first second in
       fail_on (List.find_map (broken a b) (pairs a b)))

(* {1 Random networks} *)

let straight first second =
  let reach network =
    let model, start = Random_network.start network in
    { model; states = Reach.states model start ~limit:40 }
  in
  (reach first, reach (Random_network.like first second))

(* Each process under a law has steps of its own. *)
let by_itself (m : Model.t) = { m with steps = Own }

let falling first second =
  let reach network =
    let m = by_itself (Random_network.model network) in
    { model = m; states = Reach.states m (Reach.initial m (Random_network.declared network)) ~limit:40 }
  in
  (reach first, reach (Random_network.like first second))

let falling_and_turning first second =
  let reach network =
    let m = by_itself (Random_rigid.model network) in
    let states = Rigid_reach.states m (Reach.initial m (Random_rigid.declared network)) in
    let short (s, _) = Rigid_reach.bits s <= Rigid_reach.longest in
    { model = m; states = List.filter short states }
  in
  (reach first, reach (Random_rigid.like first second))

let turning first second =
  let reach network =
    let model, states = Rigid_reach.reached network in
    let short (s, _) = Rigid_reach.bits s <= Rigid_reach.longest in
    { model; states = List.filter short states }
  in
  (reach first, reach (Random_rigid.like first second))

let laws =
  [
    law "Locality: networks that are far apart are their product" ~count:20 ~print:Random_network.print
      (Random_network.generate ()) straight;
    law "Locality: with rounding" ~count:20 ~print:Random_network.print (Random_network.rounding ()) straight;
    law "Locality: bodies that turn" ~count:3 ~print:Random_rigid.print
      (Random_rigid.generate Random_rigid.anything)
      turning;
    law "Locality: bodies that turn, with rounding" ~count:3 ~print:Random_rigid.print
      (Random_rigid.generate { Random_rigid.anything with rounds = true })
      turning;
    law "Locality: laws of motion with steps of single processes" ~count:20 ~print:Random_network.print
      (Random_network.generate ~steered:true ())
      falling;
    law "Locality: bodies that turn, with such laws and rounding" ~count:3 ~print:Random_rigid.print
      (Random_rigid.generate { Random_rigid.anything with rounds = true; laws = true })
      falling_and_turning;
    law "Locality: with the switches of a model" ~count:10 ~print:Random_network.print
      (Random_network.switched ~steered:true ~draws:false ())
      falling;
    law "Locality: bodies that turn, with the switches of a model" ~count:3 ~print:Random_rigid.print
      (Random_rigid.generate
         { Random_rigid.anything with rounds = true; laws = true; switched = true; draws = false })
      falling_and_turning;
  ]

let suite = ("locality", [ ("Locality", Scc_test_support.Property.cases laws) ])
