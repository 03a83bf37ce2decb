(* Tasks of several processes: what comes of them is what comes of one, and whatever happens to them is told. *)

open Scc_system
open Scc_workers

(* In words: how it ended. *)
let told : (unit, Pool.stop) result -> string = function
  | Ok () -> "all"
  | Error Interrupted -> "interrupted"
  | Error (Lost { task; how; fault }) ->
    Printf.sprintf "lost %d%s: %s" task (if fault then ", a fault" else "") how

let never () = false

(* What each task gives, in the order in which it is taken up. *)
let collected ?(interrupted = never) ?(first = 0) ~jobs ~count work =
  let found = ref [] in
  let each k x = found := (k, x) :: !found in
  let ended = Pool.run ~jobs ~first ~count ~work ~interrupted ~each () in
  (ended, List.rev !found)

let same () =
  let work k = String.make (1 + (k * 977 mod 200_000)) (Char.chr (97 + (k mod 26))) in
  List.iter
    (fun (first, count) ->
       let alone = collected ~first ~jobs:1 ~count work in
       let numbers = List.init (count - first) (( + ) first) in
       Alcotest.(check (list int)) "all, in order" numbers (List.map fst (snd alone));
       List.iter
         (fun jobs ->
            let ended, found = collected ~first ~jobs ~count work in
            Alcotest.(check string) "to the end" "all" (told ended);
            Alcotest.(check (list (pair int string))) (Printf.sprintf "%d processes" jobs) (snd alone) found)
         [ 2; 3; 8 ])
    [ (0, 0); (0, 1); (3, 3); (5, 7); (0, 50); (11, 40) ]

(* They really are other processes, as many as were asked for. *)
let others () =
  let _, found = collected ~jobs:3 ~count:12 (fun _ -> Unix.getpid ()) in
  let pids = List.sort_uniq compare (List.map snd found) in
  Alcotest.(check int) "three" 3 (List.length pids);
  Alcotest.(check bool) "none is this one" false (List.mem (Unix.getpid ()) pids)

let nobody_left () =
  match Unix.waitpid [ WNOHANG ] (-1) with
  | pid, _ -> Alcotest.failf "there is a process %d" pid
  | exception Unix.Unix_error (ECHILD, _, _) -> ()

(* How often something has come to a task, in all processes, which share nothing but files. *)
let with_marks f =
  let file = Filename.temp_file "pool" "marks" in
  let text () =
    let channel = open_in_bin file in
    Fun.protect
      ~finally:(fun () -> close_in channel)
      (fun () -> really_input_string channel (in_channel_length channel))
  in
  let mark k =
    let fd = Unix.openfile file [ O_WRONLY; O_APPEND ] 0o600 in
    ignore (Unix.write_substring fd (String.make 1 (Char.chr k)) 0 1);
    Unix.close fd
  in
  let marks k = List.length (List.filter (Char.equal (Char.chr k)) (List.of_seq (String.to_seq (text ())))) in
  Fun.protect ~finally:(fun () -> Sys.remove file) (fun () -> f mark marks)

(* Twice: the runtime takes the first wrong access to memory for a stack that overflows, and looks again. *)
let kill_me signal =
  for _ = 1 to 2 do
    Unix.kill (Unix.getpid ()) signal
  done

(* Processes that die, now and then, at any tasks: what comes of it is what comes of none that dies. *)
let replaced () =
  let work k = String.make (1 + (k * 977 mod 200_000)) (Char.chr (97 + (k mod 26))) in
  let _, expected = collected ~jobs:1 ~count:40 work in
  let ways = [ (fun () -> kill_me Sys.sigkill); (fun () -> kill_me Sys.sigsegv); (fun () -> kill_me Sys.sigterm);
               (fun () -> kill_me Sys.sigabrt); (fun () -> Unix._exit 9); (fun () -> raise Out_of_memory) ] in
  List.iteri
    (fun i die ->
       List.iter
         (fun jobs ->
            with_marks (fun mark marks ->
                let dying k =
                  if (k + i) mod 7 = 0 && marks k < 3 then begin
                    mark k;
                    die ()
                  end;
                  work k
                in
                let ended, found = collected ~jobs ~count:40 dying in
                Alcotest.(check string) "to the end" "all" (told ended);
                Alcotest.(check (list int)) "some died" [ 3; 3; 3 ]
                  (List.map (fun n -> marks ((7 * n) - i)) [ 1; 3; 5 ]);
                Alcotest.(check (list (pair int string))) 
                  (Printf.sprintf "way %d, %d processes" i jobs)
                  expected found;
                nobody_left ()))
         [ 1; 2; 5 ])
    ways

