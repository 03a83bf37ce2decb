(* What a watch gives up, and when; in processes of their own, as timers and signals are those of a process. *)

open Scc_graph_search
module Watch = Scc_cli__Watch

let processor_seconds s =
  let stop = Sys.time () +. s in
  while Sys.time () < stop do
    ignore (Sys.opaque_identity (List.init 100 Fun.id))
  done

let for_ever () = processor_seconds infinity

let until_interrupted work = match work () with code -> code | exception Scc_system.Interruption.Interrupted _ -> 4

(* The exit code tells what came of the work. *)
let started work =
  flush_all ();
  match Unix.fork () with
  | 0 ->
    Unix.dup2 (Unix.openfile "/dev/null" [ O_WRONLY ] 0) Unix.stderr;
    Unix._exit (until_interrupted work)
  | pid -> pid

let ended pid = match Unix.waitpid [] pid with _, WEXITED code -> code | _, (WSIGNALED _ | WSTOPPED _) -> -1

let code = function
  | Ok () -> 0
  | Error Limits.Seconds -> 10
  | Error Limits.Memory -> 11
  | Error Limits.Interrupted -> 12

(* A clock that stands, so that nothing depends on how busy the machine is. *)
let now = ref 0.
let clock () = !now

let attempt ?seconds ?memory ?(before = ignore) stage work () =
  let watch = Watch.start ?seconds ?memory () in
  before ();
  code ((Watch.attempt watch).run stage work)

let signal () = Unix.kill (Unix.getpid ()) Sys.sigint

(* It stays reachable, so that it cannot be collected. *)
let kept = ref []

let rec allocate () =
  kept := Bytes.make 100_000 'x' :: !kept;
  allocate ()

