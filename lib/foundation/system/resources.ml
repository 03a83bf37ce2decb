let is_end_of ~whole text =
  let n = String.length text and k = String.length whole in
  n <= k && String.equal text (String.sub whole (k - n) n)

(* Files, processes and memory, of which there is another time more. *)
let lacking : Unix.error list = [ EMFILE; ENFILE; ENOMEM; EAGAIN; ENOBUFS ]

(* In the order of [scc_limit_in_bytes]. *)
type limit = Addresses | Data | Stack

external bytes_of : limit -> int = "scc_limit" [@@noalloc]

let limit which = match bytes_of which with n when n < 0 -> None | n -> Some n

(* What test/limits/deep.py runs everything with. *)
let enough_stack = 1048576

let least_of_memory () =
  match List.filter_map limit [ Addresses; Data ] with
  | [] -> None
  | first :: rest -> Some (List.fold_left Int.min first rest)

(* OCaml 5 takes the stack from the memory of the process, and earlier ones from its addresses. *)
let no_stack () =
  match (limit Stack, least_of_memory ()) with
  | Some bytes, _ when bytes < enough_stack ->
    let kib = bytes / 1024 in
    Some (Printf.sprintf "no stack left: the system sets this process a limit of %d KiB (ulimit -s)" kib)
  | _, Some bytes ->
    let mib = bytes / 1048576 in
    Some
      (Printf.sprintf
         "no stack left within the memory limit of %d MiB that the system sets this process (ulimit -v or -d)" mib)
  | _, None -> None

let refused = function
  | Unix.Unix_error (e, call, what) when List.mem e lacking ->
    Some (Printf.sprintf "%s (%s)" (Unix.error_message e) (if what = "" then call else call ^ " " ^ what))
  | Sys_error message when List.exists (fun e -> is_end_of ~whole:message (Unix.error_message e)) lacking ->
    Some message
  | Out_of_memory -> Some "no memory left"
  | Stack_overflow -> no_stack ()
  | _ -> None
