let rec selectable fd =
  match Unix.select [ fd ] [] [] 0. with
  | _ -> ()
  | exception Unix.Unix_error (EINTR, _, _) -> selectable fd

let fork pair start =
  match pair () with
  | exception Unix.Unix_error _ -> None
  | ours, theirs -> (
      match
        selectable ours;
        start ours theirs
      with
      | started ->
        Unix.close theirs;
        Some started
      | exception Unix.Unix_error _ ->
        List.iter Unix.close [ ours; theirs ];
        None)

(* {!Ending} ends the program with the same codes. *)
let stopped = 4
let bug = 70

let labour work =
  match work () with
  | () -> Unix._exit 0
  | exception e when Option.is_some (Resources.refused e) -> Unix._exit stopped
  | exception e ->
    (try Standard.complain ("scc: internal error: " ^ Printexc.to_string e ^ "\n") with _ -> ());
    Unix._exit bug
