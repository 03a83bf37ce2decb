(* A model of which everything is known, on a grid of splits, is a set of states of one: what is found over zones
   is what the ordinary exploration finds, for every check of every model of specs/models that zones can follow. Of
   models that never end, a thousand states are seen, or as many as [SCC_STATES] says. *)

open Scc_verify
open Scc_zones
module Loaded = Scc_loading.Loaded

let models = "../../../specs/models"

let read path =
  let channel = open_in_bin path in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel;
  text

let load file =
  let read_file name = try Ok (read (Filename.concat models name)) with Sys_error e -> Error e in
  Loaded.load ~read_file ~overrides:[] (Scc_base.Source.make ~name:file (read (Filename.concat models file)))

let most = Option.value (Option.bind (Sys.getenv_opt "SCC_STATES") int_of_string_opt) ~default:1_000
let bounds = { Bounds.default with states = Given most }
let options = { Setup.default with bounds }

let kind : Verdict.t -> string = function
  | Holds { bounds = []; _ } -> "holds"
  | Holds _ -> "holds up to a bound"
  | Violated _ -> "violated"
  | Measured _ | Depends _ -> "measured"
  | Undecided _ -> "undecided"

let compared = ref 0
let undecided = ref []
let premises = ref 0
let never_met = ref 0

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

(* That no run meets a premise is said by both, or by neither: of one start all is known that is known of many. *)
let same_premise file (a : Verdict.outcome) (b : Verdict.outcome) =
  match kind a.verdict with
  | ("holds" | "violated") as one ->
    incr premises;
    let never = String.equal one "violated" in
    if never then incr never_met;
    let text = Printf.sprintf "%s: no run meets %s" file a.check.Scc_property.Property.text in
    Alcotest.(check bool) text never (String.equal (kind b.verdict) "violated")
  | _ -> ()

let agrees file () =
  match load file with
  | Error _ -> ()
  | Ok l ->
    if Zone_check.refused l.model Zones = [] && not (Zone_check.is_for l.model ~declared:l.declared) then begin
      let initial = match Loaded.initial l with Ok s -> s | Error _ -> Alcotest.fail "no initial state" in
      let ordinary = Check.run options l.semantics ~initial (l.checks @ l.premises) in
      let known = Scc_symbolic.Start.known l.model l.declared in
      let { Loaded.semantics; declared; premises; checks; _ } = l in
      match Zone_check.run options semantics known ~declared ~exactly:false ~premises checks with
      | Error _ -> Alcotest.fail "the declared state is not well-formed"
      | Ok report ->
        let n = List.length l.checks in
        let all = List.combine ordinary.outcomes report.outcomes in
        List.iteri (fun i (a, b) -> if i < n then same file a b else same_premise file a b) all
    end

(* {1 When it is enough}

   One of two checks fails for some values, and the other one for others. That each fails somewhere decides
   nothing: the exploration has to go on, down the row that one of both sets going. *)

let row =
  {|model row
    shape Cube {
      vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
               e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
      faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
               right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
    }
    param y in [-4, 4]
    process p = Cube mass 1 velocity (1,0,0) at translate (0, y, 0) [nil]
    process q = Cube mass 1 at translate (6, -3, 0) [nil]
    process r = Cube mass 1 at translate (9, 3, 0) [nil]
    process s = Cube mass 1 at translate (12, -3, 0) [nil]
    process t = Cube mass 1 at translate (18, -3, 0) [nil]
    check either : (always vx(q) = 0) or (always vx(r) = 0)
    check both : (always vx(q) = 0) and (always vx(r) = 0)|}

let either () =
  let read_file _ = Error "no file" in
  match Loaded.load ~read_file ~overrides:[] (Scc_base.Source.make ~name:"row.sc" row) with
  | Error _ -> Alcotest.fail "it is refused"
  | Ok l -> (
      let uncertain = Option.get l.uncertain in
      let { Loaded.semantics; declared; checks; _ } = l in
      match Zone_check.run options semantics uncertain ~declared ~exactly:false ~premises:[] checks with
      | Error _ -> Alcotest.fail "the declared state is not well-formed"
      | Ok report ->
        let kinds = List.map (fun (o : Verdict.outcome) -> kind o.verdict) report.outcomes in
        Alcotest.(check (list string)) "either, both" [ "holds"; "violated" ] kinds)

let enough () =
  List.iter print_endline (List.rev !undecided);
  Printf.printf "%d compared, %d premises, %d never met\n" !compared !premises !never_met;
  Alcotest.(check bool) "many verdicts" true (!compared > 100 && !premises > 10 && !never_met > 0)

let () =
  let files = List.filter (fun f -> Filename.check_suffix f ".sc") (Array.to_list (Sys.readdir models)) in
  let case file = Alcotest.test_case file `Quick (agrees file) in
  Alcotest.run "models over zones"
    [
      ("models", List.map case (List.sort String.compare files));
      ("ranges", [ Alcotest.test_case "each of two fails somewhere" `Quick either ]);
      ("enough", [ Alcotest.test_case "compared" `Quick enough ]);
    ]
