(* The stretches of a passing of time against the state itself at instants in them. *)

open Scc_ctl
open Scc_exact
open Scc_evaluate
open Scc_verify
open Scc_graphs
open Scc_test_models

let standard = Scc_engine.Standard.of_model

let models =
  [ "billiard"; "dimer"; "drift"; "figure1"; "figure4"; "figure7"; "gravity"; "graze"; "tiles"; "vertex" ]

let space_of name =
  let e = Load.exactly (Load.file (Printf.sprintf "../../../specs/models/%s.sc" name)) in
  match Scc_semantics.Network.initial (standard e.model) e.declared with
  | Error _ -> Alcotest.fail "no initial state"
  | Ok initial ->
    let options = 
      let bounds = { Bounds.default with time = Given (Rat.of_int 3); states = Given 200 } in
      { Setup.default with bounds }
    in
    (e, Explored.explore options (standard e.model) ~initial)

let passing (space : Explored.t) i =
  Array.fold_left
    (fun found (e : Explored.edge) ->
       match e.label with Time d -> Some (d, e.target) | _ -> found)
    None (space.edges i)

let half a b = Rat.div (Rat.add a b) (Rat.of_int 2)

(* The predicates in the state that has aged by [offset], each by itself. *)
let agrees what (space : Explored.t) l i ~number offset =
  let state = space.state i in
  let state =
    if Rat.sign offset = 0 then state else Scc_semantics.Time.pass space.semantics offset state
  in
  Array.iteri
    (fun k (p : State_predicates.t) ->
       match Trajectory.holds space.semantics state p.prop with
       | Undecided _ -> ()
       | truth ->
         Alcotest.(check bool)
           (Printf.sprintf "%s, state %d and %s later: %s" what i (Rat.to_string offset) p.text)
           (Truth.equal truth True) (Labelling.holds l number k))
    (Labelling.predicates l)

let values l number =
  List.init (Array.length (Labelling.predicates l)) (fun k -> Labelling.holds l number k)

(* One chain; the count of its stretches. *)
let chain what (space : Explored.t) l i =
  match Labelling.detour l i with
  | None -> 0
  | Some (first, number) ->
    let total = passing space i in
    let rec along before at number n =
      Alcotest.(check bool) (what ^ ": a stretch differs from what was before it") false
        (List.equal Bool.equal (values l before) (values l number));
      match Labelling.stretch l number with
      | None -> Alcotest.fail "a stretch leads to nothing"
      | Some s ->
        Alcotest.(check int) (what ^ ": source") i s.source;
        let stop = match s.lasts with Some d -> Rat.add at d | None -> Rat.add at (Rat.of_int 7) in
        if s.attained then agrees what space l i ~number at;
        if Rat.compare at stop < 0 then begin
          agrees what space l i ~number (half at stop);
          agrees what space l i ~number (half at (half at (half at stop)))
        end
        else Alcotest.(check bool) (what ^ ": an instant is attained") true s.attained;
        if not s.attained then
          Alcotest.(check bool) (what ^ ": what is not attained lasts") true (Rat.compare at stop < 0);
        (match (s.lasts, total) with
         | None, None -> Alcotest.(check int) (what ^ ": it stays") number s.target
         | None, Some _ -> Alcotest.fail "a passing of time never ends"
         | Some _, _ when s.target >= space.size ->
           Alcotest.(check int) (what ^ ": the next stretch") (number + 1) s.target
         | Some _, Some (d, target) ->
           Alcotest.(check string) (what ^ ": time in all") (Rat.to_string d) (Rat.to_string stop);
           Alcotest.(check int) (what ^ ": target") target s.target
         | Some _, None -> Alcotest.fail "a rest ends");
        if s.target >= space.size && s.target <> number then along number stop s.target (n + 1) else n + 1
    in
    along i first number 0

let model name () =
  let (e : Scc_elaborate.Elaborate.t), space = space_of name in
  let predicates = Array.of_list (State_predicates.of_checks e.model e.checks) in
  let l = Labelling.make ~instants:true space predicates in
  let plain = Labelling.make space predicates in
  let stretches = ref 0 in
  for i = 0 to space.size - 1 do
    agrees name space l i ~number:i Rat.zero;
    agrees name space plain i ~number:i Rat.zero;
    stretches := !stretches + chain name space l i
  done;
  Alcotest.(check int) "all stretches are on the way of somebody" (Labelling.size l - space.size) !stretches;
  Alcotest.(check int) "none are made unasked" space.size (Labelling.size plain);
  (* What changes somewhere is seen to change. *)
  let changing l = List.init (Array.length predicates) (fun k -> Labelling.changes l k) in
  Alcotest.(check (list int)) "changes" (changing l) (changing plain);
  Alcotest.(check bool) "stretches come of changes" (!stretches > 0)
    (List.exists (fun n -> n > 0) (changing l))

let () =
  let case name = Alcotest.test_case name `Quick (model name) in
  Alcotest.run "instants" [ ("models", List.map case models) ]
