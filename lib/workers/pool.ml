type stop = Interrupted | Lost of { task : int; how : string }

type worker = { pid : int; from : Unix.file_descr; channel : in_channel; mutable status : Unix.process_status
                    option }

(* An interruption of the whole group of processes is the parent's to answer; without a parent a child ends when it
   tells of its next task. *)
let of_child () =
  Sys.set_signal Sys.sigint Sys.Signal_ignore;
  Sys.set_signal Sys.sigterm Sys.Signal_default;
  Sys.set_signal Sys.sigpipe Sys.Signal_default

(* What is left to the child: its tasks, one after the other. *)
let labour ~jobs ~number ~first ~count ~work out =
  let channel = Unix.out_channel_of_descr out in
  let rec go k =
    if k < count then begin
      Marshal.to_channel channel (work k) [];
      flush channel;
      go (k + jobs)
    end
  in
  go (first + number)

(* No handler of the parent's is ever called in the child, which leaves without what the parent would do at its
   end. *)
let fork ~jobs ~number ~first ~count ~work others =
  let from, out = Unix.pipe ~cloexec:true () in
  let before = Unix.sigprocmask SIG_BLOCK [ Sys.sigint; Sys.sigterm ] in
  match Unix.fork () with
  | 0 ->
    of_child ();
    ignore (Unix.sigprocmask SIG_SETMASK before);
    Unix.close from;
    List.iter (fun w -> Unix.close w.from) others;
    (match labour ~jobs ~number ~first ~count ~work out with
     | () -> Unix._exit 0
     | exception e ->
       prerr_endline (Printexc.to_string e);
       Unix._exit 70)
  | pid ->
    ignore (Unix.sigprocmask SIG_SETMASK before);
    Unix.close out;
    { pid; from; channel = Unix.in_channel_of_descr from; status = None }

let rec waited w =
  match w.status with
  | Some status -> status
  | None -> (
      match Unix.waitpid [] w.pid with
      | _, status ->
        w.status <- Some status;
        status
      | exception Unix.Unix_error (EINTR, _, _) -> waited w)

let how : Unix.process_status -> string = function
  | WEXITED n -> Printf.sprintf "exit code %d" n
  | WSIGNALED n when n = Sys.sigkill -> "it was killed, as when memory runs out"
  | WSIGNALED n | WSTOPPED n -> Printf.sprintf "signal %d" n

(* An interruption is looked for a few times a second. *)
let rec ready w interrupted =
  if interrupted () then false
  else
    match Unix.select [ w.from ] [] [] 0.2 with
    | [], _, _ -> ready w interrupted
    | _ :: _, _, _ -> true
    | exception Unix.Unix_error (EINTR, _, _) -> ready w interrupted

let collect workers ~jobs ~first ~count ~interrupted ~each =
  let rec go k =
    if k >= count then Ok ()
    else
      let w = workers.((k - first) mod jobs) in
      if not (ready w interrupted) then Error Interrupted
      else
        match Marshal.from_channel w.channel with
        | found ->
          each k found;
          go (k + 1)
        | exception (End_of_file | Failure _) ->
          let how = how (waited w) in
          Error (if interrupted () then Interrupted else Lost { task = k; how })
  in
  go first

let finish workers =
  Array.iter
    (fun w ->
       if Option.is_none w.status then Unix.kill w.pid Sys.sigkill;
       close_in_noerr w.channel;
       ignore (waited w))
    workers

let run ~jobs ~first ~count ~work ~interrupted ~each =
  let jobs = Int.min jobs (count - first) in
  let rec start number found =
    if number >= jobs then List.rev found
    else start (number + 1) (fork ~jobs ~number ~first ~count ~work found :: found)
  in
  let workers = Array.of_list (start 0 []) in
  Fun.protect
    ~finally:(fun () -> finish workers)
    (fun () -> collect workers ~jobs ~first ~count ~interrupted ~each)
