(* What the limit of seconds ends, in processes of their own: each begins with a limit that passes at once, and
   computes for longer than the grace. *)

module Interrupt = Scc_cli__Interrupt

let busy () =
  let stop = Unix.gettimeofday () +. Interrupt.grace +. 0.7 in
  while Unix.gettimeofday () < stop do
    ignore (Sys.opaque_identity (List.init 100 Fun.id))
  done

let started work =
  flush_all ();
  match Unix.fork () with
  | 0 ->
    Unix.dup2 (Unix.openfile "/dev/null" [ O_WRONLY ] 0) Unix.stderr;
    let clock = Interrupt.clock 0.1 in
    work clock;
    Unix._exit 0
  | pid -> pid

let ended pid = match Unix.waitpid [] pid with _, WEXITED code -> code | _, (WSIGNALED _ | WSTOPPED _) -> -1

let read clock = ignore (clock () : float)

let limits () =
  let all =
    [
      ("an exploration whose step does not end", 4, fun _ -> busy ());
      ("what comes after an exploration", 0, fun _ -> Interrupt.ended (); busy ());
      ("the step of another one", 4, fun clock -> Interrupt.ended (); read clock; busy ());
      ("one that has seen that the time is over", 0, fun clock -> Unix.sleepf 0.2; read clock; busy ());
    ]
  in
  List.map (fun (what, expected, work) -> (what, expected, started work)) all
  |> List.iter (fun (what, expected, pid) -> Alcotest.(check int) what expected (ended pid))

let () = Alcotest.run "limits of seconds" [ ("seconds", [ Alcotest.test_case "who is given up" `Quick limits ]) ]
