(* How the program ends, whatever was raised, and whatever has become of its streams; in processes of their own. *)

open Scc_system
module Guard = Scc_cli__Guard
module Console = Scc_cli__Console

let replaced fd path mode () = Unix.dup2 (Unix.openfile path [ mode ] 0) fd

let streams =
  let full fd = replaced fd "/dev/full" Unix.O_WRONLY in
  let closed fd () = Unix.close fd in
  let unread fd () =
    let out, into = Unix.pipe () in
    Unix.close out;
    Unix.dup2 into fd
  in
  let both f () = f Unix.stdout (); f Unix.stderr () in
  [
    ("whole", replaced Unix.stderr "/dev/null" Unix.O_WRONLY);
    ("full errors", full Unix.stderr); ("closed errors", closed Unix.stderr);
    ("unread errors", unread Unix.stderr);
    ("both full", both full); ("both closed", both closed); ("both unread", both unread);
  ]

let console = Console.make ~color:Never ~json:false ()
let lost () = raise (Console.output_failed "x" "lost")
let refused () = raise (Unix.Unix_error (EMFILE, "open", "x"))
let interrupted () = raise (Interruption.Interrupted "interrupted")

let requested () =
  Unix.kill (Unix.getpid ()) Sys.sigint;
  Unix.sleepf 0.;
  0

let settled () = Interruption.settle (); requested ()

(* The request came before, where it could not be raised. *)
let due () = Scc_base.Critical.run Interruption.break_off; Interruption.settle (); 0

let rec deep n = 1 + deep (n + 1)

(* What is raised, and the exit code. *)
let raised =
  [
    ("a fault", 70, fun () -> failwith "a fault");
    ("an invariant", 70, fun () -> Scc_base.Bug.fail __POS__ "broken");
    ("an error of the system", 70, fun () -> raise (Unix.Unix_error (EIO, "read", "")));
    ("exit, which is no way out", 70, fun () -> raise Exit);
    ("the stack", 70, fun () -> deep 0);
    ("no memory", 4, fun () -> raise Out_of_memory);
    ("no files", 4, refused);
    ("no files, told by a channel", 4, fun () -> raise (Sys_error ("x: " ^ Unix.error_message EMFILE)));
    ("an interruption", 4, interrupted);
    ("an interruption of what cleans up", 4, fun () -> Fun.protect ~finally:interrupted (fun () -> 0));
    ("a lost output", 74, lost);
    ("a request", 4, requested);
    ("a request when all is settled", 0, settled);
    ("a request before that", 4, due);
  ]

let ended work =
  flush_all ();
  match Unix.fork () with
  | 0 -> ( try work () with _ -> Unix._exit 99)
  | pid -> ( match Unix.waitpid [] pid with _, WEXITED code -> code | _, (WSIGNALED _ | WSTOPPED _) -> -1)

let guarded f () =
  Ending.run (fun () -> Scc_verdicts.Exit_code.to_int (Guard.run console (fun () -> ignore (f ()); Ok Holds)))

let bare f () = Ending.run f

let each check () =
  List.iter (fun (state, change) -> List.iter (fun case -> check state change case) raised) streams

let in_guard =
  each (fun state change (what, code, f) ->
      Alcotest.(check int) (what ^ ", " ^ state) code (ended (fun () -> change (); guarded f ())))

(* Outside of a command, nobody knows of outputs. *)
let outermost =
  each (fun state change (what, code, f) ->
      let code = if code = 74 then 70 else code in
      Alcotest.(check int) (what ^ ", " ^ state) code (ended (fun () -> change (); bare f ())))

(* What a verdict has printed is lost or not; its code stays one that is documented. *)
let verdicts () =
  List.iter
    (fun (state, change) ->
       List.iter
         (fun (code : Scc_verdicts.Exit_code.t) ->
            let number = Scc_verdicts.Exit_code.to_int code in
            let run () = Guard.run console (fun () -> Guard.complain [ "told" ]; Ok code) in
            let main () = Scc_verdicts.Exit_code.to_int (run ()) in
            let found = ended (fun () -> change (); Ending.run main) in
            Alcotest.(check int) (Printf.sprintf "%d, %s" number state) number found)
         Scc_verdicts.Exit_code.all)
    streams

(* A file that is opened does not take the place of a stream that is closed. *)
let places () =
  let work () =
    List.iter Unix.close [ Unix.stdin; Unix.stdout; Unix.stderr ];
    Descriptors.secure ();
    let file : int = Obj.magic (Unix.openfile "/dev/null" [ O_RDONLY ] 0) in
    let fails f = match f () with _ -> false | exception Unix.Unix_error (EBADF, _, _) -> true in
    let byte = Bytes.make 1 'x' in
    let read () = Unix.read Unix.stdin byte 0 1 and write fd () = Unix.write fd byte 0 1 in
    Unix._exit
      (if file > 2 && fails read && fails (write Unix.stdout) && fails (write Unix.stderr) then 0 else 1)
  in
  Alcotest.(check int) "secured" 0 (ended work)

let () =
  let case name f = Alcotest.test_case name `Quick f in
  Alcotest.run "guard"
    [
      ( "ends",
        [
          case "in a command" in_guard; case "outermost" outermost; case "verdicts" verdicts;
          case "places of streams" places;
        ] );
    ]
