(* Tasks of several processes: what comes of them is what comes of one, and whatever happens to them is told. *)

open Scc_workers

(* In words: how it ended. *)
let told : (unit, Pool.stop) result -> string = function
  | Ok () -> "all"
  | Error Interrupted -> "interrupted"
  | Error (Lost { task; how }) -> Printf.sprintf "lost %d: %s" task how

let never () = false

(* What each task gives, in the order in which it is taken up. *)
let collected ?(interrupted = never) ?(first = 0) ~jobs ~count work =
  let found = ref [] in
  let each k x = found := (k, x) :: !found in
  let ended = Pool.run ~jobs ~first ~count ~work ~interrupted ~each in
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

let lost () =
  let work k = if k = 5 then Unix.kill (Unix.getpid ()) Sys.sigkill else () in
  let ended, found = collected ~jobs:2 ~count:20 work in
  Alcotest.(check string) "killed" "lost 5: it was killed, as when memory runs out" (told ended);
  Alcotest.(check (list int)) "what was before" [ 0; 1; 2; 3; 4 ] (List.map fst found);
  let work k = if k = 3 then Unix._exit 9 in
  let ended, found = collected ~jobs:4 ~count:20 work in
  Alcotest.(check string) "left" "lost 3: exit code 9" (told ended);
  Alcotest.(check int) "what was before" 3 (List.length found);
  nobody_left ()

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

(* What takes up the tasks may fail: no process is left over. *)
let refused () =
  let each k () = if k = 4 then failwith "enough" in
  (match Pool.run ~jobs:2 ~first:0 ~count:100 ~work:ignore ~interrupted:never ~each with
   | _ -> Alcotest.fail "an exception is lost"
   | exception Failure what -> Alcotest.(check string) "it is told" "enough" what);
  nobody_left ()

let () =
  let case name f = Alcotest.test_case name `Quick f in
  Alcotest.run "pool"
    [
      ( "results",
        [
          case "any number of processes" same; case "processes" others; case "a lost one" lost;
          case "an interruption" interrupted; case "an interruption of what sleeps" asleep;
          case "an exception" refused;
        ] );
    ]
