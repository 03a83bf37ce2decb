let stopped = 4
let bug = 70

let rec code_after = function
  | Fun.Finally_raised e -> code_after e
  | Interruption.Interrupted why -> (stopped, why)
  | e -> (
      match Resources.refused e with
      | Some what -> (stopped, what)
      | None -> (bug, "internal error: " ^ Printexc.to_string e))

let leave code = Unix._exit code

let after e =
  let code, why = code_after e in
  (try Standard.complain ("scc: " ^ why ^ "\n") with _ -> ());
  leave code

let run main =
  match main () with
  | code ->
    Interruption.ignored ();
    leave code
  | exception e -> after e

external give_errors : unit -> unit = "scc_give_errors" [@@noalloc]

(* Before the other modules are set up. *)
let () =
  Printexc.set_uncaught_exception_handler (fun e _ -> after e);
  give_errors ();
  Descriptors.secure ();
  (* Writing to a closed pipe, or beyond the size of files, is an error to be handled, and not the end. *)
  if not Sys.win32 then List.iter (fun s -> Sys.set_signal s Sys.Signal_ignore) [ Sys.sigpipe; Sys.sigxfsz ];
  Interruption.listen ()
