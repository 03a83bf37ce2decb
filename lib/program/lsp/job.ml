open Scc_system

type 'a message = Progress of string | Result of 'a

type t = {
  pid : int;
  from : Unix.file_descr;
  received : Buffer.t;
  handle : string -> unit;  (* a whole message *)
  finish : unit -> unit;
}

let source t = t.from

(* Nothing that the process prints by itself goes to the client. *)
let silence () =
  let nowhere = Unix.openfile "/dev/null" [ O_RDWR ] 0 in
  List.iter (fun fd -> Unix.dup2 nowhere fd) [ Unix.stdin; Unix.stdout; Unix.stderr ];
  Unix.close nowhere

let child work out =
  silence ();
  let channel = Unix.out_channel_of_descr out in
  let tell message =
    output_string channel (Marshal.to_string message []);
    flush channel
  in
  tell (Result (work (fun line -> tell (Progress line))))

let start ~work ~progress ~ended =
  let begin_ from out =
    Interruption.fork (fun () ->
        Sys.set_signal Sys.sigpipe Sys.Signal_default;
        Unix.close from;
        Beside.labour (fun () -> child work out))
    |> fun pid -> (pid, from)
  in
  let result = ref None in
  let handle text =
    match Marshal.from_string text 0 with Progress line -> progress line | Result x -> result := Some x
  in
  Beside.fork (fun () -> Unix.pipe ~cloexec:true ()) begin_
  |> Option.map (fun (pid, from) ->
      { pid; from; received = Buffer.create 4096; handle; finish = (fun () -> ended !result) })

let rec waited pid =
  match Unix.waitpid [] pid with
  | _ -> ()
  | exception Unix.Unix_error (EINTR, _, _) -> waited pid
  | exception Unix.Unix_error _ -> ()

let leave t =
  Unix.close t.from;
  waited t.pid

(* The messages that are complete. *)
let rec messages t =
  let text = Buffer.contents t.received in
  if String.length text >= Marshal.header_size then begin
    let size = Marshal.total_size (Bytes.unsafe_of_string text) 0 in
    if String.length text >= size then begin
      Buffer.clear t.received;
      Buffer.add_substring t.received text size (String.length text - size);
      t.handle (String.sub text 0 size);
      messages t
    end
  end

let chunk = 65536

let heard t =
  let bytes = Bytes.create chunk in
  match Unix.read t.from bytes 0 chunk with
  | 0 ->
    messages t;
    leave t;
    t.finish ();
    true
  | n ->
    Buffer.add_subbytes t.received bytes 0 n;
    if n < chunk then messages t;
    false
  | exception Unix.Unix_error (EINTR, _, _) -> false

let kill t =
  (try Unix.kill t.pid Sys.sigkill with Unix.Unix_error _ -> ());
  leave t