(* What it has taken is nobody's any more when it is given up: what is explored then has all of the memory. *)
let explored_after stage () =
  let rec allocate_more list = allocate_more (Bytes.make 100_000 'x' :: list) in
  let attempt = Watch.attempt (Watch.start ~memory:(Scc_base.Memory.words_of_mib 100) ()) in
  match attempt.run stage (fun () -> allocate_more []) with
  | Error Memory -> code (attempt.run Exploring ignore)
  | Ok _ | Error (Seconds | Interrupted) -> 1

let words = Scc_base.Memory.words_of_mib 100

let inner_and_outer () =
  let watch = Watch.start ~seconds:0.1 () in
  let attempt = Watch.attempt watch in
  let inner () =
    match attempt.run Exploring for_ever with Error Seconds -> 0 | Ok () | Error (Memory | Interrupted) -> 1
  in
  match attempt.run Reporting inner with Ok code -> code | Error _ -> 2

(* Half of what is left, and not more of it, however late it begins; a signal ends it as well. *)
let half () =
  let watch = Watch.start ~clock ~seconds:12. () in
  now := 2.;
  let over = Watch.half watch () in
  let at_first = over () in
  now := 7.;
  let in_the_middle = over () in
  now := 7.5;
  let later = over () in
  let another = Watch.half watch () in
  match ((at_first, in_the_middle, later), Watch.stop watch (), another ()) with
  | (None, None, Some Seconds), None, None -> (
      signal ();
      processor_seconds 0.1;
      match another () with Some stop -> code (Error stop) | None -> 2)
  | _ -> 1

let too_long () = processor_seconds 3.

(* What may take half of the seconds is given up in the middle, though it asks nothing, and what comes after it has
   the other half; what concludes is not. *)
let within_half stage work () =
  let watch = Watch.start ~clock ~seconds:12. () in
  let around = Watch.surroundings watch ~progress:ignore ~attempt:(Watch.attempt watch) in
  now := 2.;
  let half = around.half () in
  let quarter = half.half () in
  let result = half.attempt.run stage (fun () -> now := 7.5; work ()) in
  let next = half.attempt.run Exploring ignore and rest = around.attempt.run Exploring ignore in
  match (half.stop (), quarter.stop (), around.stop (), next, rest) with
  | Some Seconds, Some Seconds, None, Error Seconds, Ok () -> code result
  | _ -> 1

(* A part of a half ends before it. *)
let within_quarter () =
  let watch = Watch.start ~clock ~seconds:12. () in
  let around = Watch.surroundings watch ~progress:ignore ~attempt:(Watch.attempt watch) in
  now := 4.;
  let half = around.half () in
  let inner () = (half.half ()).attempt.run Proving (fun () -> now := 6.5; too_long ()) in
  match half.attempt.run Exploring inner with
  | Ok (Error Seconds) when Option.is_none (half.stop ()) -> 0
  | Ok _ | Error _ -> 1

(* Of twelve seconds, and a thirteenth for conclusions, the first of two checks has half: what explores three
   quarters of that, and what concludes the rest. The second one has what the first one leaves. *)
let within_share stage work () =
  let watch = Watch.start ~clock ~seconds:12. () in
  let around = Watch.surroundings watch ~progress:ignore ~attempt:(Watch.attempt watch) in
  now := 0.;
  let first = around.share ~mine:1 ~all:2 in
  let at time stage work = first.attempt.run stage (fun () -> now := time; work ()) in
  let early = (at 4.4 Exploring ignore, first.stop ()) in
  let result = at (match stage with Limits.Exploring -> 4.6 | _ -> 6.6) stage work in
  let nothing = first.attempt.run stage ignore in
  let second = around.share ~mine:1 ~all:1 in
  now := 11.9;
  let rest = (second.attempt.run Exploring ignore, second.attempt.run Concluding ignore) in
  match (early, first.stop (), nothing, rest) with
  | (Ok (), None), Some Seconds, Error Seconds, (_, Ok ()) -> code result
  | _ -> 1

(* After a signal what concludes has its second, whatever its share was. *)
let share_after_signal () =
  let watch = Watch.start ~clock ~seconds:12. () in
  let around = Watch.surroundings watch ~progress:ignore ~attempt:(Watch.attempt watch) in
  let share = around.share ~mine:1 ~all:20 in
  now := 11.;
  signal ();
  code (share.attempt.run Concluding (fun () -> processor_seconds 0.3))

let share_without_end () =
  let around = Watch.surroundings (Watch.start ()) ~progress:ignore ~attempt:(Watch.attempt (Watch.start ())) in
  match (around.share ~mine:1 ~all:3).stop () with None -> 0 | Some _ -> 1

let without_end () =
  let watch = Watch.start () in
  match Watch.half watch () () with None -> 0 | Some _ -> 1

(* A signal after the work has ended by itself, and what is reported then. *)
let signal_and_report report () =
  Watch.finish (Watch.start ());
  signal ();
  report ();
  0

let stubborn () =
  ignore (Watch.start ~seconds:0.1 ());
  let rec again () =
    match for_ever () with () -> 0 | exception Scc_system.Interruption.Interrupted _ -> again ()
  in
  again ()

let cases =
  [
    ("what ends in time", 0, attempt ~seconds:3600. Exploring ignore);
    ("an exploration", 10, attempt ~seconds:0.1 Exploring for_ever);
    ("a conclusion", 10, attempt ~seconds:0.1 Concluding for_ever);
    ("a conclusion has a little more", 0, attempt ~seconds:0.1 Concluding (fun () -> processor_seconds 0.6));
    ("the report", 10, attempt ~seconds:0.1 Reporting for_ever);
    ("an exploration within a report", 0, inner_and_outer);
    ("what is no attempt", 4, fun () -> ignore (Watch.start ~seconds:0.1 ()); for_ever (); 0);
    ("what is no attempt and lets nothing through", 4, stubborn);
    ("work that has half of it", 12, half);
    ("work that has half of no limit", 0, without_end);
    ("an exploration in the middle", 10, within_half Exploring too_long);
    ("a proof in the middle", 10, within_half Proving too_long);
    ("a conclusion in the middle", 0, within_half Concluding (fun () -> processor_seconds 0.1));
    ("half of a half", 0, within_quarter);
    ("an exploration that has a share", 10, within_share Exploring too_long);
    ("a conclusion that has a share", 10, within_share Concluding too_long);
    ("a conclusion with a share after a signal", 0, share_after_signal);
    ("a share of no limit", 0, share_without_end);
    ("an exploration after a signal", 12, attempt ~before:signal Exploring for_ever);
    ("an exploration after a proof that took memory", 0, explored_after Proving);
    ("one that takes memory", 11, attempt ~memory:words Exploring allocate);
    ("nothing, once it is finished", 0, fun () ->
        let watch = Watch.start ~seconds:0.1 () in
        Watch.finish watch; processor_seconds 0.5; 0);
    ("nobody who reports", 0, signal_and_report (fun () -> processor_seconds 0.6));
    ("who reports for ever", 4, signal_and_report for_ever);
    ( "not what must not be left half done", 0,
      attempt ~seconds:0.1 Exploring (fun () -> Scc_base.Critical.run (fun () -> processor_seconds 0.5)) );
  ]

let given_up () =
  List.map (fun (what, expected, work) -> (what, expected, started work)) cases
  |> List.iter (fun (what, expected, pid) -> Alcotest.(check int) what expected (ended pid))

let () = Alcotest.run "watch" [ ("attempts", [ Alcotest.test_case "what is given up" `Quick given_up ]) ]