(* Those that are killed from outside, at any instant. *)
let killed_from_outside () =
  let chance = Random.State.make [| 7 |] in
  let work k = (Unix.getpid (), k, String.make 100_000 'x') in
  let found = ref [] and kills = ref 0 in
  let each k (pid, task, text) =
    found := (k, task, String.length text) :: !found;
    if Random.State.int chance 3 = 0 then begin
      incr kills;
      try Unix.kill pid Sys.sigkill with Unix.Unix_error (ESRCH, _, _) -> ()
    end
  in
  let ended = Pool.run ~jobs:3 ~first:0 ~count:200 ~work ~interrupted:never ~each () in
  Alcotest.(check string) "to the end" "all" (told ended);
  Alcotest.(check bool) "some were killed" true (!kills > 30);
  Alcotest.(check bool) "each once, in order" true (List.rev !found = List.init 200 (fun k -> (k, k, 100_000)));
  nobody_left ()

(* A task that ends each process that works on it ends all, at its place, after so many. *)
let lost () =
  let in_a_row =
    Printf.sprintf "%d processes in a row that worked on it came to an end; the last one " Pool.most_deaths
  in
  List.iter
    (fun (die, how) ->
       with_marks (fun mark marks ->
           let work k =
             if k = 5 then begin
               mark k;
               die ()
             end
           in
           let ended, found = collected ~jobs:2 ~count:20 work in
           Alcotest.(check string) "lost" how (told ended);
           Alcotest.(check (list int)) "what was before" [ 0; 1; 2; 3; 4 ] (List.map fst found);
           if not (String.equal how "lost 5, a fault: the work on it failed: Not_found") then
             Alcotest.(check int) "so often" Pool.most_deaths (marks 5);
           nobody_left ()))
    [
      ((fun () -> kill_me Sys.sigkill), "lost 5: " ^ in_a_row ^ "was killed, as when memory runs out");
      ((fun () -> kill_me Sys.sigabrt), "lost 5: " ^ in_a_row ^ "was aborted, as when memory runs out");
      ((fun () -> raise Out_of_memory), "lost 5: " ^ in_a_row ^ "had no memory left");
      ((fun () -> kill_me Sys.sigsegv), "lost 5, a fault: " ^ in_a_row ^ "ended with a wrong access to memory");
      ((fun () -> Unix._exit 9), "lost 5, a fault: " ^ in_a_row ^ "ended with exit code 9");
      ((fun () -> raise Not_found), "lost 5, a fault: the work on it failed: Not_found");
    ]

(* Where there are few descriptors, and none that can be waited for, fewer work, or this process alone. *)
let few_descriptors () =
  let rec take fds = match Unix.dup Unix.stdin with fd -> take (fd :: fds) | exception Unix.Unix_error _ -> fds in
  let all = Array.of_list (take []) in
  let given_back = ref 0 in
  Fun.protect
    ~finally:(fun () -> Array.iteri (fun i fd -> if i >= !given_back then Unix.close fd) all)
    (fun () ->
       let expected = List.init 30 (fun k -> (k, k * k)) in
       for _ = 0 to 8 do
         let ended, found = collected ~jobs:8 ~count:30 (fun k -> k * k) in
         Alcotest.(check string) "to the end" "all" (told ended);
         Alcotest.(check (list (pair int int))) "all of it" expected found;
         nobody_left ();
         Unix.close all.(!given_back);
         incr given_back
       done)

