(* What an invariant proves is so: of all models of specs/models that sets of states can follow, against the
   ordinary exploration. And the check of certificates sees what is wrong with others: those that lack a kind of
   states, and claims of what does come. *)

open Scc_polyhedra
open Scc_calculus
open Scc_semantics
open Scc_state_sets
open Scc_symbolic
open Scc_certificate
open Scc_verify
open Scc_zones
module Loaded = Scc_loading.Loaded
module Limits = Scc_graph_search.Limits

let models = if Sys.file_exists "specs/models" then "specs/models" else "../../../specs/models"

let read path =
  let channel = open_in_bin path in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel;
  text

let load file =
  let read_file name = try Ok (read (Filename.concat models name)) with Sys_error e -> Error e in
  Loaded.load ~read_file ~overrides:[] (Scc_base.Source.make ~name:file (read (Filename.concat models file)))

(* {1 Proofs} *)

let covers all u = Union.is_empty (Union.difference all u)
let compared = ref 0

(* The ordinary exploration of one start: in the middle of the ranges, if there are any. *)
let ordinary (l : Loaded.t) =
  let bounds = { Bounds.default with states = Given 2_000 } in
  let values = Ranges.point l.model.ranges in
  let semantics, declared =
    match l.uncertain with
    | None -> (l.semantics, l.declared)
    | Some u ->
      (Semantics.with_model l.semantics (Fixed.model l.model values), Fixed.declared l.model u l.declared values)
  in
  match Network.initial semantics declared with
  | Error _ -> Alcotest.fail "no initial state"
  | Ok initial ->
    (Check.run { Setup.default with bounds } semantics ~initial l.checks).outcomes

let compare_one all values (o : Verdict.outcome) (proof : Proof.t) =
  let name = o.check.name in
  let holds = Union.mem proof.sets.holds values and fails = Union.mem proof.sets.fails values in
  let wrong what = Alcotest.failf "%s is proved to %s, and is not" name what in
  if covers all proof.sets.holds || covers all proof.sets.fails then incr compared;
  match o.verdict with
  | Holds { bounds = []; _ } -> if fails then wrong "fail"
  | Violated _ -> if holds then wrong "hold"
  | Holds _ | Measured _ | Depends _ | Undecided _ -> ()

(* {1 What is no proof} *)

let rejected = ref 0

let without (invariant : Invariant.t) i =
  { invariant with locations = List.filteri (fun j _ -> i <> j) invariant.locations }

let certificate (l : Loaded.t) u invariant claims =
  Certificate.check l.semantics u ~declared:l.declared invariant claims ~stop:(fun () -> false)

let is_rejected l u invariant claims what =
  match certificate l u invariant claims with
  | Error _ -> incr rejected
  | Ok () -> Alcotest.failf "%s is accepted" what

(* Of one kind but a single state, in the middle of those that there are. If these are really reached, and not
   there by widening alone, it is no invariant. *)
let thinned = ref 0
let still_accepted = ref 0

let thin l u (invariant : Invariant.t) i (location : Invariant.location) =
  match Polyhedron.interior_point location.set with
  | Some point when Polyhedron.affine_dimension location.set > 0 ->
    incr thinned;
    let change j other = if i = j then { location with set = Polyhedron.of_point point } else other in
    let locations = List.mapi change invariant.locations in
    if Result.is_ok (certificate l u { invariant with locations } []) then incr still_accepted
  | Some _ | None -> ()

let rejects l u (invariant : Invariant.t) =
  List.iteri (thin l u invariant) invariant.locations;
  let each i _ =
    is_rejected l u (without invariant i) [] (Printf.sprintf "an invariant without kind %d" (i + 1))
  in
  List.iteri each invariant.locations;
  let all = Union.of_polyhedron (Ranges.box l.model.ranges) in
  let truth = { Scc_certificate.Invariant.never = Bool true; values = all } in
  is_rejected l u invariant [ truth ] "that nothing is ever so"

let few = 12

(* Each certificate is checked for seconds, as there are dozens of parts to meet. *)
let many_parts = [ "drawn_hexokinase.sc" ]

let proves file () =
  match load file with
  | Error _ -> ()
  | Ok l when Zone_check.refused l.model Invariants <> [] -> ()
  | Ok l -> (
      let u = match l.uncertain with Some u -> u | None -> Start.known l.model l.declared in
      let all = Union.of_polyhedron (Ranges.box l.model.ranges) in
      match By_invariant.attempt Setup.default Unasked l.semantics u ~declared:l.declared l.checks with
      | Error _ -> Alcotest.fail "the declared state is not well-formed"
      | Ok (None_found reason | Given_up reason) -> print_endline reason
      | Ok (Proved { invariant; proofs }) ->
        List.iter2 (compare_one all (Ranges.point l.model.ranges)) (ordinary l) proofs;
        if List.length invariant.locations <= few && not (List.mem file many_parts) then rejects l u invariant)

let enough () =
  Printf.printf "%d proved, %d rejected; of %d with a single state of a kind, %d accepted\n" !compared !rejected
    !thinned !still_accepted;
  Alcotest.(check bool) "fewer states" true (!thinned > 40 && !still_accepted * 10 <= !thinned);
  Alcotest.(check bool) "many proofs" true (!compared > 60);
  Alcotest.(check bool) "many that are none" true (!rejected > 100)

(* Where the search before has no time, what is to be explored after it is explored all the same, in half of the
   time that is left, and what that leaves open is searched for once more. *)
let explored_after () =
  match load "escape.sc" with
  | Error _ -> Alcotest.fail "escape.sc is not read"
  | Ok l -> (
      let asked = ref 0 in
      let half () =
        incr asked;
        if !asked mod 2 = 0 then Limits.quiet else Limits.undivided ~stop:(fun () -> Some Limits.Seconds) ()
      in
      let surroundings = { Limits.quiet with half } in
      let bounds = { Bounds.default with depth = Given 50 } in
      match Loaded.initial l with
      | Ok initial -> (
          let options = { Setup.default with prove = true; surroundings; bounds } in
          match Scc_verdicts.Verdicts.report options l ~initial ~exactly:false l.checks ~premises:[] with
          | Error _ -> Alcotest.fail "escape.sc has verdicts"
          | Ok report ->
            Alcotest.(check bool) "half of the time, twice" true (!asked > 0 && !asked mod 2 = 0);
            Alcotest.(check bool) "zones" true (report.stats.states > 20);
            let end_ : By_invariant.end_ -> string = function
              | None_found reason | Given_up reason -> reason
              | Proved _ -> "proved"
            in
            let reasons = List.sort_uniq String.compare (List.map end_ report.invariants) in
            Alcotest.(check (list string)) "invariants" [ "proved" ] reasons)
      | Error _ -> Alcotest.fail "no initial state")

(* Its row is so long that it takes a minute. *)
let slow = [ "cradle.sc" ]

let () =
  let files = List.filter (fun f -> Filename.check_suffix f ".sc") (Array.to_list (Sys.readdir models)) in
  let files = List.filter (fun f -> not (List.mem f slow)) (List.sort String.compare files) in
  let case file = Alcotest.test_case file `Quick (proves file) in
  Alcotest.run "models by invariants"
    [ ("models", List.map case files); ("enough", [ Alcotest.test_case "compared" `Quick enough ]);
      ("time", [ Alcotest.test_case "explored after it" `Quick explored_after ]) ]
