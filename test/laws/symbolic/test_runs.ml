(* Runs that are shown of formulas over zones, looked at again by other means: the state is asked at the ends and
   within of every passing of time, and what goes on for ever is followed further. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_polyhedra
open Scc_evaluate
open Scc_explain
open Scc_verify
open Scc_zones
module Gen = QCheck2.Gen

(* What a run has to be like. *)
type claim =
  | Never of Property.prop  (** AF p is violated, EG not p holds *)
  | Never_after of Property.prop * Property.prop  (** p leads_to q is violated *)
  | Not_until of Property.prop * Property.prop  (** A[p U q] is violated *)
  | Comes of Property.prop * Property.prop  (** E[p U q] holds *)
  | Next of Property.prop  (** EX p holds, AX p is violated *)

type case = { scene : Scene.t; claims : claim list; bound : int; some_run : bool }

let bound c : Property.bound =
  { low = Rat.zero; high = (if c.scene.timed then Some (Rat.of_int c.bound) else None) }

let formula c : claim -> Property.temporal =
  let state p = Property.State p and b = bound c in
  function
  | Never p -> if c.some_run then Globally (Exists, b, state (Not p)) else Finally (All, b, state p)
  | Never_after (p, q) ->
    let anytime = { b with high = None } in
    Globally (All, anytime, Temporal_or [ state (Not p); Finally (All, anytime, state q) ])
  | Not_until (p, q) -> Until (All, b, state p, state q)
  | Comes (p, q) -> Until (Exists, b, state p, state q)
  | Next p -> Next ((if c.some_run then Exists else All), state p)

(* A cube that goes to and fro for ever, far from all others, between walls of which one is where a parameter
   says. *)
let chamber ~speed ~far =
  let body base velocity kind moved : Scene.body =
    { shape = 0; base; moved; velocity; mass = 1; kind; behaviour = Nil }
  in
  [
    body (0, 90, 0) (speed, 0, 0) Free None;
    body (-5, 90, 0) (0, 0, 0) Fixed None;
    body (5 + far, 90, 0) (0, 0, 0) Fixed (Some (0, 0, 1));
  ]

(* Not so while the cube passes by, unless something else is. *)
let beyond prop =
  let open Gen in
  let x = Property.Quantity (Position (X, 2)) in
  let+ p = prop and+ c = -2 -- 2 and+ bonded = bool in
  let number n = Property.Const (Rat.of_int n) in
  let or_else = if bonded then Property.Not (Fact (Bound (0, 1))) else p in
  Property.Or [ Compare (Lt, x, number c); Compare (Gt, x, number (c + 1)); or_else ]

let generate =
  let open Gen in
  let* some_bound = bool in
  let* scene = if some_bound then Scene.generate_bound else Scene.generate in
  let* speed = 1 -- 2 and* far = 0 -- 1 and* is_in_chamber = bool in
  let scene =
    if not is_in_chamber then scene
    else
      let two = List.filteri (fun i _ -> i < 2) scene.bodies in
      { scene with bodies = two @ chamber ~speed ~far }
  in
  let leaves = List.length scene.bodies in
  let prop = Predicates.generate leaves ~timed:false 1 in
  let bonded = Property.Fact (Bound (0, 1)) in
  let prop = frequency [ (3, prop); (1, pure bonded); (1, pure (Property.Not bonded)) ] in
  let prop = if is_in_chamber then frequency [ (1, prop); (1, beyond prop) ] else prop in
  let claim =
    let* p = prop and* q = prop in
    let one = [ Never p; Not_until (p, q); Comes (p, q); Next p ] in
    oneofl (if scene.timed then one else Never_after (p, q) :: one)
  in
  let+ claims = list_repeat 5 claim and+ bound = 1 -- 5 and+ some_run = bool in
  { scene; claims; bound; some_run }

(* {1 What is seen on a run} *)

type position = { state : State.t; arrived : Property.event -> bool; clock : Rat.t }

let nothing _ = false

let is p position =
  let c, prop = p in
  let t = Trajectory.prop (Trajectory.make ~arrived:position.arrived c position.state Instant) prop in
  t.start = Scc_ctl.Truth.True

let later c (p : position) d =
  { state = Time.pass c d p.state; arrived = nothing; clock = Rat.add p.clock d }

let parts_of d = List.map (fun (a, b) -> Rat.mul d (Rat.make (Z.of_int a) (Z.of_int b))) [ (1, 7); (1, 2); (6, 7) ]

(* The positions that a run goes through, as samples. *)
let rec seen c (p : position) = function
  | [] -> [ p ]
  | (s : Witness.step) :: rest ->
    let within = match s.transition.label with Time d -> List.map (later c p) (parts_of d) | _ -> [] in
    let arrived e = Event.matches ~source:p.state s.transition.label e in
    let clock = Rat.add p.clock (Transition.duration s.transition) in
    (p :: within) @ seen c { state = s.transition.target; arrived; clock } rest

let last list = List.nth list (List.length list - 1)

(* The steps of a cycle once more, from where it ends: by labels. *)
let again c state cycle =
  let step (state, steps) (s : Witness.step) =
    let successors = match Network.successors c state with Ok ts -> ts | Error _ -> failwith "a fault" in
    let same (t : Transition.t) = Transition.equal_label t.label s.transition.label in
    let found =
      match (List.find_opt same successors, s.transition.label) with
      | (Some _ as t), _ -> t
      | None, Time d -> ( match Network.wait c state d with Ok t -> t | Error _ -> None)
      | None, _ -> None
    in
    match found with
    | Some transition -> (transition.target, { s with transition } :: steps)
    | None -> failwith "a cycle cannot be made again"
  in
  List.rev (snd (List.fold_left step (state, []) cycle))

let nothing_urgent c state =
  match Network.successors c state with
  | Ok ts -> not (List.exists (fun (t : Transition.t) -> Transition.is_urgent t.label) ts)
  | Error _ -> false

let times = List.map Rat.of_int [ 1; 3; 50 ]
let kinds = Hashtbl.create 7

let count kind =
  Hashtbl.replace kinds kind (1 + Option.value (Hashtbl.find_opt kinds kind) ~default:0)

(* The run, and how it goes on. *)
let positions c (w : Witness.t) =
  let start = { state = w.initial; arrived = nothing; clock = Rat.zero } in
  match w.finish with
  | At_state ->
    count "there";
    seen c start w.steps
  | During { offset; _ } ->
    count "soon after";
    let d = Option.get (Algebraic.to_rat offset) in
    let way = seen c start w.steps in
    way @ List.map (later c (last way)) (parts_of d @ [ d ])
  | Rests _ ->
    count "rests";
    let way = seen c start w.steps in
    if not (nothing_urgent c w.last && Time.delay c w.last = None) then failwith "it does not rest";
    way @ List.map (later c (last way)) times
  | Passes _ ->
    count "passes";
    if not (nothing_urgent c w.last) then failwith "time does not pass";
    let way = seen c start w.steps in
    let after = match Time.delay c w.last with None -> times | Some d -> parts_of d in
    way @ List.map (later c (last way)) after
  | Repeats { cycle; _ } ->
    count "repeats";
    let round = List.filteri (fun i _ -> i >= cycle) w.steps in
    let once = again c w.last round in
    let there = (List.nth once (List.length once - 1)).transition.target in
    seen c start (w.steps @ once @ again c there round)
  | Goes_on _ ->
    count "goes on";
    seen c start w.steps
  | Stops -> failwith "it stops"

(* {1 The law} *)

let in_time case position =
  match (bound case).high with None -> true | Some b -> Rat.compare position.clock b <= 0

(* Time passes up to the first event, which is the last step. *)
let is_next (w : Witness.t) =
  let is_time (s : Witness.step) = Transition.is_time s.transition.label in
  match (List.rev w.steps, w.finish) with
  | event :: before, At_state -> (not (is_time event)) && List.for_all is_time before
  | _ -> false

let establishes case claim c values (w : Witness.t) =
  let prop p = (c, Rename.known values p) in
  let all = positions c w in
  let never q list = List.for_all (fun x -> not (in_time case x && is (prop q) x)) list in
  let goes_to_goal = match w.finish with At_state | During _ -> true | _ -> false in
  let before = List.filteri (fun i _ -> i < List.length all - 1) all in
  match claim with
  | Never p -> never p all
  | Never_after (p, q) ->
    let rec after = function [] -> false | x :: rest -> (is (prop p) x && never q (x :: rest)) || after rest in
    after all
  | Comes (p, q) -> is (prop q) (last all) && in_time case (last all) && List.for_all (is (prop p)) before
  | Next p -> is_next w && Bool.equal case.some_run (is (prop p) (last all))
  | Not_until (p, q) ->
    if goes_to_goal then
      let right_after = match w.finish with During { open_piece; _ } -> open_piece | _ -> false in
      (not (is (prop p) (last all))) && (right_after || never q all)
    else never q all

let decided = ref 0
let without = ref 0
let next = ref 0

(* Of an operator over all runs that fails, and of one over some that holds. *)
let has_run case claim (v : Verdict.t) =
  let some =
    match claim with
    | Comes _ -> true
    | Never _ | Next _ -> case.some_run
    | Never_after _ | Not_until _ -> false
  in
  let witness w =
    (match claim with Next _ -> incr next | Never _ | Never_after _ | Not_until _ | Comes _ -> ());
    Some w
  in
  match v with
  | Holds { bounds = []; witness = w } when some -> witness w
  | Violated { witness = w } when not some -> witness w
  | Holds _ | Violated _ | Measured _ | Depends _ | Undecided _ -> None

let options = { Setup.default with bounds = { Bounds.default with states = Given 150; depth = Given 60 } }

let law_of case =
  let s = case.scene in
  let m = Scene.model s in
  let standard = Scc_engine.Standard.of_model m in
  let middle = Option.get (Polyhedron.interior_point (Ranges.box m.ranges)) in
  let declared = Scene.declared s middle in
  let check i claim =
    { Property.name = string_of_int i; span = Scc_base.Span.none; text = ""; asked = Whether; formula = formula
                                                                                                  case claim } in
  let checks = List.mapi check case.claims in
  match Zone_check.run options standard (Scene.uncertain s) ~declared ~exactly:false ~premises:[] checks with
  | Error _ -> true
  | Ok report ->
    let one claim (o : Verdict.outcome) =
      match has_run case claim o.verdict with
      | None -> ()
      | Some None ->
        incr decided;
        incr without
      | Some (Some w) ->
        incr decided;
        let fixed = Option.get w.fixed in
        let values = Array.of_list (List.map snd fixed.values) in
        if not (establishes case claim fixed.semantics values w) then
          QCheck2.Test.fail_reportf "formula %s: the run does not show it\n%s" o.check.name
            (String.concat "\n" (Witness.lines m w))
    in
    List.iter2 one case.claims report.outcomes;
    true

let law = QCheck2.Test.make ~name:"runs" ~count:250 ~print:(fun c -> Scene.print c.scene) generate law_of

let enough () =
  Hashtbl.iter (fun kind n -> Printf.printf "%s: %d\n" kind n) kinds;
  Printf.printf "%d decided, %d of them by the next event, %d without a run\n" !decided !next !without;
  let many kind n = Option.value (Hashtbl.find_opt kinds kind) ~default:0 >= n in
  Alcotest.(check bool) "many of each kind" true
    (many "rests" 20 && many "repeats" 5 && many "there" 20 && many "soon after" 3 && many "passes" 5);
  Alcotest.(check bool) "many by the next event" true (!next >= 20);
  Alcotest.(check int) "all have a run" 0 !without

let () =
  Alcotest.run "runs over zones"
    [ ("random", Scc_test_support.Property.cases [ law ] @ [ Alcotest.test_case "enough" `Quick enough ]) ]
