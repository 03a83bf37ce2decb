open Scc_system

type stop = Interrupted | Lost of { task : int; how : string; fault : bool }

type worker = { pid : int; from : Unix.file_descr; mutable status : Unix.process_status option }
type 'a answer = Found of 'a | Raised of string | No_memory | Broken_off

(* A worker, or nobody where the system gives no process: then the tasks are worked on here. *)
type crew = { start : int -> worker list -> worker option; places : worker option array }

let most_deaths = 10

(* {1 There} *)

let told answer = Marshal.to_string answer []

(* What to tell of a task, and whether there may be more. *)
let answer ~obedient work k =
  let work k = if obedient then Interruption.at_once (fun () -> work k) else work k in
  match told (Found (work k)) with
  | text -> (text, not (obedient && Interruption.heard ()))
  | exception Out_of_memory -> (told No_memory, false)
  | exception Interruption.Interrupted _ when obedient -> (told Broken_off, false)
  | exception e -> (told (Raised (Printexc.to_string e)), false)

(* What is left to the child: its tasks, one after the other. *)
let rec labour ~obedient ~jobs ~count ~work channel k =
  if k < count then begin
    let text, more = answer ~obedient work k in
    output_string channel text;
    flush channel;
    if more then labour ~obedient ~jobs ~count ~work channel (k + jobs)
  end

(* {1 Here} *)

(* Without a parent a child ends when it tells of its next task. *)
let fork_with ~obedient others labour from out =
  let child () =
    Sys.set_signal Sys.sigpipe Sys.Signal_default;
    Unix.close from;
    List.iter (fun w -> Unix.close w.from) others;
    Beside.labour (fun () -> labour (Unix.out_channel_of_descr out))
  in
  let pid = Interruption.fork ~obedient child in
  { pid; from; status = None }

let fork ~obedient others labour =
  Beside.fork (fun () -> Unix.pipe ~cloexec:true ()) (fork_with ~obedient others labour)

let selected from seconds =
  match Unix.select [ from ] [] [] seconds with
  | found, _, _ -> found <> []
  | exception Unix.Unix_error (EINTR, _, _) -> false

let rec waited w =
  match w.status with
  | Some status -> status
  | None -> (
      match Unix.waitpid [] w.pid with
      | _, status ->
        w.status <- Some status;
        status
      | exception Unix.Unix_error (EINTR, _, _) -> waited w)

(* How it ended, and whether that is a fault of the program: without memory it ends with 4. *)
let how : Unix.process_status -> string * bool = function
  | WEXITED 4 -> ("had no memory left", false)
  | WEXITED n -> (Printf.sprintf "ended with exit code %d" n, true)
  | WSIGNALED n when n = Sys.sigkill -> ("was killed, as when memory runs out", false)
  | WSIGNALED n when n = Sys.sigabrt -> ("was aborted, as when memory runs out", false)
  | WSIGNALED n when n = Sys.sigsegv || n = Sys.sigbus -> ("ended with a wrong access to memory", true)
  | WSIGNALED n when List.mem n [ Sys.sigill; Sys.sigfpe; Sys.sigtrap; Sys.sigsys ] ->
    ("ended with a wrong instruction", true)
  | WSIGNALED _ | WSTOPPED _ -> ("was ended by a signal", false)

let lost task ~deaths (what, fault) =
  let how =
    if deaths = 1 then "the process that worked on it " ^ what
    else Printf.sprintf "%d processes in a row that worked on it came to an end; the last one %s" deaths what
  in
  Error (Lost { task; how; fault })

let failed task e =
  let how = "the work on it failed: " ^ e in
  Error (Lost { task; how; fault = true })

(* An interruption is looked for a few times a second. *)
let rec ready w interrupted = (not (interrupted ())) && (selected w.from 0.2 || ready w interrupted)

let finish w =
  if Option.is_none w.status then Unix.kill w.pid Sys.sigkill;
  Unix.close w.from;
  ignore (waited w)

let present crew = List.filter_map Fun.id (Array.to_list crew.places)
let dismiss crew = List.iter finish (present crew)

