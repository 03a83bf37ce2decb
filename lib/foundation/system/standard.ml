exception Closed
exception Failed of string

(* After a wish to end, who takes nothing for so many seconds is taken to read no more. *)
let patience = 2.

(* What a pipe takes without waiting, once it takes anything. *)
let morsel = 512

let rec wait_until_writable fd ~since =
  let left = since +. patience -. Unix.gettimeofday () in
  if Interruption.heard () && left <= 0. then raise Closed;
  match Unix.select [] [ fd ] [] (if Interruption.heard () then left else -1.) with
  | _, [], _ | (exception Unix.Unix_error (EINTR, _, _)) -> wait_until_writable fd ~since
  | _ -> ()

let rec write fd bytes from stop =
  if from < stop then begin
    Interruption.heed ();
    let hurried = Interruption.heard () in
    let some () =
      if hurried then wait_until_writable fd ~since:(Unix.gettimeofday ());
      Unix.single_write fd bytes from (if hurried then Int.min morsel (stop - from) else stop - from)
    in
    match some () with
    | n -> write fd bytes (from + n) stop
    | exception Unix.Unix_error (EINTR, _, _) -> write fd bytes from stop
    | exception Unix.Unix_error ((EAGAIN | EWOULDBLOCK), _, _) ->
      wait_until_writable fd ~since:(Unix.gettimeofday ());
      write fd bytes from stop
    | exception Unix.Unix_error ((EPIPE | ECONNRESET), _, _) -> raise Closed
    | exception Unix.Unix_error (e, _, _) -> raise (Failed (Unix.error_message e))
  end

(* {1 Output} *)

let enough = 65536
let waiting = Buffer.create enough
let sent = ref false

(* Set once nothing can be written any more. *)
let given_up = ref false

let send bytes from stop =
  if from < stop && not !given_up then begin
    sent := true;
    match write Unix.stdout bytes from stop with
    | () -> ()
    | exception e ->
      given_up := true;
      raise e
  end

let flush () =
  if Buffer.length waiting > 0 then begin
    let bytes = Buffer.to_bytes waiting in
    Buffer.clear waiting;
    send bytes 0 (Bytes.length bytes)
  end

let print text =
  if String.length text >= enough then begin
    flush ();
    send (Bytes.unsafe_of_string text) 0 (String.length text)
  end
  else begin
    Buffer.add_string waiting text;
    if Buffer.length waiting >= enough then flush ()
  end

let part = Bytes.create enough

let print_buffer buffer =
  flush ();
  let n = Buffer.length buffer in
  let rec go from =
    if from < n then begin
      let size = Int.min enough (n - from) in
      Buffer.blit buffer from part 0 size;
      send part 0 size;
      go (from + size)
    end
  in
  go 0

let withdraw () =
  Buffer.clear waiting;
  given_up := !sent;
  not !sent

(* {1 Errors} *)

let deaf = ref false

let control text =
  if not !deaf then
    match write Unix.stderr (Bytes.unsafe_of_string text) 0 (String.length text) with
    | () -> ()
    | exception (Closed | Failed _) -> deaf := true

let complain text = control (Scc_base.Visible.text text)
