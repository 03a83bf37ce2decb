(* A model of which everything is known, on a grid of splits, is a set of states of one: what is found over zones
   is what the ordinary exploration finds, for every check of every model of specs/models that zones can follow. *)

open Scc_verify
module Loaded = Scc_session.Loaded

let models = "../../../specs/models"

let read path =
  let channel = open_in_bin path in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel;
  text

let load file =
  let read_file name = try Ok (read (Filename.concat models name)) with Sys_error e -> Error e in
  Loaded.load ~read_file ~overrides:[] (Scc_base.Source.make ~name:file (read (Filename.concat models file)))

let bounds = { Bounds.default with states = Given 3_000 }
let options = { Check.default with bounds }

let kind : Verdict.t -> string = function
  | Holds { bounds = []; _ } -> "holds"
  | Holds _ -> "holds up to a bound"
  | Violated _ -> "violated"
  | Undecided _ -> "undecided"

let compared = ref 0
let undecided = ref []

(* What either of them leaves open contradicts nothing. *)
let same file (a : Verdict.outcome) (b : Verdict.outcome) =
  let one = kind a.verdict and two = kind b.verdict in
  let decided v = String.equal v "holds" || String.equal v "violated" in
  if decided one && decided two then begin
    incr compared;
    Alcotest.(check string) (file ^ ": " ^ a.check.Scc_property.Property.name) one two
  end
  else if decided one then
    let name = a.check.Scc_property.Property.name in
    undecided := Printf.sprintf "%s: %s (%s)" file name (Verdict.to_string b.verdict) :: !undecided

let agrees file () =
  match load file with
  | Error _ -> ()
  | Ok l ->
    if Zone_check.refused l.model = [] && not (Zone_check.is_for l.model ~declared:l.declared) then begin
      let initial = match Loaded.initial l with Ok s -> s | Error _ -> Alcotest.fail "no initial state" in
      let ordinary = Check.run options l.semantics ~initial l.checks in
      let known = Scc_symbolic.Start.known l.model l.declared in
      match Zone_check.run options l.semantics known ~declared:l.declared ~exactly:false l.checks with
      | Error _ -> Alcotest.fail "the declared state is not well-formed"
      | Ok report -> List.iter2 (same file) ordinary.outcomes report.outcomes
    end

let enough () =
  List.iter print_endline (List.rev !undecided);
  Printf.printf "%d compared\n" !compared;
  Alcotest.(check bool) "many verdicts" true (!compared > 100)

let () =
  let files = List.filter (fun f -> Filename.check_suffix f ".sc") (Array.to_list (Sys.readdir models)) in
  let case file = Alcotest.test_case file `Quick (agrees file) in
  Alcotest.run "models over zones"
    [
      ("models", List.map case (List.sort String.compare files));
      ("enough", [ Alcotest.test_case "compared" `Quick enough ]);
    ]
