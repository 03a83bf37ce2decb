(* The models of specs/models: what they are expected to do, and what every network does. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_test_networks
open Scc_test_models

let standard = Scc_engine.Standard.of_model

let folder = "../../../specs/models"
let path name = Filename.concat folder name

let models_in folder =
  let names = Sys.readdir folder in
  Array.sort String.compare names;
  List.filter (fun name -> Filename.check_suffix name ".sc") (Array.to_list names)

let load ?overrides name = Load.exactly (Load.file ?overrides (path name))

let start ?overrides name =
  let { Scc_elaborate.Elaborate.model; declared; _ } = load ?overrides name in
  (model, Reach.initial model declared)

let states_per_model = 400

let reached ?overrides ?(limit = states_per_model) name =
  let m, initial = start ?overrides name in
  (m, Reach.states m initial ~limit)

let case name f = Alcotest.test_case name `Quick f

let holds_in_every_model ?limit fault_of () =
  List.iter
    (fun name ->
       let m, states = reached ?limit name in
       match fault_of m states with
       | None -> ()
       | Some why -> Alcotest.failf "%s: %s" name why)
    (models_in folder)

(* {1 Refused models} *)

let refused () =
  let folder = path "refused" in
  List.iter
    (fun name ->
       let file = Filename.concat folder name in
       let expected =
         match Expectation.refused (Load.read file) with
         | Some code -> code
         | None -> Alcotest.failf "%s does not say why it is refused" name
       in
       match Load.file file with
       | Ok _ -> Alcotest.failf "%s is accepted" name
       | Error diagnostics ->
         let codes = List.map (fun (d : Scc_base.Diag.t) -> d.code) diagnostics in
         Alcotest.(check (list string)) name [ expected ] (List.sort_uniq String.compare codes))
    (models_in folder)

(* {1 Particular models} *)

let labels m ts = List.map (fun (t : Transition.t) -> Transition.label_to_string m t.label) ts

let tuple () =
  let m, s = start "figure4.sc" in
  let leaf = m.leaves.(0) in
  let check_vec what expected v = Alcotest.(check string) what expected (Vec.to_string v) in
  Alcotest.(check string) "s" "s0" leaf.name;
  Alcotest.(check string) "m" "3" (Rat.to_string leaf.mass);
  check_vec "v" "(2, 1, 1)" s.processes.(0).velocity;
  check_vec "position" "(2, 3, 1)"
    (Vec.add s.processes.(0).leaves.(0).position (Model.leaf_centroid leaf));
  Alcotest.(check string) "volume" "8" (Rat.to_string leaf.parts.(0).solid.volume)

let compound () =
  let m, s = start "figure5.sc" in
  Alcotest.(check int) "one process" 1 (Array.length s.processes);
  Alcotest.(check (list string)) "parts" [ "S.s0"; "S.s1" ]
    (Array.to_list (Array.map (fun (p : Model.part) -> p.name) m.leaves.(0).parts));
  Alcotest.(check string) "mass" "6" (Rat.to_string m.leaves.(0).mass);
  Alcotest.(check string) "centre of mass" "(1/2, 0, 0)"
    (Vec.to_string (Vec.add s.processes.(0).leaves.(0).position (Model.leaf_centroid m.leaves.(0))))

(* Follows the only transition until there is a choice. *)
let rec to_choice m s =
  match Reach.successors m s with
  | [ t ] -> to_choice m t.target
  | ts -> ts

let figure7 name expected () =
  let m, s = start name in
  let ts = to_choice m s in
  Alcotest.(check (list string)) "the two bindings" expected (labels m ts);
  let bound (t : Transition.t) =
    Alcotest.(check int) "one process" 1 (Array.length t.target.processes);
    Alcotest.(check (list string)) "rules" [ "Bind"; "Pre"; "Def" ]
      (List.sort_uniq String.compare (List.map Rule.id t.rules)
       |> List.sort (fun a b ->
           let rank r = if r = "Bind" then 0 else if r = "Pre" then 1 else 2 in
           Int.compare (rank a) (rank b)))
  in
  List.iter bound ts;
  let is_bind (t : Transition.t) = match t.label with Bind _ -> true | _ -> false in
  let binds (_, ts) = List.filter is_bind ts in
  let _, states = reached name in
  Alcotest.(check int) "no more in the whole run" 2 (List.length (List.concat_map binds states))

let either_order () =
  let firsts overrides =
    let m, states = reached ~overrides "hexokinase.sc" in
    let bind (t : Transition.t) =
      match t.label with
      | Bind b -> Some b.name
      | Time _ | Close _ | Bounce _ | Absorb _ | Weak_split _ | Strong_split _ | Draw _ | Lot _ -> None
    in
    ignore m;
    List.find_map
      (fun (_, ts) -> match List.filter_map bind ts with [] -> None | names -> Some names)
      states
  in
  let check what expected overrides =
    Alcotest.(check (option (list string))) what expected (firsts overrides)
  in
  check "at once: either" (Some [ "atp"; "glc" ]) [];
  check "glucose is late" (Some [ "atp" ]) [ ("glucose_arrives", Rat.of_int 3) ];
  check "ATP is late" (Some [ "glc" ]) [ ("atp_arrives", Rat.of_int 3) ]

(* {1 Every model} *)

let well_formed m states =
  List.find_map
    (fun (s, _) ->
       match Well_formed.check (standard m) s with
       | [] -> None
       | fault :: _ -> Some (Well_formed.to_string m s fault))
    states

let conserved m states =
  List.find_map (fun (s, ts) -> List.find_map (Conservation.fault m s) ts) states

(* One body after the other is rounded, each as its first leaf is turned (rule Round). *)
let reversed m states =
  let n = Array.length m.Model.leaves in
  if Model.rounds m then None
  else Symmetry.broken (Symmetry.permutation (Array.init n (fun i -> n - 1 - i))) m states

(* Laws of motion may speak of places and directions. *)
let unless_laws symmetry (m : Model.t) states =
  let inertial (l : Model.leaf) = Law.is_inertial l.law in
  if Array.for_all inertial m.leaves then symmetry m states else None

let translated =
  unless_laws
    (Symmetry.broken
       (Symmetry.translation (Vec.make (Rat.of_int 11) (Rat.make Z.one (Z.of_int 3)) (Rat.of_int (-4)))))

(* Where splits are left to chance, lots are drawn in another order. *)
let turned =
  unless_laws (fun m states ->
      (* what turns takes its time *)
      let states = if Option.is_some m.rigid then List.filteri (fun i _ -> i mod 5 = 0) states else states in
      if m.lots then None else List.find_map (fun r -> Symmetry.broken r m states) Symmetry.rotations)

(* The states of a path, found again by the numbers of its choices. *)
let replayed m states =
  let rec follow s choices =
    match choices with
    | [] -> s
    | i :: rest -> follow (List.nth (Reach.successors m s) i).Transition.target rest
  in
  match states with
  | [] -> None
  | (initial, _) :: _ ->
    let rand = Random.State.make [| 42 |] in
    let rec walk s choices n =
      match Reach.successors m s with
      | [] -> (s, List.rev choices)
      | _ when n = 0 -> (s, List.rev choices)
      | ts ->
        let i = Random.State.int rand (List.length ts) in
        walk (List.nth ts i).target (i :: choices) (n - 1)
    in
    let last, choices = walk initial [] 25 in
    if State.equal last (follow initial choices) then None else Some "a path leads elsewhere when replayed"

(* {1 Expected verdicts} *)

let options =
  let open Scc_verify in
  { Setup.default with bounds = { Bounds.default with depth = Default 1_000; states = Default 50_000 } }

let verdict (v : Scc_verify.Verdict.t) =
  if Scc_verify.Verdict.exhaustive v then "holds"
  else
    match v with
    | Holds _ -> "bounded"
    | Violated _ -> "violated"
    | Measured { values; _ } -> Scc_explain.Likelihoods.values values
    | Depends _ | Undecided _ -> "undecided"

let pair = Alcotest.(list (pair string string))

let over_zones name =
  let { Scc_elaborate.Elaborate.model; declared; _ } = load name in
  Scc_zones.Zone_check.is_for model ~declared

let checked name =
  let { Scc_elaborate.Elaborate.model; declared; checks; uncertain; _ } = load name in
  let initial = Reach.initial model declared in
  let report =
    if not (Scc_zones.Zone_check.is_for model ~declared) then
      Scc_verify.Check.run options (standard model) ~initial checks
    else
      let uncertain = Option.value uncertain ~default:(Scc_symbolic.Start.known model declared) in
      let run = Scc_zones.Zone_check.run options (standard model) uncertain ~declared in
      match run ~exactly:false ~premises:[] checks with
      | Ok report -> report
      | Error _ -> Alcotest.failf "%s: not well-formed for some starts" name
  in
  (model, initial, report)

let expected name () =
  let _, _, report = checked name in
  let got =
    List.map (fun (o : Scc_verify.Verdict.outcome) -> (o.check.name, verdict o.verdict)) report.outcomes
  in
  let wanted =
    List.map
      (fun (name, v) -> (name, Expectation.verdict_to_string v))
      (Expectation.checks (Load.read (path name)))
  in
  Alcotest.check pair name wanted got

let verdict_of (report : Scc_verify.Check.report) name =
  let is_it (o : Scc_verify.Verdict.outcome) = String.equal o.check.name name in
  (List.find is_it report.outcomes).verdict

let steps_again () =
  let _, _, report = checked "raft.sc" in
  match verdict_of report "surely" with
  | Violated
      { witness =
          Some { steps = [ _ ]; finish = Repeats { cycle = 0; moved = Together by; puts_off = Some _ }; _ } } ->
    Alcotest.(check string) "each time farther" "(1, 0, 0)" (Vec.to_string by)
  | _ -> Alcotest.fail "not a step that is repeated for ever"

(* Why a nested formula fails, in words. *)
let reasons () =
  let m, _, report = checked "latch.sc" in
  match verdict_of report "parts" with
  | Violated { witness = Some w } ->
    Alcotest.(check (list string)) "its ending"
      [
        "and step 4 again, for ever"; "it puts off weak(dock, p.right, q.left) for ever: no fairness is assumed";
        "event weak(dock) fails"; "why:";
        "  AG (event bind(dock) => AF event weak(dock)) does not hold: bind(dock, p.right, q.left) after 2";
        "    in the state after time 2 from here"; "    event bind(dock) => AF event weak(dock) does not hold";
        "      event bind(dock) holds";
        "      AF event weak(dock) does not hold: nothing else happens after time 1 from here, for ever";
      ]
      (Scc_explain.Witness.ending m w)
  | _ -> Alcotest.fail "not violated by a run"

(* The first model of the guide, as it stands there. *)
let guide () =
  let fence = "```" in
  let rec block found lines =
    match (found, lines) with
    | None, line :: rest -> block (if String.equal line fence then Some [] else None) rest
    | Some kept, line :: rest ->
      if String.equal line fence then String.concat "\n" (List.rev kept) else block (Some (line :: kept)) rest
    | _, [] -> Alcotest.fail "no model in the guide"
  in
  let text = block None (String.split_on_char '\n' (Load.read "../../../specs/guide.md")) in
  let { Scc_elaborate.Elaborate.model; declared; checks; _ } = Load.exactly (Load.text text) in
  let report = Scc_verify.Check.run options (standard model) ~initial:(Reach.initial model declared) checks in
  let verdicts = List.map (fun (o : Scc_verify.Verdict.outcome) -> verdict o.verdict) report.outcomes in
  Alcotest.(check (list string)) "its verdicts" [ "holds" ] verdicts

(* A witness, followed by its choices alone, ends where it says. *)
let witnesses () =
  let follow m initial (w : Scc_explain.Witness.t) =
    let step s i =
      match List.nth_opt (Reach.successors m s) i with
      | Some t -> t.Transition.target
      | None -> Alcotest.fail "a choice that is not there"
    in
    List.fold_left step initial (Scc_explain.Witness.choices w)
  in
  let check m initial name (w : Scc_explain.Witness.t) =
    if not (State.equal (follow m initial w) w.last) then Alcotest.failf "%s: the witness leads elsewhere" name
  in
  let of_model name =
    let m, initial, report = checked name in
    List.filter_map
      (fun (o : Scc_verify.Verdict.outcome) ->
         match o.verdict with
         | Scc_verify.Verdict.Holds { witness; _ } | Violated { witness } | Measured { witness; _ } -> witness
         | Depends _ | Undecided _ -> None)
      report.outcomes
    |> fun ws -> List.iter (check m initial name) ws; List.length ws
  in
  let of_one_start = List.filter (fun name -> not (over_zones name)) (models_in folder) in
  let found = List.fold_left (fun n name -> n + of_model name) 0 of_one_start in
  Alcotest.(check bool) "there are witnesses" true (found > 20)

let () =
  Alcotest.run "models"
    [
      ( "particular",
        [
          case "refused models" refused;
          case "Def-4.4: the tuple of section 4.1" tuple;
          case "Def-4.5: the compound of Figure 5" compound;
          case "Bind: Figure 7 has exactly two"
            (figure7 "figure7.sc" [ "bind(a, P0.s0.[v2,v3], s2.f4)"; "bind(a, P0.s1.[v2,v3], s2.f4)" ]);
          case "Bind: so it has with the plank on the axis"
            (figure7 "figure7-offset.sc"
               [ "bind(a, P0.s0.[v2,v3], s2.f3)"; "bind(a, P0.s1.[v2,v3], s2.f3)" ]);
          case "hexokinase binds in either order" either_order;
        ] );
      ("expected verdicts", List.map (fun name -> case name (expected name)) (models_in folder));
      ( "where laws fail",
        List.map (fun name -> case name (expected ("laws/" ^ name))) (models_in (path "laws")) );
      ("the guide", [ case "its first model" guide ]);
      ( "witnesses",
        [
          case "lead where they say" witnesses;
          case "a raft drifts on for ever" steps_again;
          case "reasons in words" reasons;
        ] );
      ( "every model",
        [
          case "WellFormed: every explored state" (holds_in_every_model well_formed);
          case "transitions: momentum and energy" (holds_in_every_model conserved);
          case "I-5: parallel components in any order" (holds_in_every_model reversed);
          case "invariance under translation" (holds_in_every_model translated);
          case "invariance under the rotations of a cube" (holds_in_every_model ~limit:40 turned);
          case "paths can be replayed" (holds_in_every_model replayed);
        ] );
    ]
