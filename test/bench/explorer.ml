(* States per second and bytes per state of the exploration, without properties:

     explorer.exe                          several models at several sizes, and a gas of a thousand cubes
     explorer.exe bars                     those of which figures are kept in README.md
     explorer.exe MODEL STATES [NAME=VALUE …]   one model, up to so many states

   Seconds are of the processor, in user mode, so that others who work on the machine matter little. Run from the
   root of the project. *)

open Scc_base
open Scc_exact
open Scc_graph_search

let standard = Scc_engine.Standard.of_model
module Network_lts = Scc_state_space.Network_lts
module Graph = Explore.Make (Network_lts)

let read path =
  let channel = open_in_bin path in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel;
  text

let fail message =
  prerr_endline message;
  exit 3

let load path overrides =
  let source = Source.make ~name:path (read path) in
  let refuse diagnostics =
    fail (String.concat "" (List.map (Diag.render ~source:(fun _ -> Some source)) diagnostics))
  in
  match Scc_syntax.Parse.parse source with
  | Error d -> refuse d
  | Ok tree -> (
      let read_file _ = Error "the benchmark reads no meshes" in
      match Scc_elaborate.Elaborate.elaborate ~read_file ~overrides tree with
      | Error d -> refuse d
      | Ok e -> e)

let context (e : Scc_elaborate.Elaborate.t) =
  match Scc_semantics.Network.initial (standard e.model) e.declared with
  | Ok initial -> Network_lts.make (standard e.model) initial
  | Error f -> fail (Scc_semantics.Transition.diagnostic e.model f).message

let live_words () =
  Gc.compact ();
  (Gc.stat ()).live_words

let seconds f =
  let user () = (Unix.times ()).tms_utime in
  let start = user () in
  let x = f () in
  (x, user () -. start)

let shown overrides =
  String.concat " " (List.map (fun (n, v) -> Printf.sprintf "%s=%s" n (Rat.to_string v)) overrides)

let measure path states overrides =
  let e, loading = seconds (fun () -> load path overrides) in
  let c = context e in
  let before = live_words () in
  let limits = { Limits.unlimited with states = Some states } in
  let g, time = seconds (fun () -> Graph.run limits Limits.quiet c) in
  let words = live_words () - before in
  let { Graph.states; labels; edges } = Graph.memory g in
  let beside = states + labels + edges in
  let n = Graph.size g in
  let per x = float_of_int x /. time in
  Printf.printf
    "%-10s %-6s load %6.3f s %7d states %7d transitions %7.0f states/s %7.0f transitions/s %6d \
     bytes/state%s\n\
     %!"
    (Filename.remove_extension (Filename.basename path))
    (shown overrides) loading n (Graph.transitions g) (per n)
    (per (Graph.transitions g))
    (((words * (Sys.word_size / 8)) + beside) / n)
    (if Graph.complete g then "" else "  (bounded)")

(* What a large model costs: reading, validating and the first steps. *)
let first_steps path overrides steps =
  let e, loading = seconds (fun () -> load path overrides) in
  let c = context e in
  let rec step n s =
    if n = 0 then ()
    else
      match Network_lts.successors c s with
      | Ok (t :: _) -> step (n - 1) (Tuples.apply t.changes s)
      | _ -> ()
  in
  let (), time = seconds (fun () -> step steps (Network_lts.initial c)) in
  Printf.printf "%-10s %-6s load and validate %.3f s, %d steps %.3f s\n%!"
    (Filename.remove_extension (Filename.basename path))
    (shown overrides) loading steps time

let override s =
  match String.split_on_char '=' s with
  | [ name; value ] -> (
      match Rat.of_literal value with
      | Ok q -> (name, q)
      | Error _ -> fail (s ^ ": not a number"))
  | _ -> fail (s ^ ": not of the form name=value")

let n k = [ ("n", Rat.of_int k) ]

let all () =
  List.iter (fun k -> measure "specs/models/gas.sc" 20_000 (n k)) [ 2; 3; 4 ];
  List.iter (fun k -> measure "specs/models/chain.sc" 20_000 (n k)) [ 4; 40; 160 ];
  List.iter (fun k -> measure "test/bench/dimers.sc" 20_000 (n k)) [ 4; 8; 10 ];
  first_steps "specs/models/gas.sc" (n 10) 100

let bars () =
  measure "test/bench/checker/hexokinase.sc" 200_000 (n 5);
  measure "specs/models/gas.sc" 200_000 (n 4);
  measure "specs/models/gas.sc" 2_000 (n 10);
  measure "specs/models/chain.sc" 20_000 (n 160);
  measure "specs/models/chain.sc" 20_000 (n 1000);
  measure "test/bench/dimers.sc" 100_000 (n 18);
  measure "test/bench/dimers.sc" 20_000 (n 500)

let () =
  match Array.to_list Sys.argv with
  | [ _ ] -> all ()
  | [ _; "bars" ] -> bars ()
  | _ :: path :: states :: overrides when Option.is_some (int_of_string_opt states) ->
    measure path (int_of_string states) (List.map override overrides)
  | _ -> fail "usage: explorer.exe [bars | MODEL STATES [NAME=VALUE …]]"
