(* A list of ranges, such as 0-3,8. *)
let count list =
  let range text =
    match List.map int_of_string_opt (String.split_on_char '-' (String.trim text)) with
    | [ Some _ ] -> 1
    | [ Some first; Some last ] -> last - first + 1
    | _ -> 0
  in
  List.fold_left (fun n text -> n + range text) 0 (String.split_on_char ',' list)

let field = "Cpus_allowed_list:"

let available () =
  let after line =
    let n = String.length field in
    if String.length line > n && String.equal (String.sub line 0 n) field then
      Some (String.sub line n (String.length line - n))
    else None
  in
  match open_in_bin "/proc/self/status" with
  | exception Sys_error _ -> 1
  | file ->
    let rec find () =
      match input_line file with
      | exception (End_of_file | Sys_error _) -> 1
      | line -> ( match after line with Some list -> Int.max 1 (count list) | None -> find ())
    in
    let n = find () in
    close_in_noerr file;
    n
