open Scc_session

exception Closed
exception Interrupted

(* An answer that is being written is written to its end. *)
type t = { out : Buffer.t; room : Bytes.t; mutable writing : bool; mutable interrupted : bool }

let rec write_all bytes from stop =
  if from < stop then
    match Unix.write Unix.stdout bytes from (stop - from) with
    | n -> write_all bytes (from + n) stop
    | exception Unix.Unix_error (EINTR, _, _) -> write_all bytes from stop
    | exception Unix.Unix_error ((EPIPE | EBADF | ECONNRESET), _, _) -> raise Closed
    | exception Unix.Unix_error (e, _, _) -> raise (Console.output_failed "standard output" (Unix.error_message e))

(* Answers wait until no further question does, or there are many. *)
let enough = 65536

let send c =
  let n = Buffer.length c.out in
  if n > 0 then begin
    c.writing <- true;
    for part = 0 to (n - 1) / enough do
      let from = part * enough in
      let size = Int.min enough (n - from) in
      Buffer.blit c.out from c.room 0 size;
      write_all c.room 0 size
    done;
    if n > 64 * enough then Buffer.reset c.out else Buffer.clear c.out;
    c.writing <- false;
    if c.interrupted then raise Interrupted
  end

let add c put =
  let result = put c.out in
  if Buffer.length c.out >= enough then send c;
  result

let say c line =
  add c (fun out ->
      Buffer.add_string out line;
      Buffer.add_char out '\n')

let catch_signals c =
  let handle _ =
    c.interrupted <- true;
    if not c.writing then raise Interrupted
  in
  Sys.set_signal Sys.sigint (Sys.Signal_handle handle);
  Sys.set_signal Sys.sigterm (Sys.Signal_handle handle)

let hold talk =
  let c = { out = Buffer.create enough; room = Bytes.create enough; writing = false; interrupted = false } in
  catch_signals c;
  match
    let code = talk c in
    send c;
    code
  with
  | code -> code
  | exception Closed -> Exit_code.Stopped
  | exception Interrupted ->
    prerr_endline "scc: interrupted";
    Exit_code.Stopped