let rec fill fd bytes from =
  let left = Bytes.length bytes - from in
  left = 0
  ||
  match Unix.read fd bytes from left with
  | 0 -> false
  | n -> fill fd bytes (from + n)
  | exception Unix.Unix_error (EINTR, _, _) -> fill fd bytes from

(* Nothing is read beyond it, so that the descriptor is ready while there is another answer. *)
let read w : _ answer option =
  let header = Bytes.create Marshal.header_size in
  if not (fill w.from header 0) then None
  else
    let data = Bytes.create (Marshal.data_size header 0) in
    if fill w.from data 0 then Some (Marshal.from_bytes (Bytes.cat header data) 0) else None

let alone work k =
  match work k with
  | found -> Ok found
  | exception Out_of_memory -> Error (Lost { task = k; how = "there was no memory left for it"; fault = false })
  | exception e -> failed k (Printexc.to_string e)

(* What comes of a task, by those that are started for it one after the other. What has ended a process is not
   tried here. *)
let rec heard crew place ~interrupted ~work ~deaths k =
  if Option.is_none crew.places.(place) then crew.places.(place) <- crew.start k (present crew);
  match (crew.places.(place), deaths) with
  | None, [] -> if interrupted () then Error Interrupted else alone work k
  | None, last :: _ -> lost k ~deaths:(List.length deaths) last
  | Some w, _ when not (ready w interrupted) -> Error Interrupted
  | Some w, _ -> (
      match read w with
      | Some (Found found) -> Ok found
      | Some (Raised e) -> failed k e
      | Some Broken_off -> Error Interrupted
      | (Some No_memory | None) as answer ->
        let ended = if Option.is_none answer then how (waited w) else ("had no memory left", false) in
        let deaths = ended :: deaths in
        finish w;
        crew.places.(place) <- None;
        if interrupted () then Error Interrupted
        else if List.length deaths >= most_deaths then lost k ~deaths:most_deaths ended
        else heard crew place ~interrupted ~work ~deaths k)

(* What the tasks have come to on which somebody works, up to the first of which nothing is heard in time. *)
let hear_out crew ~first ~patience ~each =
  let until = Unix.gettimeofday () +. patience in
  let rec ready w =
    let left = until -. Unix.gettimeofday () in
    left > 0. && (selected w.from left || ready w)
  in
  let rec go k =
    match crew.places.((k - first) mod Array.length crew.places) with
    | Some w when ready w -> (
        match read w with
        | Some (Found found) ->
          each k found;
          go (k + 1)
        | Some (Raised _ | No_memory | Broken_off) | None -> ())
    | Some _ | None -> ()
  in
  List.iter (fun w -> if Option.is_none w.status then Unix.kill w.pid Interruption.request) (present crew);
  go

(* As many as the system gives; a place for one at least. *)
let rec gathered ~obedient ~jobs ~first ~count ~work =
  let labour k channel = labour ~obedient ~jobs ~count ~work channel k in
  let start k others = fork ~obedient others (labour k) in
  let rec go number found =
    if number >= jobs then List.rev found
    else match start (first + number) found with None -> List.rev found | Some w -> go (number + 1) (w :: found)
  in
  match go 0 [] with
  | found when List.length found < jobs && jobs > 1 ->
    List.iter finish found;
    gathered ~obedient ~jobs:(Int.max 1 (List.length found)) ~first ~count ~work
  | [] -> { start; places = [| None |] }
  | found -> { start; places = Array.of_list (List.map Option.some found) }

let run ?patience ~jobs ~first ~count ~work ~interrupted ~each () =
  let obedient = Option.is_some patience in
  let crew = gathered ~obedient ~jobs:(Int.min jobs (count - first)) ~first ~count ~work in
  let rec go k =
    if k >= count then Ok ()
    else
      let place = (k - first) mod Array.length crew.places in
      match heard crew place ~interrupted ~work ~deaths:[] k with
      | Ok found ->
        each k found;
        go (k + 1)
      | Error Interrupted as stop ->
        Option.iter (fun patience -> hear_out crew ~first ~patience ~each k) patience;
        stop
      | Error (Lost _) as stop -> stop
  in
  Fun.protect ~finally:(fun () -> dismiss crew) (fun () -> go first)