let interrupted () =
  let asked = ref 0 in
  let interrupted () =
    incr asked;
    !asked > 10
  in
  List.iter
    (fun jobs ->
       asked := 0;
       let ended, found = collected ~interrupted ~jobs ~count:1_000_000 (fun k -> k) in
       Alcotest.(check string) "interrupted" "interrupted" (told ended);
       Alcotest.(check (list int)) "what was before" (List.init 10 Fun.id) (List.map fst found);
       nobody_left ())
    [ 1; 2 ]

(* A task that takes for ever is left, too. *)
let asleep () =
  let since = Unix.gettimeofday () in
  let interrupted () = Unix.gettimeofday () -. since > 0.3 in
  let ended, _ = collected ~interrupted ~jobs:2 ~count:4 (fun _ -> Unix.sleep 1000) in
  Alcotest.(check string) "interrupted" "interrupted" (told ended);
  nobody_left ()

(* A task that ends when it is asked to, one that is broken off, and one that does not answer in time. *)
let asked_to_end () =
  let waits k =
    let count = ref 0 in
    match
      while not (Interruption.heard ()) do
        incr count;
        Unix.sleepf 0.01
      done
    with
    | () -> (k, if !count > 0 then "waited" else "not begun")
  and works k =
    match
      while true do
        ignore (Sys.opaque_identity (ref 0))
      done
    with
    | () -> (k, "ended")
    | exception Interruption.Interrupted _ -> (k, "broken off")
  and lost _ =
    while true do
      ignore (Sys.opaque_identity (ref 0))
    done;
    (0, "")
  and deaf _ =
    Scc_base.Critical.run (fun () -> Unix.sleep 1000);
    (0, "")
  in
  let check name ~jobs ?(patience = 5.) work expected =
    let found = ref [] and since = Unix.gettimeofday () in
    let interrupted () = Unix.gettimeofday () -. since > 0.3 in
    let each k x = found := (k, x) :: !found in
    let work k = if k = 0 then (k, "whole") else work k in
    let ended = Pool.run ~patience ~jobs ~first:0 ~count:100 ~work ~interrupted ~each () in
    Alcotest.(check string) (name ^ ": interrupted") "interrupted" (told ended);
    let expected = (0, (0, "whole")) :: List.map (fun (k, text) -> (k, (k, text))) expected in
    Alcotest.(check (list (pair int (pair int string)))) name expected (List.rev !found);
    nobody_left ()
  in
  check "one" ~jobs:1 waits [ (1, "waited") ];
  check "two" ~jobs:2 waits [ (1, "waited"); (2, "waited") ];
  check "one that works on" ~jobs:1 works [ (1, "broken off") ];
  check "three that work on" ~jobs:3 works [ (1, "broken off"); (2, "broken off"); (3, "broken off") ];
  check "lost" ~jobs:2 lost [];
  check "deaf" ~jobs:2 ~patience:0.5 deaf []

(* What takes up the tasks may fail: no process is left over. *)
let refused () =
  let each k () = if k = 4 then failwith "enough" in
  (match Pool.run ~jobs:2 ~first:0 ~count:100 ~work:ignore ~interrupted:never ~each () with
   | _ -> Alcotest.fail "an exception is lost"
   | exception Failure what -> Alcotest.(check string) "it is told" "enough" what);
  nobody_left ()

let () =
  let case name f = Alcotest.test_case name `Quick f in
  Alcotest.run "pool"
    [
      ( "results",
        [
          case "any number of processes" same; case "processes" others; 
          case "processes that die are replaced" replaced;
          case "processes that are killed are replaced" killed_from_outside;
          case "a task that ends all" lost; case "few descriptors" few_descriptors;
          case "an interruption" interrupted; case "an interruption of what sleeps" asleep;
          case "tasks that are asked to end" asked_to_end; case "an exception" refused;
        ] );
    ]
