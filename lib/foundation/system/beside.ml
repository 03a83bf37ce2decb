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

let labour work =
  match work () with
  | () -> Unix._exit 0
  | exception e ->
    Standard.complain (Printexc.to_string e ^ "\n");
    Unix._exit 70
