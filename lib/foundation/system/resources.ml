let is_end_of ~whole text =
  let n = String.length text and k = String.length whole in
  n <= k && String.equal text (String.sub whole (k - n) n)

(* Files, processes and memory, of which there is another time more. *)
let lacking : Unix.error list = [ EMFILE; ENFILE; ENOMEM; EAGAIN; ENOBUFS ]

let refused = function
  | Unix.Unix_error (e, call, what) when List.mem e lacking ->
    Some (Printf.sprintf "%s (%s)" (Unix.error_message e) (if what = "" then call else call ^ " " ^ what))
  | Sys_error message when List.exists (fun e -> is_end_of ~whole:message (Unix.error_message e)) lacking ->
    Some message
  | Out_of_memory -> Some "no memory left"
  | _ -> None
