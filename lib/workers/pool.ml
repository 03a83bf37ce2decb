open Scc_system

type stop = Interrupted | Lost of { task : int; how : string }

type worker = { pid : int; from : Unix.file_descr; channel : in_channel; mutable status : Unix.process_status
                    option }

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

(* Without a parent a child ends when it tells of its next task; it leaves without what the parent would do at its
   end. *)
let fork ~jobs ~number ~first ~count ~work others =
  let from, out = Unix.pipe ~cloexec:true () in
  let child () =
    Sys.set_signal Sys.sigpipe Sys.Signal_default;
    Unix.close from;
    List.iter (fun w -> Unix.close w.from) others;
    match labour ~jobs ~number ~first ~count ~work out with
    | () -> Unix._exit 0
    | exception e ->
      Standard.complain (Printexc.to_string e ^ "\n");
      Unix._exit 70
  in
  match Interruption.fork child with
  | pid ->
    Unix.close out;
    { pid; from; channel = Unix.in_channel_of_descr from; status = None }
  | exception e ->
    List.iter Unix.close [ from; out ];
    raise e

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
