(* Slices against whole networks: the same verdicts, and runs that can be lifted. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_verify
open Scc_test_networks
open Scc_test_models
module Gen = QCheck2.Gen

let rational n d = Rat.make (Z.of_int n) (Z.of_int d)

(* {1 Networks of several clusters} *)

(* Two cubes that are born bound, above the first cluster. *)
type dimer = { x : int; speed : int  (** in halves *); behaviours : int * int }

type clusters = { networks : Random_network.t list; apart : int; dimers : dimer list; pulses : bool }

(* A cube of mass 1 that can move. *)
let cube_leaf network =
  let leaves = (Random_network.model (Random_network.with_bystanders network)).leaves in
  let leaf = leaves.(Array.length leaves - 1) in
  if leaf.fixed || Array.length leaf.parts > 1 then failwith "another leaf is wanted";
  leaf

let process_of_dimer ~first k d =
  (* left is the face number 2 of the cube, and right number 3 *)
  let face k : Site.t = { part = 0; feature = Scc_geometry.Feature.Face k } in
  let leaf i behaviour : State.leaf =
    let behaviour = Behaviour.fresh (Behaviour.call behaviour) in
    { leaf = first + i; position = Vec.of_ints (d.x + (2 * i)) (14 + (6 * k)) 0; behaviour }
  in
  let bond = State.bond "a" { at = first; site = face 3 } { at = first + 1; site = face 2 } in
  State.process
    ~leaves:[ leaf 0 (fst d.behaviours); leaf 1 (snd d.behaviours) ]
    ~bonds:[ bond ]
    ~velocity:(Vec.make Rat.zero (rational d.speed 2) Rat.zero)
    ~clock:None

(* Puts networks side by side, [apart] from each other along x, with one numbering of leaves. *)
let assemble c =
  let place (k, leaves, processes) network =
    let before = List.length leaves in
    let m = Random_network.model network in
    let named (l : Model.leaf) = { l with name = Printf.sprintf "c%d.%s" k l.name } in
    let shift = Vec.of_ints (k * c.apart) 0 0 in
    let moved (p : State.process) =
      let move (l : State.leaf) =
        let pulses = c.pulses && k > 0 && l.leaf mod 2 = 0 in
        let behaviour = if pulses then Behaviour.fresh (Behaviour.call 9) else l.behaviour in
        { State.leaf = before + l.leaf; position = Vec.add shift l.position; behaviour }
      in
      State.process
        ~leaves:(List.map move (Array.to_list p.leaves))
        ~bonds:[] ~velocity:p.velocity ~clock:None
    in
    let declared = Array.to_list (Random_network.declared network).processes in
    (k + 1, leaves @ List.map named (Array.to_list m.leaves), processes @ List.map moved declared)
  in
  let first = List.hd c.networks in
  let _, leaves, processes = List.fold_left place (0, [], []) c.networks in
  let before = List.length leaves in
  let cubes k _ =
    List.map (fun i -> { (cube_leaf first) with name = Printf.sprintf "d%d.%d" k i }) [ 0; 1 ]
  in
  let dimer k d = process_of_dimer ~first:(before + (2 * k)) k d in
  let leaves = leaves @ List.concat (List.mapi cubes c.dimers) in
  let processes = processes @ List.mapi dimer c.dimers in
  let m = { (Random_network.model first) with leaves = Array.of_list leaves; keeps_time = true } in
  (m, Reach.initial m (State.make ~processes ~step:None ~time:None))

let dimer =
  let open Gen in
  let+ x = 0 -- 10 and+ speed = -4 -- 4 and+ behaviours = oneofl [ (1, 3); (6, 8); (12, 1); (6, 6) ] in
  { x; speed; behaviours }

let clusters =
  let open Gen in
  let* networks = list_size (1 -- 3) (Random_network.generate ()) in
  let* apart = oneofl [ 14; 16; 20; 40 ] and* bystanders = map (fun n -> n = 0) (0 -- 4) in
  let* dimers = list_size (0 -- 2) dimer and* pulses = bool in
  let add networks =
    match List.rev networks with
    | last :: (_ :: _ as rest) when bystanders -> List.rev (Random_network.with_bystanders last :: rest)
    | _ -> networks
  in
  pure { networks = add networks; apart; dimers; pulses }

(* {1 Searches over the leaves of the first cluster} *)

let atom leaves : Property.prop Gen.t =
  let open Gen in
  let leaf = 0 -- (leaves - 1) and number = map (fun n -> Property.Const (rational n 2)) (-8 -- 20) in
  let comparison = oneofl Law.[ Lt; Le; Gt; Ge; Eq; Ne ] in
  let compare n =
    let* n = n and* c = comparison and* k = number in
    pure (Property.Compare (c, n, k))
  in
  let axis = oneofl Property.[ X; Y; Z ] and pair = pair leaf leaf in
  let two make = map (fun (i, j) -> if i = j then Property.Bool true else make i j) pair in
  oneof
    [
      compare (map2 (fun a i -> Property.Position (a, i)) axis leaf);
      compare (map2 (fun a i -> Property.Velocity (a, i)) axis leaf);
      compare (map (fun i -> Property.Size i) leaf);
      compare (map (fun (i, j) -> Property.Distance2 (i, j)) pair);
      compare (map (fun (i, j) -> Property.Bonds (None, Some (i, j))) pair);
      compare (pure Property.Time);
      two (fun i j -> Property.Touching (i, j));
      two (fun i j -> Property.Bound (i, j));
      two (fun i j -> Property.Same (i, j));
      map2 (fun i k -> Property.Behaviour (i, k)) leaf (0 -- 4);
      map (fun i -> Property.Offers (i, None, "a")) leaf;
      map (fun i -> Property.Event (Bounce (One i))) leaf;
      map (fun i -> Property.Event (Bond (Made, None, One i))) leaf;
      map (fun i -> Property.Event (Bond (Released, None, One i))) leaf;
    ]

let predicate leaves =
  let open Gen in
  let atoms = list_size (1 -- 3) (atom leaves) in
  let* list = atoms and* all = bool and* negated = map (fun n -> n = 0) (0 -- 3) in
  let p : Property.prop = if all then And list else Or list in
  let p = if negated then Property.Not p else p in
  (* Else much is decided at the start. *)
  let+ later = 0 -- 6 in
  if later > 3 then p else Property.And [ Compare (Gt, Time, Const (rational later 3)); p ]

let search leaves : Property.temporal Gen.t =
  let open Gen in
  let* p = predicate leaves and* halves = 0 -- 6 and* bounded = map (fun n -> n > 0) (0 -- 3) in
  let bound = { Property.low = Rat.zero; high = (if bounded then Some (rational halves 2) else None) } in
  oneofl Property.[ Finally (Exists, bound, State p); Globally (All, bound, State p) ]

let formula leaves : Property.temporal Gen.t =
  let open Gen in
  let* f = search leaves and* g = search leaves in
  frequencyl [ (6, f); (1, Property.Temporal_and [ f; g ]); (1, Temporal_not (Temporal_or [ f; g ])) ]

type question = { clusters : clusters; formula : Property.temporal }

let question =
  let open Gen in
  let* clusters = clusters in
  let first = List.hd clusters.networks in
  let+ formula = formula (Array.length (Random_network.model first).leaves) in
  { clusters; formula }

let print q =
  let m, _ = assemble q.clusters in
  let dimer d = Printf.sprintf " (x %d, speed %d/2, %d and %d)" d.x d.speed (fst d.behaviours) (snd d.behaviours) in
  Printf.sprintf "%s\napart %d%s, dimers%s\n%s"
    (Show.temporal m q.formula)
    q.clusters.apart
    (if q.clusters.pulses then ", pulses" else "")
    (String.concat "" (List.map dimer q.clusters.dimers))
    (String.concat "\n--\n" (List.map Random_network.print q.clusters.networks))

(* {1 The same verdicts, and runs of the whole} *)

let generous n = { Check.default with bounds = { Bounds.default with states = Given n } }

let check options m initial formula =
  let check = { Property.name = "c"; span = Scc_base.Span.none; text = ""; formula } in
  match (Check.run options m ~initial [ check ]).outcomes with
  | [ (_, v) ] -> v
  | _ -> failwith "one outcome"

let decided : Verdict.t -> bool option = function
  | Holds { bounds = []; _ } -> Some true
  | Violated _ -> Some false
  | Holds _ | Undecided _ -> None

let witness : Verdict.t -> Witness.t option = function
  | Holds { witness; _ } | Violated { witness } -> witness
  | Undecided _ -> None

let facts m formula (w : Witness.t) =
  let arrived =
    match List.rev w.steps with
    | [] -> fun _ -> false
    | last :: before ->
      let source = match before with [] -> w.initial | s :: _ -> s.transition.target in
      Event.matches m ~source last.transition.label
  in
  let extent, offset =
    match w.finish with
    | During { offset; _ } -> (Timeline.Forever, offset)
    | _ -> (Timeline.Instant, Algebraic.zero)
  in
  List.concat_map (Explain.facts ~arrived m w.last extent offset) (Formula.predicates formula)

(* Why the lifted run is not one of the whole that ends as the run of the slice does. *)
let fault m initial formula (w : Witness.t) (lifted : Witness.t) =
  let targets = List.map (fun (s : Witness.step) -> s.transition.target) lifted.steps in
  let in_time time (s : Witness.step) =
    Option.bind time (fun t ->
        let t = Rat.add t (Transition.duration s.transition) in
        if Rat.equal t s.time then Some t else None)
  in
  match Network.follow m initial (Witness.choices lifted) with
  | Error _ -> Some "it does not replay"
  | Ok transitions ->
    if not (List.for_all2 (fun (t : Transition.t) s -> State.equal t.target s) transitions targets) then
      Some "it leads elsewhere"
    else if
      not
        (List.for_all2
           (fun (t : Transition.t) (s : Witness.step) ->
              Transition.equal_label t.label s.transition.label && t.rules = s.transition.rules)
           transitions lifted.steps)
    then Some "it has other labels"
    else if List.fold_left in_time (Some Rat.zero) lifted.steps = None then Some "wrong times"
    else if not (Algebraic.equal (Witness.instant w) (Witness.instant lifted)) then Some "another instant"
    else if
      not (State.equal lifted.last (match List.rev targets with [] -> initial | last :: _ -> last))
    then Some "another last state"
    else
      let ends = facts m formula w and lifted_ends = facts m formula lifted in
      if List.equal String.equal ends lifted_ends && w.facts = lifted.facts then None
      else Some ("other facts: " ^ String.concat "; " (ends @ ("and" :: lifted_ends)))

let lasts_beyond (w : Witness.t) m =
  match (w.finish, Network.successors m w.last) with
  | During { choice = Some k; offset; from; _ }, Ok transitions -> (
      match (List.nth transitions k).label with
      | Time d -> Algebraic.compare_rat offset d < 0 && Algebraic.compare_rat from Rat.zero >= 0
      | _ -> false)
  | During { choice = None; _ }, Ok transitions -> transitions = []
  | _ -> true

(* How many slices were made, decided on both sides, and lifted: a property that compares nothing would be worth
   nothing. *)
type tally = { mutable made : int; mutable compared : int; mutable lifted : int; mutable longer : int }

let agrees tally q =
  let m, initial = assemble q.clusters in
  match Slice.make m ~initial [ q.formula ] with
  | None -> true
  | Some slice -> (
      tally.made <- tally.made + 1;
      let of_slice = check (generous 1500) m slice q.formula in
      (match witness of_slice with
       | None -> ()
       | Some w -> (
           let lifted = Lift.timed m ~initial w in
           tally.lifted <- tally.lifted + 1;
           if List.compare_lengths lifted.steps w.steps > 0 then tally.longer <- tally.longer + 1;
           if not (lasts_beyond lifted m) then QCheck2.Test.fail_report "the instant is not in its transition";
           match fault m initial q.formula w lifted with
           | None -> ()
           | Some why -> QCheck2.Test.fail_report why));
      match (decided of_slice, decided (check (generous 1500) m initial q.formula)) with
      | Some a, Some b ->
        tally.compared <- tally.compared + 1;
        if a = b then true
        else QCheck2.Test.fail_report (Printf.sprintf "slice: %b, whole: %b" a b)
      | _, _ -> true)

let tally = { made = 0; compared = 0; lifted = 0; longer = 0 }

let random = QCheck2.Test.make ~name:"clusters" ~count:1500 ~print question (agrees tally)

let counts () =
  Printf.printf "%d slices, %d verdicts compared, %d runs lifted, %d of them longer\n" tally.made tally.compared
    tally.lifted tally.longer;
  let some what expected n =
    if n < expected then Alcotest.failf "only %d %s" n what
  in
  some "slices" 300 tally.made;
  some "verdicts compared" 200 tally.compared;
  some "runs lifted" 100 tally.lifted;
  some "runs that got longer" 20 tally.longer

(* {1 By hand} *)

let cube =
  {|
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
|}

let load text =
  let e = Load.exactly (Load.text (cube ^ text)) in
  match Network.initial e.model e.declared with
  | Error _ -> Alcotest.fail "no initial state"
  | Ok initial -> (e.model, initial, List.map (fun (c : Property.check) -> c.formula) e.checks)

let all_kept = [ "(no slice)" ]

let left_out text =
  let m, initial, formulas = load text in
  match Slice.make m ~initial formulas with
  | None -> all_kept
  | Some slice -> Slice.left_out m ~initial slice

let is what expected text = Alcotest.(check (list string)) what expected (left_out text)

let dimers n =
  Printf.sprintf
    {|
behaviour Left  on Cube = omega(bond, {right}). nil
behaviour Right on Cube = omega(bond, {left}). nil
for i in 1..%d {
  process d[i] = p[i] : Cube mass 1 at translate (0, 4*i, 0) [Left] <bond, {p[i].right, q[i].left}>
                 q[i] : Cube mass 1 at translate (2, 4*i, 0) [Right]
}
|}
    n

let one_of_many () =
  is "three dimers" [ "p[1]"; "q[1]"; "p[3]"; "q[3]" ] (dimers 3 ^ "check a : possibly not bound(p[2], q[2])");
  is "two formulas" [ "p[1]"; "q[1]" ]
    (dimers 3 ^ "check a : possibly not bound(p[2], q[2])\ncheck b : always size(p[3]) = 2 within 3");
  is "all of them" all_kept (dimers 1 ^ "check a : possibly not bound(p[1], q[1])");
  let m, initial, formulas = load (dimers 2000 ^ "check a : always bound(p[7], q[7])") in
  match Slice.make m ~initial formulas with
  | None -> Alcotest.fail "no slice"
  | Some slice -> (
      Alcotest.(check int) "one is left" 1 (Array.length slice.processes);
      match witness (check Check.default m slice (List.hd formulas)) with
      | None -> Alcotest.fail "no witness"
      | Some w ->
        let lifted = Lift.timed m ~initial w in
        Alcotest.(check (option string)) "lifted" None (fault m initial (List.hd formulas) w lifted))

let fragment () =
  let outside what check = is what all_kept (dimers 3 ^ "check a : " ^ check) in
  outside "AF" "eventually not bound(p[2], q[2])";
  outside "EG" "EG bound(p[2], q[2])";
  outside "X" "EX bound(p[2], q[2])";
  outside "U" "E[ bound(p[2], q[2]) U not bound(p[2], q[2]) ]";
  outside "nested" "always possibly not bound(p[2], q[2])";
  outside "from later on" "EF[1,2] not bound(p[2], q[2])";
  outside "global" "possibly bonds(bond) = 0 and bound(p[2], q[2])";
  outside "any event" "possibly event weak(bond) and bound(p[2], q[2])";
  outside "quiescent" "possibly quiescent and bound(p[2], q[2])";
  outside "no leaf" "possibly time = 2";
  outside "an event that must not be" "possibly not event weak(bond, p[2]) and not bound(p[2], q[2])";
  outside "nor always be" "always event weak(bond, p[2]) or bound(p[2], q[2])";
  outside "nor be counted" "possibly (if event weak(bond, p[2]) then 1 else 0) = size(p[2])";
  let inside what check = is what [ "p[1]"; "q[1]"; "p[3]"; "q[3]" ] (dimers 3 ^ "check a : " ^ check) in
  inside "an event" "possibly event weak(bond, p[2])";
  inside "never an event" "always not event weak(bond, p[2])";
  inside "time" "possibly time = 2 and not bound(p[2], q[2])";
  inside "connected" "(possibly not bound(p[2], q[2])) and not (possibly x(p[2]) > 4 within 3)";
  inside "now" "bound(p[2], q[2]) and possibly not bound(p[2], q[2])"

let still = "process s = Cube mass 1 [nil]\n"

let in_motion () =
  let bullet = still ^ "process b = Cube mass 1 velocity (1,0,0) at translate (-7,0,0) [nil]\n" in
  is "it hits at 5, too late" [ "b" ] (bullet ^ "check a : always x(s) = 0 within 49/10");
  is "just in time" all_kept (bullet ^ "check a : always x(s) = 0 within 5");
  is "some time" all_kept (bullet ^ "check a : always x(s) = 0");
  is "away" [ "b" ]
    (still
     ^ "process b = Cube mass 1 velocity (-1,0,0) at translate (-7,0,0) [nil]\ncheck a : always x(s) = 0");
  is "past" [ "b" ]
    (still
     ^ "process b = Cube mass 1 velocity (1,0,0) at translate (-7,2,0) [nil]\ncheck a : always x(s) = 0");
  is "touching at rest" [ "b" ]
    (still ^ "process b = Cube mass 1 at translate (2,0,0) [nil]\ncheck a : always x(s) = 0");
  is "equal velocities" [ "b" ]
    ("process s = Cube mass 1 velocity (2,1,0) [nil]\n"
     ^ "process b = Cube mass 1 velocity (2,1,0) at translate (2,0,0) [nil]\ncheck a : always vx(s) = 2")

let through_others () =
  (* b hits the first of two at 1; which then may hit s, 2 further, at 3 *)
  let three =
    still
    ^ {|
process c = Cube mass 1 at translate (-4,0,0) [nil]
process b = Cube mass 1 velocity (1,0,0) at translate (-7,0,0) [nil]
|}
  in
  is "it gets there" all_kept (three ^ "check a : always x(s) = 0 within 3");
  is "but not in a short time" [ "c"; "b" ] (three ^ "check a : always x(s) = 0 within 3/2");
  let turned =
    still
    ^ {|
process c = Cube mass 1 at translate (-6,-6,0) [nil]
process b = Cube mass 9 velocity (1,1,0) at translate (-10,-9,0) [nil]
|}
  in
  is "not by its line" [ "c"; "b" ] (turned ^ "check a : always x(s) = 0 within 1");
  is "but perhaps after a collision" all_kept (turned ^ "check a : always x(s) = 0 within 9/2");
  (* binding to a heavy one gives a light one no more than the energy allows *)
  let sideways =
    still
    ^ {|
process c = Cube mass 1 at translate (-6,-6,0) [nil]
process b = Cube mass 9 velocity (1,0,0) at translate (-9,-6,0) [nil]
|}
  in
  is "a light one may be three times as fast" all_kept (sideways ^ "check a : always x(s) = 0 within 7/5");
  is "no faster" [ "c"; "b" ] (sideways ^ "check a : always x(s) = 0 within 13/10")

let walls () =
  let scene =
    {|
fixed floor = Cube scaled (100,1,100) at translate (0,-1,0)
process s = Cube mass 1 velocity (0,-1,0) at translate (0,2,0) [nil]
process t = Cube mass 1 velocity (0,-1,0) at translate (30,2,0) [nil]
process u = Cube mass 1 at translate (60,1,0) [nil]
|}
  in
  is "joins nothing together, but is kept" [ "t"; "u" ] (scene ^ "check a : possibly y(s) > 4 within 10");
  is "one at rest on it does not need it" [ "floor"; "s"; "t" ] (scene ^ "check a : possibly y(u) > 4 within 10");
  is "it is asked for" [ "s"; "t" ] (scene ^ "check a : always touching(u, floor) within 10");
  is "all that may bounce off it" [ "u" ] (scene ^ "check a : always not event bounce(floor) within 10");
  is "a sticky one" [ "u" ]
    ({|
behaviour Stick on Cube = <grip, {top}>. nil
fixed floor = Cube scaled (100,1,100) at translate (0,-1,0) [eps(3). Stick]
process s = Cube mass 1 velocity (0,-1,0) at translate (0,2,0) [nil]
process t = Cube mass 1 velocity (0,-1,0) at translate (30,2,0) [nil]
process u = Cube mass 1 at translate (60,1,0) [nil]
|}
     ^ "check a : possibly y(s) > 4 within 10")

let steered () =
  is "a steered body" all_kept
    (dimers 2
     ^ {|
process k = Cube mass 1 at translate (100,0,0) [nil]
motion k = (vx, vy - dt, vz)
check a : possibly not bound(p[1], q[1])
|})

(* Left out are those that may collide only when they let time pass. *)
let urgent_for_ever () =
  let scene =
    {|
behaviour Grip on Cube = <grip, {right}>. rho({<grip, {right}>}). Grip
behaviour Hold on Cube = <~grip, {left}>. rho({<grip, {left}>}). Hold
process s = Cube mass 1 at translate (0,50,0) [nil]
fixed w = Cube at translate (2,0,0) [Hold]
process a = Cube mass 1 velocity (1,0,0) at translate (-2,0,0) [Grip]
|}
  in
  is "they bind and split once" [ "w"; "a" ] (scene ^ "check a : always y(s) = 50 within 5");
  let between speed =
    Printf.sprintf
      {|
process s = Cube mass 1 at translate (0,1000000,0) [nil]
fixed w[1] = Cube at translate (3,0,0)
fixed w[2] = Cube at translate (-3,0,0)
process a = Cube mass 1 velocity (%d,0,0) [nil]
check a : always x(s) = 0 within 10
|}
      speed
  in
  is "they bounce to and fro" [ "w[1]"; "w[2]"; "a" ] (between 1);
  is "too often" all_kept (between 3000)

let () =
  Alcotest.run "slice"
    [
      ("random networks", [ Scc_test_support.Property.case random; Alcotest.test_case "counts" `Quick counts ]);
      ( "by hand",
        [
          Alcotest.test_case "one of many" `Quick one_of_many;
          Alcotest.test_case "fragment" `Quick fragment;
          Alcotest.test_case "in motion" `Quick in_motion;
          Alcotest.test_case "through others" `Quick through_others;
          Alcotest.test_case "walls" `Quick walls;
          Alcotest.test_case "steered" `Quick steered;
          Alcotest.test_case "urgent for ever" `Quick urgent_for_ever;
        ] );
    ]
