type t = Holds | Violated | Undecided | Invalid | Stopped | Usage | Bug

let to_int = function
  | Holds -> 0
  | Violated -> 1
  | Undecided -> 2
  | Invalid -> 3
  | Stopped -> 4
  | Usage -> 64
  | Bug -> 70

let rank = function
  | Holds -> 0
  | Undecided -> 1
  | Stopped -> 2
  | Violated -> 3
  | Invalid -> 4
  | Usage -> 5
  | Bug -> 6

let worst codes = List.fold_left (fun w c -> if rank c > rank w then c else w) Holds codes

let man =
  let info code doc = Cmdliner.Cmd.Exit.info (to_int code) ~doc in
  [
    info Holds "on success: every property holds, exhaustively or within bounds that the user gave.";
    info Violated "if some property is violated.";
    info Undecided "if something is undecided, or holds only up to a default bound that cut the run short.";
    info Invalid "if the model or another input is invalid.";
    info Stopped "if a limit of time or memory, or an interruption, stopped the run.";
    info Usage "if the command line is wrong.";
    info Bug "if scc itself is at fault: the message says what to send.";
  ]
